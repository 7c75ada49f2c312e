// SPDX-License-Identifier: Apache-2.0
// A cubic move as segments, and as stretches for the feed.
#pragma once

#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// Makes segments of the cubic moves[index], in units, from `path` on (units, program-wide; moved
/// to the move's end). A standstill of the curve is the end of a segment.
/// @param fastest mm/s, upper limit of the move: its last steps are long enough for it
/// @throws std::domain_error when the words cannot carry the move
std::vector<Segment> spline_segments(const Program& program, std::size_t index,
                                     const PlanOptions& options, double fastest, long double& path);

/// Makes a cubic's stretches from its segments, in order; each lies within one segment and has its
/// share of the segment's integration steps.
std::vector<PlannedMove> spline_stretches(const Program& program, const Machine& machine,
                                          const Segment* segments, std::size_t count,
                                          double unit_mm);

/// Returns true if the move can be carried with other words or another unit.
bool spline_fits(const Program& program, std::size_t index, PlanOptions options,
                 const CoreParameters& format, double unit_mm);

}  // namespace curvecore::ref
