// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/nurbs.hpp"

#include <algorithm>

#include "ref/curve/fit/cubic_fit.hpp"

namespace curvecore::ref {
namespace {

/// Knot i of a curve with `count` points.
double knot(int i, int count, int degree) { return std::clamp(i - degree, 0, count - degree); }

/// Polar form of the span from knot `first` with its first arguments at the span's start, the last
/// `ends` ones at its end.
Eigen::Vector4d polar_form(std::vector<Eigen::Vector4d> d, int first, int count, int ends) {
    const int degree = static_cast<int>(d.size()) - 1;
    for (int level = 1; level <= degree; ++level) {
        const double x = knot(level <= degree - ends ? first : first + 1, count, degree);
        for (int r = degree; r >= level; --r) {
            const int i = first - degree + r;
            const double low = knot(i, count, degree);
            const double part = (x - low) / (knot(i + degree - level + 1, count, degree) - low);
            d[r] = (1 - part) * d[r - 1] + part * d[r];
        }
    }
    return d[degree];
}

}  // namespace

std::vector<RationalBezier> spans(const Nurbs& nurbs) {
    const int count = static_cast<int>(nurbs.points.size());
    const int degree = nurbs.order - 1;
    std::vector<Eigen::Vector4d> control;
    for (int i = 0; i < count; ++i) {
        const Vec3 point = nurbs.points[i] - nurbs.points[0];
        control.emplace_back();
        control.back() << nurbs.weights[i] * point, nurbs.weights[i];
    }
    std::vector<RationalBezier> found;
    for (int first = degree; first < count; ++first) {
        RationalBezier span;
        span.origin = nurbs.points[0];
        const std::vector<Eigen::Vector4d> local(control.begin() + first - degree,
                                                 control.begin() + first + 1);
        for (int ends = 0; ends <= degree; ++ends) {
            span.points.push_back(ends == 0 && !found.empty()
                                      ? found.back().points.back()
                                      : polar_form(local, first, count, ends));
        }
        found.push_back(std::move(span));
    }
    return found;
}

std::vector<Cubic> cubics_of(const Nurbs& nurbs, double tolerance) {
    std::vector<Cubic> cubics;
    for (const RationalBezier& span : spans(nurbs)) {
        if (span.degree() == 1 || (span.degree() <= 3 && span.polynomial())) {
            cubics.push_back(span.exact_cubic());
        } else {
            const std::vector<Cubic> fitted = fit_cubics(span, tolerance);
            cubics.insert(cubics.end(), fitted.begin(), fitted.end());
        }
    }
    return cubics;
}

}  // namespace curvecore::ref
