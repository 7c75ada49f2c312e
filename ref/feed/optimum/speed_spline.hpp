// SPDX-License-Identifier: Apache-2.0
// The motion along a path as a quadratic spline of path length.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "ref/feed/places/path_interval.hpp"

namespace curvecore::ref {

/// The motion x mm farther on, while a' is constant.
inline PathMotion farther(const PathMotion& m, double x) {
    return {m[0] + (2 * m[1] + m[2] * x) * x, m[1] + m[2] * x, m[2]};
}

/// The spline q(s) >= 0 with a continuous first derivative from n control points: c_k belongs to
/// interval k, and at the knot between intervals k - 1 and k
///
///     q = (h_k c_{k-1} + h_{k-1} c_k) / (h_{k-1} + h_k)     a = (c_k - c_{k-1}) / (h_{k-1} + h_k)
///
/// An end of the path may be at rest: then the jerk is constant within its interval, so q goes with
/// s^(4/3) from rest and a = 2/3 q / s at the other end: this ties c_0 to c_1 or c_{n-1} to
/// c_{n-2}. Otherwise q there is c_0 or c_{n-1}, given, and a = 0.
class SpeedSpline {
  public:
    /// Rows q, a, a' of a motion over the columns c_{k-1}, c_k, c_{k+1}; tied ones are 0.
    using Form = Eigen::Matrix3d;

    /// @param lengths at least 4
    /// @param knots a motion that is nearly met, at the ends exactly if a = 0 there
    SpeedSpline(std::vector<double> lengths, const std::vector<KnotMotion>& knots);

    std::size_t intervals() const { return h_.size(); }
    double length(std::size_t k) const { return h_[k]; }
    /// Returns true if the interval begins or ends at rest: its motions refer to its other end.
    bool rests(std::size_t k) const {
        return (k == 0 && starts_at_rest_) || (k + 1 == h_.size() && ends_at_rest_);
    }

    /// Control point k; 1 .. intervals() - 2 are free.
    double& control(std::size_t k) { return control_[k]; }
    double control(std::size_t k) const { return control_[k]; }

    /// Control points k - 1, k, k + 1; beyond both ends 0, as their factors are.
    std::array<double, 3> controls(std::size_t k) const {
        return {k == 0 ? 0 : control_[k - 1], control_[k],
                k + 1 == h_.size() ? 0 : control_[k + 1]};
    }
    /// Form at the start of an interval.
    const Form& form(std::size_t k) const { return form_[k]; }
    PathMotion motion(std::size_t k) const {
        const Form& f = form_[k];
        const std::array<double, 3> c = controls(k);
        const auto row = [&](int i) { return f(i, 0) * c[0] + f(i, 1) * c[1] + f(i, 2) * c[2]; };
        return {row(0), row(1), row(2)};
    }
    KnotMotion knot(std::size_t k) const;

    /// The two Gauss points of an interval.
    static std::array<double, 2> gauss_points(double length) {
        constexpr double kGauss = 0.21132486540518713;  // (1 - 1 / sqrt 3) / 2
        return {kGauss * length, (1 - kGauss) * length};
    }
    /// Time of an interval, s; infinite if q is not positive.
    double time(std::size_t k) const;

  private:
    Form make_form(std::size_t k) const;

    std::vector<double> h_;
    bool starts_at_rest_, ends_at_rest_;
    std::vector<Form> form_;
    std::vector<double> control_;
};

}  // namespace curvecore::ref
