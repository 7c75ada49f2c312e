// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/core_budget.hpp"

#include <algorithm>

namespace curvecore::ref {
namespace {

constexpr double kRounding = 1 + 1e-9;  // share of sums of many costs
constexpr double kSeveral = 4;          // changes: the next moves may be short themselves

}  // namespace

double window_of(const PlanOptions& options) {
    const CoreTime& core = options.core;
    return (core.ahead ? 1 : 1 + core.samples_ahead) * options.sample_period_s;
}

double budget_of(const PlanOptions& options) {
    return window_of(options) * (1 - options.core.sample / options.sample_period_s) * kRounding;
}

double two_changes_time(const PlanOptions& options) {
    const CoreTime& core = options.core;
    double change = 0;
    for (const CurveKind kind : kCurveKinds) {
        if (!draws(options.format, kind)) continue;
        change = std::max({change, core.curve[kind].step, core.curve[kind].segment});
    }
    if (kSeveral * change <= budget_of(options)) return 0;
    return core.ahead ? change : window_of(options);
}

}  // namespace curvecore::ref
