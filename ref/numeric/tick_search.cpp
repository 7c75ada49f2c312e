// SPDX-License-Identifier: Apache-2.0
#include "ref/numeric/tick_search.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {

TickSearch::TickSearch(const Cubic& cubic, SearchForm form, double tolerance)
    : cubic_(cubic), form_(form), tolerance_(tolerance) {}

double TickSearch::arc(double from, double to) const {
    return simpson_runge(cubic_, from, to, tolerance_).length;
}

double TickSearch::at(double s) {
    if (form_ == SearchForm::kLiteral) t_ = s_ = 0;
    if (form_ == SearchForm::kSummed) s_ = asked_;
    asked_ = s;
    const bool either_side = form_ == SearchForm::kMended || form_ == SearchForm::kSummed;
    const auto found = [&](double err) { return (either_side ? std::abs(err) : err) < tolerance_; };
    double err = s - s_;
    for (iterations_ = 0; !found(err) && iterations_ < kMostIterations; ++iterations_) {
        const double next = std::clamp(t_ + err / cubic_.speed(t_), 0.0, 1.0);
        s_ += arc(t_, next);
        t_ = next;
        err = s - s_;
    }
    return t_;
}

}  // namespace curvecore::ref
