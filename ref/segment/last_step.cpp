// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/last_step.hpp"

#include <algorithm>
#include <cmath>

#include "ref/format/path_words.hpp"
#include "ref/segment/core_budget.hpp"

namespace curvecore::ref {
namespace {

// A segment's length in words is the difference of two rounded sums: it may have this much more.
constexpr double kLengthRounding = 2 * kQuantum;  // units

}  // namespace

double least_last_step(double speed, const PlanOptions& options) {
    return speed * two_changes_time(options) / options.unit_mm;
}

double cut_for_last_step(double length, int step_exponent, double least) {
    const double step = std::ldexp(1, step_exponent);
    const double whole = std::floor((length + kLengthRounding) / step);
    const double last = length - whole * step;
    if (least <= 0 || whole < 1 || last >= std::min(least, step / 2)) return 0;
    return (whole - 0.5) * step + last / 2;
}

}  // namespace curvecore::ref
