// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/clock_need.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::tb {
namespace {

/// rtl/curve_interpolator_serial.sv.
struct SerialClocks {
    double sample, step, segment;

    SerialClocks(const CoreParameters& parameters, bool splines) {
        const int order = parameters.order;
        const int aux = parameters.aux_axes;
        const int groups = (aux + 2) / 3;
        const bool series = parameters.mode == 0;
        const int frames = (series ? order : splines ? order + 3 : 4 + order / 2) + groups;
        sample = std::max({9 * (1 + groups), 3 * (frames + 5), 24});
        if (splines) {
            const int own = series ? 3 * order * (order + 11) / 2 : 0;
            step = 4 * order * order + 39 * order + 9 * frames + 120 + own;
            segment = 4 * order * order + 37 * order + 9 * frames + 3 * aux + 162 + own;
        } else {
            step = 15 * order + 9 * frames + 84;
            segment = 27 * order + 9 * frames + 3 * aux + 66 + (series ? 0 : 11 * order + 24);
        }
    }
};

ClockNeed serial_need(const CoreParameters& parameters, const Load& load, bool splines,
                      double period) {
    const SerialClocks clocks(parameters, splines);
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
