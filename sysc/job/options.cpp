// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/options.hpp"

#include <algorithm>
#include <cmath>

#include "sysc/core/core_clocks.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kLiveHorizon = 1.5;  // s

}  // namespace

int Options::samples_per_tick_log2() const {
    int n = 0;
    while ((1 << n) < samples_per_tick) ++n;
    return n;
}

std::int32_t Options::override_word() const {
    return static_cast<std::int32_t>(std::lround(std::min(1.0, override_percent / 100) * 65536));
}

double Options::feed_factor() const { return std::max(1.0, override_percent / 100); }

ref::PlanOptions Options::plan_options() const {
    ref::PlanOptions plan;
    plan.unit_mm = unit_mm;
    plan.sample_period_s = sample_period_s;
    plan.samples_per_tick = samples_per_tick;
    plan.format = core;
    plan.aux_axes = core.aux_axes;
    plan.error_limit = error_limit;
    plan.core = core_time(core, clock_hz, samples_per_tick);
    plan.effort = effort;
    plan.holds = holds;
    plan.segment_queue_words = segment_queue_words;
    plan.profile_queue_words = profile_queue_words;
    if (live) plan.horizon_s = kLiveHorizon;
    return plan;
}

}  // namespace curvecore::sysc
