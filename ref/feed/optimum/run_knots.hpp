// SPDX-License-Identifier: Apache-2.0
// Knots for an optimum, laid on a motion that is known.
#pragma once

#include <cstddef>
#include <vector>

#include "ref/feed/ramps/speed_plan.hpp"

namespace curvecore::ref {

/// What one planned move of a run may have besides the machine's limits.
struct RunMove {
    std::size_t planned = 0;  // index into Geometry::moves
    double length = 0;        // mm
    double velocity = 0;      // mm/s, on it
    bool slow_axes = false;   // what these allow at its places counts besides
    double end_velocity = 0;  // at its end, where the next one begins
    double jerk = 0;          // mm/s^3, that its pieces can carry
    double step = 0;          // s, between knots
    double widest = 1;        // steps between knots where the speed is constant
};

struct RunKnot {
    long double s = 0;
    double v = 0;
    double a = 0;
};

/// In order: the start, joints of moves, and between them their steps of the motion apart, farther
/// where its speed is constant; none so near to the one before that it would be a sliver; the end.
std::vector<RunKnot> run_knots(const std::vector<Phase>& phases, const std::vector<RunMove>& moves);

}  // namespace curvecore::ref
