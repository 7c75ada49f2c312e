// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/speed_spline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace curvecore::ref {
namespace {

constexpr double kSlowest = 1e-6;  // mm^2/s^2

}  // namespace

SpeedSpline::SpeedSpline(std::vector<double> lengths, const std::vector<KnotMotion>& knots)
    : h_(std::move(lengths)),
      starts_at_rest_(knots.front().q == 0),
      ends_at_rest_(knots.back().q == 0),
      control_(h_.size(), 0) {
    control_.front() = knots.front().q;
    control_.back() = knots.back().q;
    for (std::size_t k = 0; k < h_.size(); ++k) {
        form_.push_back(make_form(k));
        if (k == 0 || k + 1 == h_.size()) continue;
        // The control point of a piece of parabola, from both of its ends.
        const KnotMotion& from = knots[k];
        const KnotMotion& to = knots[k + 1];
        const double q = (from.q + to.q) / 2 + h_[k] * (from.a - to.a) / 2;
        control_[k] = std::max({q, std::min(from.q, to.q), kSlowest});
    }
}

SpeedSpline::Form SpeedSpline::make_form(std::size_t k) const {
    const std::size_t n = h_.size();
    const double first = 1 / (3 + 2 * h_[1] / h_[0]);  // control point 0 of the next one
    const double last = 1 / (3 + 2 * h_[n - 2] / h_[n - 1]);
    /// q and a at the end of interval `left`, whose control point is in `column`.
    const auto knot = [&](std::size_t left, int column) {
        const double sum = h_[left] + h_[left + 1];
        Form f = Form::Zero();
        f(0, column) = h_[left + 1] / sum;
        f(0, column + 1) = h_[left] / sum;
        f(1, column) = -1 / sum;
        f(1, column + 1) = 1 / sum;
        return f;
    };
    Form form = Form::Zero();
    if (rests(k)) {
        form = k == 0 ? knot(0, 1) : knot(k - 1, 0);
        form.row(2) = form.row(0) * (2 / (9 * h_[k] * h_[k]));
    } else {
        if (k == 0) {
            form(0, 1) = 1;
        } else {
            form = knot(k - 1, 0);
        }
        const Eigen::RowVector3d end =
            k + 1 == n ? Eigen::RowVector3d::Zero() : Eigen::RowVector3d(knot(k, 1).row(1));
        form.row(2) = (end - form.row(1)) / h_[k];
    }
    const auto tie = [&](int tied, int to, double factor) {
        form.col(to) += factor * form.col(tied);
        form.col(tied).setZero();
    };
    if (starts_at_rest_ && k == 0) tie(1, 2, first);
    if (starts_at_rest_ && k == 1) tie(0, 1, first);
    if (ends_at_rest_ && k + 2 == n) tie(2, 1, last);
    if (ends_at_rest_ && k + 1 == n) tie(1, 0, last);
    return form;
}

KnotMotion SpeedSpline::knot(std::size_t k) const {
    if (k == 0) return {starts_at_rest_ ? 0 : control_.front(), 0};
    if (k == h_.size()) return {ends_at_rest_ ? 0 : control_.back(), 0};
    const PathMotion m = motion(k - 1);
    const PathMotion at = rests(k - 1) ? m : farther(m, h_[k - 1]);
    return {at[0], at[1]};
}

double SpeedSpline::time(std::size_t k) const {
    const PathMotion m = motion(k);
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    if (rests(k)) return m[0] > 0 ? 3 * h_[k] / std::sqrt(m[0]) : kInfinite;
    double sum = 0;
    for (const double x : gauss_points(h_[k])) {
        const double q = farther(m, x)[0];
        if (!(q > 0)) return kInfinite;
        sum += h_[k] / 2 / std::sqrt(q);
    }
    return sum;
}

}  // namespace curvecore::ref
