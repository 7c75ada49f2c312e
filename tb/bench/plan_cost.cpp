// SPDX-License-Identifier: Apache-2.0
// Prints the CPU time of planning a chord of a 3D surface, and what is planned. It takes from `ref`
// what older trees have, too: scripts/person.sh builds it in one of them, to compare.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <optional>

#include "ref/feed/plan_stream.hpp"
#include "ref/path/smooth_stream.hpp"
#include "tb/bench/surface.hpp"

using namespace curvecore::ref;
using curvecore::tb::Surface;

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
    PlanStream stream([&](Move& move) { return smooth.next(move); }, {"surface", 0, Surface::kFeed},
                      machine, options);
    while (const std::optional<Plan> plan = stream.next()) duration += plan->duration_s;
    const double time = static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
    fmt::print(
        "{{\"chord_mm\": {}, \"chords\": {}, \"us_a_chord\": {:.2f}, \"motion_s\": {:.3f}}}\n",
        chord, chords, 1e6 * time / static_cast<double>(chords), duration);
}
