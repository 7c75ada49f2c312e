// SPDX-License-Identifier: Apache-2.0
// A cubic B-spline that is clamped at both ends: C2 wherever its control points lie.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

/// The spline has m spans between knots k_0 < .. < k_m, m + 3 control points. Its polar form
/// (blossom) f is symmetric, affine in each argument, and f(s, s, s) = r(s); control point i is
/// f(t_{i+1}, t_{i+2}, t_{i+3}) of the knots t with both ends four times.
class CubicSpline {
  public:
    explicit CubicSpline(const std::vector<double>& knots) {
        t_.assign(3, knots.front());
        t_.insert(t_.end(), knots.begin(), knots.end());
        t_.insert(t_.end(), 3, knots.back());
        points.assign(knots.size() + 2, Vec3::Zero());
    }

    std::size_t spans() const { return t_.size() - 7; }
    double knot(std::size_t i) const { return t_[i + 3]; }
    double width(std::size_t span) const { return knot(span + 1) - knot(span); }
    /// t_{i+1}, t_{i+2}, t_{i+3} of control point i.
    const double* arguments(std::size_t point) const { return &t_[point + 1]; }

    /// Weights of a span's four control points, the first with the span's index, in f(x, y, z).
    std::array<double, 4> weights(std::size_t span, double x, double y, double z) const {
        std::array<double, 4> result{};
        for (std::size_t i = 0; i < 4; ++i) {  // de Boor, for a unit control point
            std::array<double, 4> d{};
            d[i] = 1;
            const std::array<double, 3> at{x, y, z};
            for (std::size_t level = 1; level <= 3; ++level) {
                for (std::size_t j = 3; j >= level; --j) {
                    const double low = t_[span + j];
                    const double high = t_[span + j + 4 - level];
                    const double part = (at[level - 1] - low) / (high - low);
                    d[j] += (1 - part) * (d[j - 1] - d[j]);
                }
            }
            result[i] = d[3];
        }
        return result;
    }

    Vec3 polar(std::size_t span, double x, double y, double z) const {
        const std::array<double, 4> w = weights(span, x, y, z);
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < 4; ++i) sum += w[i] * points[span + i];
        return sum;
    }

    Bezier bezier(std::size_t span) const {
        const double a = knot(span);
        const double b = knot(span + 1);
        return {polar(span, a, a, a), polar(span, a, a, b), polar(span, a, b, b),
                polar(span, b, b, b)};
    }

    std::vector<Vec3> points;

  private:
    std::vector<double> t_;
};

}  // namespace curvecore::ref
