// SPDX-License-Identifier: Apache-2.0
// Moves cut to segments so that every derived error bound holds, with exact path bookkeeping.
#pragma once

#include <cstdint>

#include "ref/limits/path_shape.hpp"
#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

constexpr int kMaxSteps = 1 << 12;  // steps of one segment of an arc or a line

/// A line that has a length, or a stretch of an arc or of a spline.
struct PlannedMove {
    std::size_t move = 0;  // index into Program::moves
    PathShape shape;
    std::uint64_t length = 0;  // quanta
    double steps = 0;          // integration steps in all
    bool stop_before = false;  // the curve stands still at the start
    bool stop_after = false;   // or at its end
    double miss = 0;           // quanta of path before it that rounding has left out
};

struct Geometry {
    std::vector<Segment> segments;
    std::vector<PlannedMove> moves;
};

/// Makes segments from moves, and stretches for the feed. Path length is summed in long double; a
/// segment's length is the difference of two rounded sums, so rounding does not add up. Moves
/// shorter than a quantum make no segment; a line longer than a segment's length word is cut
/// (ref/format/path_words.hpp).
///
/// @throws InputError: beyond the machine's travel or the position words, more auxiliary axes than
///         the core has or faster along a spline than the words hold, an arc that misses its end
///         point, a bound that no cut can meet, a path beyond the program's words.
/// @param miss PlannedMove::miss of the first move
/// @param most number of planned moves or segments that suffices: later moves are left out
Geometry make_geometry(const Program& program, const Machine& machine, const PlanOptions& options,
                       double miss = 0, std::size_t most = SIZE_MAX);

}  // namespace curvecore::ref
