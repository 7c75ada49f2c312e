// SPDX-License-Identifier: Apache-2.0
// Knots for an optimum, laid on a known motion.
#pragma once

#include <cstddef>
#include <vector>

#include "ref/feed/ramps/zone_ramps.hpp"

namespace curvecore::ref {

/// Limits of one planned move of a run besides the machine's.
struct RunMove {
    std::size_t planned = 0;  // index into Geometry::moves
    double length = 0;        // mm
    double velocity = 0;      // mm/s, limit on it
    bool slow_axes = false;   // the limits of slow axes at its places count besides
    double end_velocity = 0;  // mm/s, limit at its end, where the next one begins
    double jerk = 0;          // mm/s^3, limit of its pieces
    double step = 0;          // s, between knots
    double widest = 1;        // steps between knots where the speed is constant
};

struct RunKnot {
    long double s = 0;
    double v = 0;
    double a = 0;
};

/// Returns, in order: the start, joints of moves, between them knots at their steps of the motion,
/// farther apart where its speed is constant and none so near to the one before that it would be a
/// sliver; the end.
std::vector<RunKnot> run_knots(const std::vector<Phase>& phases, const std::vector<RunMove>& moves);

}  // namespace curvecore::ref
