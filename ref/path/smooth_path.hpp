// SPDX-License-Identifier: Apache-2.0
// The programmed path made smooth within its tolerance (G64 P): corners are rounded, chains of
// short moves become curves, steps of curvature become ramps.
#pragma once

#include <cstddef>

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

constexpr double kExactDeviation = 1e-6;  // mm: error of the exact path

struct Smoothed {
    std::size_t moves = 0;    // moves of the program before smoothing
    std::size_t corners = 0;  // corners rounded by a cubic each
    std::size_t curves = 0;   // chains of cubics, C2
    std::size_t cubics = 0;   // cubics in them
    double tolerance = 0;     // mm, the program's largest
    double deviation = 0;     // mm, the largest bound
    double share = 0;         // largest share of the tolerance, or of kExactDeviation
    int line = 0;             // line of the largest share
};

/// Redraws lines and arcs with a tolerance and without auxiliary axes where their path or its
/// curvature jumps; the path between stays exactly. Splines stay. Rapids and feeds are not joined
/// with one another. Reversals (turns beyond 150 degrees), exact stops and the ends of groups stay
/// in place.
///
/// A move's `deviation` is then a bound of the distance between the drawn and the programmed path,
/// both ways; it is at most its tolerance. The machine's limits decide where cubics end, not their
/// tolerance. `share` of each tolerance is used.
Smoothed smooth_path(Program& program, const Machine& machine, double share = 1);

/// Adds a drawn move to the counts.
void look_at(const Move& move, Smoothed& smoothed);

}  // namespace curvecore::ref
