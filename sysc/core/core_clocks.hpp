// SPDX-License-Identifier: Apache-2.0
// A core's clocks (hls/clocks.hpp) for whoever plans for it.
#pragma once

#include "hls/clocks.hpp"
#include "ref/segment/plan_options.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

hls::TimedCore timed_core(const CoreParameters& parameters);

/// Of steps along arcs and lines, or along splines.
hls::Clocks core_clocks(const CoreParameters& parameters, bool spline);

/// Clocks by which the start of a step, or of a segment, keeps the next sample waiting beyond a
/// sample's own; of the parallel build those that it takes beside the samples.
hls::Clocks change_clocks(const CoreParameters& parameters, bool spline);

/// The same in seconds.
ref::CoreTime core_time(const CoreParameters& parameters, double clock_hz);

/// Fewest clocks in a sample period with which a program can keep time, however slow it is.
double least_period_clocks(const CoreParameters& parameters, bool splines,
                           int samples_per_tick = 1);

/// @throws UsageError: the period is shorter than that
void check_period(const CoreParameters& parameters, bool splines, double period_s, double clock_hz,
                  int samples_per_tick = 1);

}  // namespace curvecore::sysc
