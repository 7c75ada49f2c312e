// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/clock_need.hpp"

#include <algorithm>
#include <cmath>

#include "tb/support/serial_clocks.hpp"

namespace curvecore::tb {
namespace {

ClockNeed serial_need(const CoreParameters& parameters, const Load& load, bool splines,
                      double period) {
    const SerialClocks clocks =
        serial_clocks(parameters.order, parameters.aux_axes, parameters.mode == 0, splines);
    const double segments = std::ceil(load.segments * period);
    const double steps = std::ceil(load.steps * period);
    const double pauses = segments * clocks.segment + std::max(0.0, steps - segments) * clocks.step;
    const int latency = splines ? parameters.spline_latency() : parameters.network_latency();
    return {clocks.sample / period,
            std::max((clocks.sample + pauses) / period, load.steps * latency)};
}

ClockNeed parallel_need(const CoreParameters& parameters, const Load& load, bool splines,
                        double period) {
    const int latency = splines ? parameters.spline_latency() : parameters.network_latency();
    const double words = 20 + 3 * parameters.aux_axes;
    return {parameters.sample_interval / period,
            std::max(load.steps * latency, load.segments * words)};
}

}  // namespace

ClockNeed clock_need(const CoreParameters& parameters, const Demand& demand,
                     double sample_period_s) {
    ClockNeed need;
    for (const bool splines : {false, true}) {
        const Load& load = splines ? demand.splines : demand.arcs;
        if (load.segments == 0) continue;
        const ClockNeed one = parameters.build == Build::kSerial
                                  ? serial_need(parameters, load, splines, sample_period_s)
                                  : parallel_need(parameters, load, splines, sample_period_s);
        need.samples = std::max(need.samples, one.samples);
        need.steps = std::max(need.steps, one.steps);
    }
    return need;
}

}  // namespace curvecore::tb
