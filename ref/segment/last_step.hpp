// SPDX-License-Identifier: Apache-2.0
// The last step of a segment is what its length leaves. Where that is next to nothing the next
// segment follows at once, and a core that has no time for both holds the path up there. So such
// segments are cut elsewhere.
#pragma once

#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// How much path, units, a segment's last step must have so that the core makes it, and the next
/// segment's first, at this speed (mm/s); 0: any.
double least_last_step(double speed, const PlanOptions& options);

/// Where to cut a segment of `length` units, drawn in steps of 2^step_exponent, whose last step is
/// shorter than `least` and than half a step: half a step before that one begins. Both parts then
/// end with half a step or more. Units from its start; 0: nowhere.
double cut_for_last_step(double length, int step_exponent, double least);

}  // namespace curvecore::ref
