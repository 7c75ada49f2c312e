// SPDX-License-Identifier: Apache-2.0
// Moves to segments: cut so that every derived error bound holds, with exact path bookkeeping.
#pragma once

#include "ref/plan/path_shape.hpp"
#include "ref/plan/planner.hpp"

namespace curvecore::ref {

/// A move that has a length, and its segments.
struct PlannedMove {
    std::size_t move = 0;  // index into Program::moves
    PathShape shape;
    std::size_t first_segment = 0;
    std::size_t segments = 0;
    std::uint64_t length = 0;  // quanta
    double steps = 0;          // integration steps in all
};

struct Geometry {
    std::vector<Segment> segments;
    std::vector<PlannedMove> moves;
};

/// Path length is summed in long double; what a segment gets is the difference of two rounded sums,
/// so rounding does not add up. Moves shorter than a quantum make no segment.
///
/// @throws InputError: beyond the machine's travel or the position words, more auxiliary axes than
///         the core has, an arc that misses its end point, a bound that no cut can meet.
Geometry make_geometry(const Program& program, const Machine& machine, const PlanOptions& options);

}  // namespace curvecore::ref
