// SPDX-License-Identifier: Apache-2.0
// Prints the CPU time of planning a chord of a 3D surface, and what is planned. It takes from `ref`
// what older trees have, too: scripts/person_runs.py builds it in one of them, to compare.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>
#include <optional>

#include "ref/feed/plan_stream.hpp"
#include "ref/path/smooth_stream.hpp"

namespace {

using namespace curvecore::ref;

constexpr double kRow = 100;    // mm
constexpr double kApart = 0.5;  // mm: distance of rows
constexpr double kFeed = 100;   // mm/s

/// Rows to and fro over y, z = f(x, y).
class Surface {
  public:
    Surface(std::size_t chords, double chord)
        : chords_(chords), chord_(chord), row_(static_cast<std::size_t>(kRow / chord)) {}

    bool next(Move& move) {
        if (made_ == chords_) return false;
        move = Move();
        move.feed = kFeed;
        move.tolerance = 0.01;
        move.start = at(made_);
        move.end = at(++made_);
        return true;
    }

  private:
    Vec3 at(std::size_t place) const {
        const std::size_t row = place / (row_ + 1);
        const std::size_t chord = place % (row_ + 1);
        const double x = chord_ * static_cast<double>(row % 2 == 0 ? chord : row_ - chord);
        const double y = kApart * static_cast<double>(row);
        return {x, y, 3 * std::sin(x / 7) * std::cos(y / 9) + 1.5 * std::sin(x / 2.5 + y / 4)};
    }

    std::size_t chords_;
    double chord_;  // mm
    std::size_t row_;
    std::size_t made_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("what planning a surface costs");
    std::size_t chords = 20000;
    double chord = 0.2;
    app.add_option("--chords", chords, "how many");
    app.add_option("--chord", chord, "length of each")->type_name("MM");
    CLI11_PARSE(app, argc, argv);
    const Machine machine;
    Surface surface(chords, chord);
    SmoothStream smooth([&](Move& move) { return surface.next(move); }, machine);
    PlanOptions options;
    options.format.splines = 1;
    options.segment_queue_words = 65536;
    options.profile_queue_words = 4096;
    double duration = 0;
    const std::clock_t from = std::clock();
    PlanStream stream([&](Move& move) { return smooth.next(move); }, {"surface", 0, kFeed}, machine,
                      options);
    while (const std::optional<Plan> plan = stream.next()) duration += plan->duration_s;
    const double time = static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
    fmt::print(
        "{{\"chord_mm\": {}, \"chords\": {}, \"us_a_chord\": {:.2f}, \"motion_s\": {:.3f}}}\n",
        chord, chords, 1e6 * time / static_cast<double>(chords), duration);
}
