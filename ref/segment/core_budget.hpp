// SPDX-License-Identifier: Apache-2.0
// The time in which a core makes its integration steps, between its samples.
#pragma once

#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// The time of the samples that a core is ahead of the one that is due, s.
double window_of(const PlanOptions& options);

/// Time of such a window that its samples leave for starts of steps and segments, s.
double budget_of(const PlanOptions& options);

/// Seconds from one change to the next that step_speeds() (ref/feed/places/step_speed.hpp) may
/// need, so that two changes with little path between slow their whole move; 0: the core makes
/// several in the time of the samples that it is ahead.
double two_changes_time(const PlanOptions& options);

}  // namespace curvecore::ref
