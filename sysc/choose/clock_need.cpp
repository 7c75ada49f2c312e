// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/clock_need.hpp"

#include <algorithm>
#include <cmath>

#include "sysc/core/core_clocks.hpp"

namespace curvecore::sysc {
namespace {

ClockNeed need_in_turn(const CoreParameters& parameters, const Load& load, ref::CurveKind kind,
                       double period) {
    const hls::Clocks change = change_clocks(parameters, kind);
    const double sample = change.sample + tick_share(parameters, 1);
    const double window = (1 + hls::samples_ahead(timed_core(parameters))) * period;
    const double segments = std::ceil(load.segments * window);
    const double steps = std::ceil(load.steps * window);
    const double pauses = segments * change.segment + std::max(0.0, steps - segments) * change.step;
    return {sample / period, sample / period + pauses / window};
}

ClockNeed parallel_need(const CoreParameters& parameters, const Load& load, ref::CurveKind kind,
                        double period) {
    return {parameters.sample_interval / period,
            std::max(load.steps * core_clocks(parameters, kind).step,
                     load.segments * hls::load_clocks(timed_core(parameters)))};
}

}  // namespace

ClockNeed clock_need(const CoreParameters& parameters, const Demand& demand,
                     double sample_period_s) {
    ClockNeed need;
    need.samples = hls::tick_clocks(timed_core(parameters)) / sample_period_s;
    const auto add = [&](ref::CurveKind kind, const Load& load) {
        if (load.segments == 0) return;
        const ClockNeed one = hls::in_turn(parameters.build)
                                  ? need_in_turn(parameters, load, kind, sample_period_s)
                                  : parallel_need(parameters, load, kind, sample_period_s);
        need.samples = std::max(need.samples, one.samples);
        need.steps = std::max(need.steps, one.steps);
    };
    add(ref::CurveKind::kArc, demand.arcs);
    add(ref::CurveKind::kSpline, demand.splines);
    return need;
}

}  // namespace curvecore::sysc
