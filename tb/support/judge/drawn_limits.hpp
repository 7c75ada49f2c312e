// SPDX-License-Identifier: Apache-2.0
// Limits of a plan's motion as the hardware's own increments draw it.
#pragma once

#include <fmt/format.h>

#include "ref/plan/curve_follower.hpp"
#include "ref/segment/plan_options.hpp"
#include "sysc/watch/limit_meter.hpp"
#include "sysc/words/path_cursor.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::tb {

/// Windows of the report and further ones between.
inline const std::vector<double> kManyWindows{
    1e-3,   1.2e-3, 1.4e-3, 1.7e-3, 2e-3,  2.4e-3, 3e-3,  3.6e-3, 4.2e-3, 5e-3,  6e-3,  7e-3,
    8.5e-3, 10e-3,  12e-3,  14e-3,  17e-3, 20e-3,  24e-3, 30e-3,  40e-3,  60e-3, 90e-3, 150e-3};

/// Measures a plan; override: the rate of time, 2^16 = 100 %.
inline sysc::LimitLoads drawn_limits(const ref::Plan& plan, const ref::Machine& machine,
                                     const ref::PlanOptions& options = {},
                                     std::int32_t override_word = 1 << 16) {
    int log2 = 0;
    while ((1 << log2) < options.samples_per_tick) ++log2;
    const std::uint64_t samples = sysc::count_samples(plan, log2, override_word);
    sysc::PathSource source(plan, log2, override_word);
    sysc::PathCursor cursor(plan);
    ref::CurveFollower curve;
    sysc::LimitMeter meter(machine, plan.unit_mm, options.sample_period_s, options.samples_per_tick,
                           3 + plan.aux_axes, 0, kManyWindows);
    const auto take = [&] {
        const ref::Vec3 point = curve.on(cursor.segment()).position(cursor.local());
        meter.take(ref::exact_point(cursor.segment(), point, cursor.local()), cursor.index());
    };
    take();
    for (std::uint64_t k = 0; k < samples; ++k) {
        source.next();
        cursor.advance(static_cast<std::uint64_t>(source.ds()));
        take();
    }
    return meter.finish();
}

/// Text such as "velocity 0.900 over 1 ms of 0 at sample 7, acceleration ...".
inline std::string text(const sysc::LimitLoads& loads) {
    std::string all;
    for (std::size_t i = 0; i < loads.worst.size(); ++i) {
        const auto& worst = loads.worst[i];
        all += fmt::format("{} {:.3f} over {:g} ms of {} at sample {}, ", sysc::kLimitedNames[i],
                           worst.ratio, worst.window * 1e3, worst.of, worst.sample);
    }
    return all;
}

}  // namespace curvecore::tb
