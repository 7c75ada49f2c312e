// SPDX-License-Identifier: Apache-2.0
// A move along a table's curve as segments, and as stretches for the feed.
#pragma once

#include "ref/curve/drawn/table_curve.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// Makes segments of the curve of moves[index], in units, from `path` on (units, program-wide;
/// moved to the move's end).
/// @param fastest mm/s, upper limit of the move: its last steps are long enough for it
/// @throws std::domain_error when the words cannot carry the move
std::vector<Segment> table_segments(const Program& program, std::size_t index,
                                    const PlanOptions& options, double fastest, long double& path);

/// Makes its stretches, in order, with their shares of the segments' integration steps.
std::vector<PlannedMove> table_stretches(const Program& program, const Machine& machine,
                                         const Segment* segments, std::size_t count,
                                         double unit_mm);

}  // namespace curvecore::ref
