// SPDX-License-Identifier: Apache-2.0
// Clocks of a core (hls/clocks.hpp) for planning.
#pragma once

#include "hls/clocks.hpp"
#include "ref/segment/plan_options.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

hls::TimedCore timed_core(const CoreParameters& parameters);

/// Clocks of steps along a curve.
hls::Clocks core_clocks(const CoreParameters& parameters, ref::CurveKind kind);

/// Clocks by which the start of a step, or of a segment, delays the next sample beyond a sample's
/// own clocks; for the parallel build, those that it takes beside the samples.
hls::Clocks change_clocks(const CoreParameters& parameters, ref::CurveKind kind);

/// Clocks that ticks of time add to each of the samples of a window of those made ahead: of the
/// engine, which makes them in turn with samples.
double tick_share(const CoreParameters& parameters, int samples_per_tick);

/// The change clocks in seconds.
ref::CoreTime core_time(const CoreParameters& parameters, double clock_hz,
                        int samples_per_tick = 1);

/// Least number of clocks in a sample period with which any program keeps time, however slow it is.
double least_period_clocks(const CoreParameters& parameters, bool splines,
                           int samples_per_tick = 1);

/// @throws UsageError if the period is shorter than least_period_clocks()
void check_period(const CoreParameters& parameters, bool splines, double period_s, double clock_hz,
                  int samples_per_tick = 1);

}  // namespace curvecore::sysc
