// SPDX-License-Identifier: Apache-2.0
#include "ref/path/corner.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ref/curve/angle_between.hpp"
#include "ref/moves/move_part.hpp"

namespace curvecore::ref {
namespace {

constexpr double kWidest = 0.5;    // rad of an arc that a corner may take
constexpr double kInPlane = 1e-9;  // 1, 1/mm
constexpr int kNewtonSteps = 12;
constexpr int kTries = 8;
constexpr int kPlaces = 64;  // places on each half

/// Legs of a cubic with given ends, tangents and signed curvatures in the plane of `normal`:
/// (3/2) leg^2 k = height of the other inner point over the tangent, at both ends.
std::optional<Eigen::Vector2d> legs(const MovePlace& a, const MovePlace& b, const Vec3& normal,
                                    double reach) {
    const auto cross = [&](const Vec3& x, const Vec3& y) { return normal.dot(x.cross(y)); };
    const double bend_a = cross(a.tangent, a.curvature);
    const double bend_b = cross(b.tangent, b.curvature);
    const double turn = cross(a.tangent, b.tangent);
    Eigen::Vector2d leg(reach, reach);
    for (int step = 0; step < kNewtonSteps; ++step) {
        const Vec3 inner = b.position - leg[1] * b.tangent - a.position - leg[0] * a.tangent;
        const Eigen::Vector2d miss(1.5 * leg[0] * leg[0] * bend_a - cross(a.tangent, inner),
                                   1.5 * leg[1] * leg[1] * bend_b - cross(inner, b.tangent));
        Eigen::Matrix2d slope;
        slope << 3 * leg[0] * bend_a, turn, turn, 3 * leg[1] * bend_b;
        const Eigen::Vector2d change = slope.inverse() * miss;
        leg -= change;
        if (!leg.allFinite() || leg.minCoeff() < 0.2 * reach || leg.maxCoeff() > 3 * reach) {
            return std::nullopt;
        }
        if (change.norm() < 1e-8 * reach) return leg;  // its square is left
    }
    return std::nullopt;
}

/// Bounds the worst distance of pairs, and of the curves between them.
double deviation(const Cubic& cubic, const Move& before, const Move& after, double reach,
                 double bend) {
    double worst = 0;
    for (int i = 0; i <= 2 * kPlaces; ++i) {
        const double u = 0.5 * i / kPlaces;
        const double way = reach * (std::pow(1 - u, 3) - std::pow(u, 3));
        const MovePlace place =
            way > 0 ? place_on(before, before.length() - way) : place_on(after, -way);
        worst = std::max(worst, (cubic.position(u) - place.position).norm());
    }
    const double speed = 3 * reach;  // speed of the pairs, by u; its change is at most twice this
    const double second = std::max(cubic.acceleration(0).norm(), cubic.acceleration(1).norm()) +
                          bend * speed * speed + 2 * speed;
    return worst + second / (8.0 * 4 * kPlaces * kPlaces);
}

}  // namespace

double corner_reach(double turn, double tolerance) { return 4 * tolerance / std::sin(turn / 2); }

std::optional<Corner> corner_of(const Move& before, const Move& after, double reach) {
    const MovePlace end = place_on(before, before.length());
    const MovePlace start = place_on(after, 0);
    const Vec3& in = end.tangent;
    const Vec3& out = start.tangent;
    const Vec3& vertex = after.start;
    if (before.kind == Move::Kind::kLine && after.kind == Move::Kind::kLine) {
        return Corner{reach,
                      {vertex - reach * in, vertex, vertex, vertex + reach * out},
                      reach * (out - in).norm() / 8};
    }
    const MovePlace a = place_on(before, before.length() - reach).by_length();
    const MovePlace b = place_on(after, reach).by_length();
    const Vec3 normal = in.cross(out).normalized();
    const double bend = std::max(end.curvature.norm(), start.curvature.norm());
    if (reach * bend > kWidest) return std::nullopt;
    for (const Vec3& x : {a.tangent, b.tangent, a.curvature, b.curvature}) {
        if (!(std::abs(normal.dot(x)) < kInPlane)) return std::nullopt;
    }
    const std::optional<Eigen::Vector2d> leg = legs(a, b, normal, reach);
    if (!leg) return std::nullopt;
    const Bezier points{a.position, a.position + (*leg)[0] * a.tangent,
                        b.position - (*leg)[1] * b.tangent, b.position};
    return Corner{reach, points, deviation(from_bezier(points), before, after, reach, bend)};
}

std::optional<Corner> longest_corner(const Move& before, const Move& after, double tolerance,
                                     double most) {
    constexpr double kFull = 0.98;
    const Vec3 in = place_on(before, before.length()).tangent;
    const Vec3 out = place_on(after, 0).tangent;
    double reach = std::min(most, corner_reach(angle_between(in, out), tolerance));
    std::optional<Corner> best;
    for (int i = 0; i < kTries; ++i) {
        const std::optional<Corner> corner = corner_of(before, after, reach);
        if (!corner) return best;
        const double share = corner->deviation / tolerance;
        const bool kept = share <= 1 + 1e-12;
        if (kept && (!best || best->reach < reach)) best = corner;
        if (kept && (share > kFull || reach >= most)) break;
        reach = std::min(most, reach * std::clamp((1 + kFull) / 2 / share, 0.3, 2.0));
    }
    return best;
}

}  // namespace curvecore::ref
