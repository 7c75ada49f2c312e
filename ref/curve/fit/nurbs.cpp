// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/nurbs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/curve/fit/cubic_fit.hpp"

namespace curvecore::ref {
namespace {

std::vector<double> knots_of(const Nurbs& nurbs) {
    if (!nurbs.knots.empty()) return nurbs.knots;
    const int count = static_cast<int>(nurbs.points.size());
    const int degree = nurbs.order - 1;
    std::vector<double> knots;
    for (int i = 0; i <= count + degree; ++i) {
        knots.push_back(std::clamp(i - degree, 0, count - degree));
    }
    return knots;
}

/// Polar form of the span from knot `first` with the last `ends` arguments at the span's end and
/// the others at its start.
Eigen::Vector4d polar_form(std::vector<Eigen::Vector4d> d, int first,
                           const std::vector<double>& knots, int ends) {
    const int degree = static_cast<int>(d.size()) - 1;
    for (int level = 1; level <= degree; ++level) {
        const double x = knots[level <= degree - ends ? first : first + 1];
        for (int r = degree; r >= level; --r) {
            const int i = first - degree + r;
            const double low = knots[i];
            const double part = (x - low) / (knots[i + degree - level + 1] - low);
            d[r] = (1 - part) * d[r - 1] + part * d[r];
        }
    }
    return d[degree];
}

}  // namespace

std::string why_no_knots(const Nurbs& nurbs) {
    const std::vector<double>& knots = nurbs.knots;
    const std::size_t order = static_cast<std::size_t>(nurbs.order);
    const std::size_t count = nurbs.points.size();
    if (knots.size() != count + order) {
        return fmt::format("{} knots, where {} points of order {} want {}", knots.size(), count,
                           order, count + order);
    }
    for (std::size_t i = 1; i < knots.size(); ++i) {
        if (knots[i] >= knots[i - 1]) continue;
        return fmt::format("knots that fall, from {:g} to {:g}", knots[i - 1], knots[i]);
    }
    if (knots[order - 1] != knots.front() || knots[count] != knots.back()) {
        return fmt::format(
            "a first or a last knot that does not stand {} times: the curve would "
            "not end in its first and last points",
            order);
    }
    for (std::size_t i = 1; i < count; ++i) {
        if (knots[i] < knots[i + order - 1]) continue;
        return fmt::format("the knot {:g} {} times or more: the curve would have a gap there",
                           knots[i], order);
    }
    return "";
}

std::vector<RationalBezier> spans(const Nurbs& nurbs) {
    const int count = static_cast<int>(nurbs.points.size());
    const int degree = nurbs.order - 1;
    std::vector<Eigen::Vector4d> control;
    for (int i = 0; i < count; ++i) {
        const Vec3 point = nurbs.points[i] - nurbs.points[0];
        control.emplace_back();
        control.back() << nurbs.weights[i] * point, nurbs.weights[i];
    }
    const std::vector<double> knots = knots_of(nurbs);
    std::vector<RationalBezier> found;
    for (int first = degree; first < count; ++first) {
        if (knots[first] == knots[first + 1]) continue;
        RationalBezier span;
        span.origin = nurbs.points[0];
        const std::vector<Eigen::Vector4d> local(control.begin() + first - degree,
                                                 control.begin() + first + 1);
        for (int ends = 0; ends <= degree; ++ends) {
            span.points.push_back(ends == 0 && !found.empty()
                                      ? found.back().points.back()
                                      : polar_form(local, first, knots, ends));
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
