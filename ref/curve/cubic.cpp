// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/cubic.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace curvecore::ref {

Vec3 tangent(const Cubic& cubic, double u) {
    const Vec3 v = cubic.velocity(u);
    return v / v.norm();
}

Vec3 curvature_vector(const Cubic& cubic, double u) {
    const Vec3 v = cubic.velocity(u);
    const double square = v.squaredNorm();
    // (V x W) x V = W v^2 - V (V.W): the cross products lose nothing where W is along V.
    return v.cross(cubic.acceleration(u)).cross(v) / (square * square);
}

double curvature(const Cubic& cubic, double u) {
    const Vec3 v = cubic.velocity(u);
    const double speed = v.norm();
    return v.cross(cubic.acceleration(u)).norm() / (speed * speed * speed);
}

Vec3 curvature_rate(const Cubic& cubic, double u) {
    const Vec3 v = cubic.velocity(u);
    const Vec3 w = cubic.acceleration(u);
    const Vec3 vw = v.cross(w);
    const double square = v.squaredNorm();
    // d/du of ((V x W) x V) / v^4, divided by v = ds/du.
    const Vec3 turned = v.cross(cubic.jerk()).cross(v) + vw.cross(w);
    const Vec3 slowed = vw.cross(v) * (4 * v.dot(w) / square);
    return (turned - slowed) / (square * square * std::sqrt(square));
}

namespace {

// (d/du)(v^2) / 2 = V.W = p3 u^3 + p2 u^2 + p1 u + p0
struct SpeedSlope {
    double p3, p2, p1, p0;

    explicit SpeedSlope(const Cubic& cubic)
        : p3(18 * cubic.a.squaredNorm()),
          p2(18 * cubic.a.dot(cubic.b)),
          p1(4 * cubic.b.squaredNorm() + 6 * cubic.a.dot(cubic.c)),
          p0(2 * cubic.b.dot(cubic.c)) {}

    double operator()(double u) const { return ((p3 * u + p2) * u + p1) * u + p0; }
};

}  // namespace

std::vector<double> speed_extrema(const Cubic& cubic) {
    const SpeedSlope slope(cubic);
    // Between the zeros of its derivative a polynomial is monotone: at most one root, bracketed,
    // whatever the degree has fallen to.
    const auto [low, high] =
        boost::math::tools::quadratic_roots(3 * slope.p3, 2 * slope.p2, slope.p1);
    std::vector<double> ends{0};
    for (const double turn : {low, high}) {
        if (turn > ends.back() && turn < 1) {  // false for NaN: no real zero
            ends.push_back(turn);
        }
    }
    ends.push_back(1);

    std::vector<double> extrema;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double before = slope(ends[i]);
        const double after = slope(ends[i + 1]);
        if (!(std::min(before, after) < 0 && std::max(before, after) > 0)) {
            continue;
        }
        std::uintmax_t limit = 200;
        const auto root =
            boost::math::tools::toms748_solve(slope, ends[i], ends[i + 1], before, after,
                                              boost::math::tools::eps_tolerance<double>(), limit);
        extrema.push_back(root.first + (root.second - root.first) / 2);
    }
    return extrema;
}

SpeedRange speed_range(const Cubic& cubic) {
    SpeedRange range{cubic.speed(0), cubic.speed(0), 0, 0};
    std::vector<double> candidates = speed_extrema(cubic);
    candidates.push_back(1);
    for (const double u : candidates) {
        const double speed = cubic.speed(u);
        if (speed < range.min) {
            range.min = speed;
            range.at_min = u;
        }
        if (speed > range.max) {
            range.max = speed;
            range.at_max = u;
        }
    }
    return range;
}

bool has_cusp(const Cubic& cubic, double relative) {
    const SpeedRange range = speed_range(cubic);
    return !(range.min > relative * range.max);
}

Cubic sub_cubic(const Cubic& cubic, double u0, double u1) {
    // Taylor's form about u0 keeps the small coefficients of a short part; differences of its
    // control points would not.
    const double h = u1 - u0;
    return {h * h * h * cubic.a, h * h * (3 * u0 * cubic.a + cubic.b), h * cubic.velocity(u0),
            cubic.position(u0)};
}

Cubic from_bezier(const Bezier& points) {
    const Vec3 first = points[1] - points[0];
    const Vec3 middle = points[2] - points[1];
    const Vec3 last = points[3] - points[2];
    return {(last - middle) - (middle - first), 3 * (middle - first), 3 * first, points[0]};
}

Bezier to_bezier(const Cubic& cubic) {
    const Vec3 third = cubic.c / 3;
    return {cubic.d, cubic.d + third, cubic.d + (2 * third + cubic.b / 3),
            cubic.d + (cubic.a + cubic.b + cubic.c)};
}

}  // namespace curvecore::ref
