// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/core_slowed.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/places/step_speed.hpp"
#include "ref/format/path_words.hpp"
#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

// Least share of the core's speed that a move has on the mean: below it something else slows it
// more.
constexpr double kReached = 0.8;

/// The path's speed limit where the speed is constant, mm/s.
double allowed(const Move& move, const PathShape& shape, const Machine& machine) {
    double v = highest_speed(shape, machine);
    if (!move.rapid && move.feed > 0) v = std::min(v, move.feed / shape.rate);
    if (shape.tool) return std::min(v, top_speed(shape, machine));
    if (shape.curvature == 0) return v;
    return std::min({v, std::sqrt(machine.acceleration / shape.curvature),
                     std::cbrt(machine.jerk / (shape.curvature * shape.twist + shape.swerve))});
}

}  // namespace

CoreSlowed core_slowed(const FeedTask& task, const WindowMotion& motion, std::size_t first,
                       std::size_t end, std::size_t dropped) {
    const Machine& machine = task.machine;
    const std::vector<PlannedMove>& moves = task.geometry.moves;
    const std::vector<double> core = step_speeds(task.geometry.segments, moves, task.options);
    CoreSlowed slowed;
    double slowest = 0;  // mm/s, largest loss in this row of slowed moves
    for (std::size_t i = first; i < end; ++i) {
        const Move& move = task.program.moves[moves[i].move - dropped];
        const double asked = allowed(move, moves[i].shape, machine);
        const double length =
            static_cast<double>(moves[i].length) * kQuantum * task.options.unit_mm;
        const bool ends = i + 1 == end || moves[i + 1].move != moves[i].move;
        const double time =
            motion.times()[i + 1] - motion.times()[i] - (ends ? move.dwell : 0);  // s
        if (core[i] >= asked || length < kReached * core[i] * time) {
            slowest = 0;
            continue;
        }
        double lost = length / core[i] - length / asked;
        const double slower = asked - core[i];
        if (slower > slowest) {
            const double from = slower - slowest;
            const double ramp = from / machine.acceleration + machine.acceleration / machine.jerk;
            lost += ramp * from / asked;
            slowest = slower;
        }
        slowed.add({1, lost, move.line, lost, core[i], asked});
    }
    return slowed;
}

}  // namespace curvecore::ref
