// SPDX-License-Identifier: Apache-2.0
// The planner's time for a move of CAM: a 3D surface in chords of 0.2 mm, as a stream.
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <optional>

#include "ref/feed/plan_stream.hpp"
#include "ref/moves/moves_ahead.hpp"
#include "ref/numeric/newton_work.hpp"
#include "ref/path/smooth_stream.hpp"
#include "ref/segment/spline_cut.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/bench/surface.hpp"

namespace {

using namespace curvecore::ref;

using curvecore::tb::Surface;

constexpr double kChord = 0.2;        // mm
constexpr std::size_t kAhead = 2000;  // moves, as sysc/job/job_stream.cpp

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

curvecore::tb::Cells row(std::size_t moves, const char* name, Effort effort) {
    const Machine machine;
    Surface surface(moves, kChord);
    SmoothStream smooth([&](Move& move) { return surface.next(move); }, machine);
    double smoothing = 0;
    const auto source = [&](Move& move) {
        const double from = seconds();
        const bool more = smooth.next(move);
        smoothing += seconds() - from;
        return more;
    };
    PlanOptions options;
    options.effort = effort;
    options.format.splines = 1;
    options.segment_queue_words = kBoardSegmentWords;
    newton_work() = 0;
    const double from = seconds();
    PlanStream stream(source, {"surface", 0, Surface::kFeed}, machine, options);
    double duration = 0;
    while (const std::optional<Plan> plan = stream.next()) duration += plan->duration_s;
    const double all = seconds() - from;
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    const auto a_move = [&](double time) { return 1e6 * time / static_cast<double>(moves); };
    return {std::to_string(moves),
            name,
            fmt::format("{:.1f}", a_move(all)),
            fmt::format("{:.1f}", a_move(smoothing)),
            fmt::format("{:.1f}", duration),
            fmt::format("{:.0f}", static_cast<double>(newton_work()) / duration),
            std::to_string(use.ru_maxrss / 1024)};
}

/// The time, by the clock on the wall, with so many threads, and how many times less it is than by
/// one.
curvecore::tb::Cells threads_row(std::size_t moves, int threads, double& one) {
    using Clock = std::chrono::steady_clock;
    const Machine machine;
    Surface surface(moves, kChord);
    PlanOptions options;
    options.format.splines = 1;
    options.segment_queue_words = kBoardSegmentWords;
    options.cuts = std::make_shared<KnownCuts>();
    if (threads > 1) options.workers = std::make_shared<Workers>(threads);
    SmoothStream smooth([&](Move& move) { return surface.next(move); }, machine);
    const Events none;
    std::optional<MovesAhead> ahead;
    const MoveSource read = [&](Move& move) { return smooth.next(move); };
    if (threads > 1) {
        ahead.emplace(
            read, [&]() -> const Events& { return none; }, options.workers, kAhead);
    }
    const Clock::time_point from = Clock::now();
    PlanStream stream([&](Move& move) { return ahead ? ahead->next(move) : read(move); },
                      {"surface", 0, Surface::kFeed}, machine, options);
    while (stream.next()) {
    }
    const double time = std::chrono::duration<double>(Clock::now() - from).count();
    if (threads == 1) one = time;
    return {std::to_string(threads), fmt::format("{:.1f}", 1e6 * time / static_cast<double>(moves)),
            fmt::format("{:.2f}", one / time)};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("the planner's time for a move");
    std::string output;
    app.add_option("-o", output, "also as JSON")->type_name("FILE");
    CLI11_PARSE(app, argc, argv);
    curvecore::tb::Table efforts{"planner_effort",
                                 "A 3D surface in chords of 0.2 mm, smoothed within 0.01 mm, "
                                 "planned as a stream in one thread",
                                 {"moves", "effort", "us a move", "of it smoothing", "motion, s",
                                  "Newton steps x knots a s of it", "most memory so far, MB"},
                                 {}};
    for (const std::size_t moves : {10000, 100000}) {
        efforts.rows.push_back(row(moves, "rules", Effort::kRules));
        efforts.rows.push_back(row(moves, "optimum", Effort::kOptimum));
    }
    curvecore::tb::Table threads{"planner_threads",
                                 "The same surface, 50,000 moves, the optimum, on two cores",
                                 {"threads", "us a move, on the wall", "times as fast as one"},
                                 {}};
    double one = 0;
    for (const int count : {1, 2, 4}) threads.rows.push_back(threads_row(50000, count, one));
    curvecore::tb::print(efforts);
    curvecore::tb::print(threads);
    return curvecore::tb::write_tables({efforts, threads}, output);
}
