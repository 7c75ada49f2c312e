// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/arc_length.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace curvecore::ref {
namespace {

constexpr double kQuadrature = 1e-14;  // adaptive, relative, for each of at most four parts
constexpr double kTable = 1e-15;       // error of a piece, relative to the whole; also Newton's
constexpr int kIterations = 60;        // bits of a double: a cusp halves the distance at worst
constexpr double kShort = 1.0 / 64;    // a piece where three Gauss points are as good as ten

std::vector<double> with_extrema(const Cubic& cubic, double low, double high) {
    std::vector<double> ends{low};
    for (const double u : speed_extrema(cubic)) {
        if (u > low && u < high) {
            ends.push_back(u);
        }
    }
    ends.push_back(high);
    return ends;
}

}  // namespace

double arc_length(const Cubic& cubic, double u0, double u1) {
    if (u1 < u0) {
        return -arc_length(cubic, u1, u0);
    }
    const std::vector<double> ends = with_extrema(cubic, u0, u1);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        // The range is -1 .. 1, where the rule compares its error with the integral in the same
        // measure.
        const double half = (ends[i + 1] - ends[i]) / 2;
        const double centre = ends[i] + half;
        const auto speed = [&](double x) { return cubic.speed(centre + half * x); };
        sum += half * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                          speed, -1.0, 1.0, 15, kQuadrature);
    }
    return sum;
}

double parameter_at(const Cubic& cubic, double s) {
    const double length = arc_length(cubic, 0, 1);
    if (!(s > 0)) {
        return 0;
    }
    if (s >= length) {
        return 1;
    }
    // The last point asked is the start, not 0: a correction as small as it is costs no digits.
    double at = 0;
    double path = 0;
    const auto miss = [&](double u) {
        path += arc_length(cubic, at, u);
        at = u;
        return std::make_pair(path - s, cubic.speed(u));
    };
    std::uintmax_t limit = 200;
    return boost::math::tools::newton_raphson_iterate(miss, s / length, 0.0, 1.0,
                                                      std::numeric_limits<double>::digits, limit);
}

ArcLength::ArcLength(const Cubic& cubic) {
    for (int axis = 0; axis < 3; ++axis) {
        a_[axis] = 3 * cubic.a[axis];
        b_[axis] = 2 * cubic.b[axis];
        c_[axis] = cubic.c[axis];
    }
    const std::vector<double> ends = with_extrema(cubic, 0, 1);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        tolerance_ += integral(ends[i], ends[i + 1]);
    }
    tolerance_ *= kTable;
    knots_.push_back({0, 0, speed(0)});
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        append(ends[i + 1], integral(ends[i], ends[i + 1]));
    }
}

double ArcLength::speed(double u) const {
    const double x = (a_[0] * u + b_[0]) * u + c_[0];
    const double y = (a_[1] * u + b_[1]) * u + c_[1];
    const double z = (a_[2] * u + b_[2]) * u + c_[2];
    return std::sqrt(x * x + y * y + z * z);
}

double ArcLength::integral(double from, double to) const {
    return boost::math::quadrature::gauss<double, 10>::integrate(
        [this](double u) { return speed(u); }, from, to);
}

double ArcLength::short_integral(double from, double to) const {
    const double half = (to - from) / 2;
    const double middle = from + half;
    const double off = half * std::sqrt(0.6);
    return half * (5 * (speed(middle - off) + speed(middle + off)) + 8 * speed(middle)) / 9;
}

// Appends knots up to `end`, in pieces whose halves agree with them. The halves are kept: their
// error is another 2^-20 of the disagreement where the speed is smooth.
void ArcLength::append(double end, double estimate) {
    const Knot start = knots_.back();
    const double middle = start.u + (end - start.u) / 2;
    const double first = integral(start.u, middle);
    const double second = integral(middle, end);
    if (estimate > tolerance_ && std::abs(first + second - estimate) > tolerance_) {
        append(middle, first);
        append(end, second);
        return;
    }
    knots_.push_back({middle, start.s + first, speed(middle)});
    knots_.push_back({end, start.s + first + second, speed(end)});
}

double ArcLength::path(double u) const {
    if (!(u > 0)) {
        return 0;
    }
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), u,
                                        [](double at, const Knot& knot) { return at < knot.u; });
    if (above == knots_.end()) {
        return length();
    }
    const Knot& start = *(above - 1);
    return start.s + integral(start.u, u);
}

double ArcLength::parameter(double s) const {
    if (!(s > 0)) {
        return 0;
    }
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), s,
                                        [](double at, const Knot& knot) { return at < knot.s; });
    if (above == knots_.end()) {
        return 1;
    }
    const Knot& start = *(above - 1);
    const Knot& end = *above;
    const double target = s - start.s;
    if (target == 0) {
        return start.u;
    }
    // Speed linear in u: target = v0 t + (v1 - v0) t^2 / 2, then t in proportion to the piece.
    const double share = target / (end.s - start.s) * (start.speed + end.speed) / 2;
    const double square = start.speed * start.speed + 2 * (end.speed - start.speed) * share;
    const double t = 2 * share / (start.speed + std::sqrt(std::max(square, 0.0)));
    double u = start.u + (end.u - start.u) * std::min(t, 1.0);
    double path = integral(start.u, u);
    for (int n = 0; n < kIterations && std::abs(path - target) > tolerance_; ++n) {
        const double next = std::clamp(u - (path - target) / speed(u), start.u, end.u);
        const bool near = std::abs(next - u) < kShort * (end.u - start.u);
        path = near ? path + short_integral(u, next) : integral(start.u, next);
        u = next;
    }
    return u;
}

}  // namespace curvecore::ref
