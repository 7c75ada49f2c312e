// SPDX-License-Identifier: Apache-2.0
// A piece of what a machine's joints do as a segment, and as stretches for the feed.
#pragma once

#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// Makes the segment of moves[index], a series of the joints in one step, in units, from `path` on
/// (units, program-wide; moved to the piece's end); its length may be 0 quanta.
Segment joint_segment(const Program& program, std::size_t index, const PlanOptions& options,
                      long double& path);

/// Makes the stretches of a piece with this segment, in order.
std::vector<PlannedMove> joint_stretches(const Program& program, const Machine& machine,
                                         const Segment& segment, double unit_mm);

}  // namespace curvecore::ref
