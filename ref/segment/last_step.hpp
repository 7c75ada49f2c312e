// SPDX-License-Identifier: Apache-2.0
// The last step of a segment is the rest of its length. If that is next to nothing, the next
// segment follows at once, and a core that has no time for both delays the path there. Such
// segments are cut elsewhere.
#pragma once

#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// Path, units, that a segment's last step needs at this speed (mm/s) so that the core makes it and
/// the next segment's first; 0: any.
double least_last_step(double speed, const PlanOptions& options);

/// Place to cut a segment of `length` units, drawn in steps of 2^step_exponent, whose last step is
/// shorter than `least` and than half a step: half a step before that one begins. Both parts then
/// end with half a step or more. Units from its start; 0: nowhere.
double cut_for_last_step(double length, int step_exponent, double least);

}  // namespace curvecore::ref
