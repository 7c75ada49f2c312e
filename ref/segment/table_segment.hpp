// SPDX-License-Identifier: Apache-2.0
// Pieces of a table's curve that a core can draw.
#pragma once

#include <vector>

#include "ref/curve/drawn/table_curve.hpp"
#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// Cuts a curve, in length units, into segments whose derived bound (ref/bound/table_bound.hpp)
/// keeps half of the limit, so that two samples' distance keeps the limit, and whose rows keep
/// their range; with a least_last_step(), units, some more of them (ref/segment/last_step.hpp).
/// Fields that it sets: start, end, curve, step_exponent, bound, and length, each rounded by
/// itself. Auxiliary axes stand still.
/// @throws std::domain_error if there are no such steps, or if they are so short that more than 512
/// segments would be needed
std::vector<Segment> cut_table(const TableCurve& curve, const PlanOptions& options,
                               double least_last_step = 0);

}  // namespace curvecore::ref
