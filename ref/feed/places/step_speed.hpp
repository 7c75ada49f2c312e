// SPDX-License-Identifier: Apache-2.0
// Path speeds at which a core has every integration step ready in time.
#pragma once

#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// Returns the highest speeds, mm/s, one per planned move.
///
/// A change is the start of a step or a segment, and costs its CoreTime. Steps that are made
/// ahead (step j while samples are taken from step j - 1) must keep pace with the path: from the
/// start of step j to that of a later step q pass at least the costs of j + 1 .. q, unless the
/// costs of j .. q fit into one sample period. Steps that are made in turn with the samples must
/// fit between them: in any 1 + samples_ahead sample periods the samples and the changes take no
/// longer than these periods; what a single sample is late by comes from those made ahead.
///
/// @throws std::invalid_argument: a change alone takes longer than that
std::vector<double> step_speeds(const std::vector<Segment>& segments,
                                const std::vector<PlannedMove>& moves, const PlanOptions& options);

}  // namespace curvecore::ref
