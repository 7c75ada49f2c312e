// SPDX-License-Identifier: Apache-2.0
// The programmed path made smooth within its tolerance (G64 P): corners are rounded, chains of
// short moves become curves, steps of curvature become ramps.
#pragma once

#include <cstddef>

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

constexpr double kExactDeviation = 1e-6;  // mm: what the exact path may be off by

struct Smoothed {
    std::size_t moves = 0;    // of the program, before
    std::size_t corners = 0;  // rounded by a cubic each
    std::size_t curves = 0;   // chains of cubics, C2
    std::size_t cubics = 0;   // in them
    double tolerance = 0;     // mm, the largest that the program allows
    double deviation = 0;     // mm, the largest bound
    double share = 0;         // of the tolerance, or of kExactDeviation, the largest
    int line = 0;             // where the share is largest
};

/// Lines and arcs with a tolerance and without auxiliary axes are drawn anew where their path or
/// its curvature jumps; what lies between stays exactly as it is. Splines stay. Rapids and feeds
/// are not joined with one another. Reversals (turns beyond 150 degrees), exact stops and ends of
/// what is smoothed stay where they are.
///
/// A move's `deviation` is then a bound of the distance between the drawn and the programmed path,
/// both ways; it is at most its tolerance. The machine's limits decide where cubics end, not what
/// they keep. `share` of each tolerance is used.
Smoothed smooth_path(Program& program, const Machine& machine, double share = 1);

/// Counts one drawn move in.
void look_at(const Move& move, Smoothed& smoothed);

}  // namespace curvecore::ref
