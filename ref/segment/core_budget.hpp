// SPDX-License-Identifier: Apache-2.0
// The time in which a core makes its integration steps, and what the samples leave of it.
#pragma once

#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// The time of the samples that a core is ahead of the one that is due, s.
double window_of(const PlanOptions& options);

/// What the samples of such a window leave of it for starts of steps and segments, s.
double budget_of(const PlanOptions& options);

/// Seconds that step_speeds() (ref/feed/places/step_speed.hpp) may want from one change to the
/// next, so that a change between which there is little path slows all of its move; 0: the core
/// makes several in the time of the samples that it is ahead.
double two_changes_time(const PlanOptions& options);

}  // namespace curvecore::ref
