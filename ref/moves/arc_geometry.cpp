// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/arc_geometry.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/numeric/angles.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSmallestRadius = 1e-6;  // mm
constexpr double kLargestRadius = 1e8;    // mm: 1e-16 of it is below any length unit
constexpr double kRelativeMismatch = 1e-3;
constexpr double kRounding = 1e-15;  // relative, of the numbers of a block

void check_radius(double radius) {
    if (radius < kSmallestRadius) {
        throw ArcError("the arc's radius is 0");
    }
    if (!(radius <= kLargestRadius)) {
        throw ArcError(fmt::format("the arc's radius is out of range ({:g} mm)", radius));
    }
}

/// Angle from `arm` to `arm` + `chord`, 0 .. one turn: a far centre costs no digits.
double sweep(const Eigen::Vector2d& arm, const Eigen::Vector2d& chord, bool clockwise) {
    const double cross = arm.x() * chord.y() - arm.y() * chord.x();
    const double angle = std::atan2(clockwise ? -cross : cross, arm.dot(arm + chord));
    return angle < 0 ? angle + kTurnRadians : angle;
}

/// Place of `start` after a turn by `angle`; `arm` is its radius.
Eigen::Vector2d turned(const Eigen::Vector2d& start, const Eigen::Vector2d& arm, double angle) {
    const double half_sine = std::sin(angle / 2);
    return start + std::sin(angle) * Eigen::Vector2d(-arm.y(), arm.x()) -
           2 * half_sine * half_sine * arm;
}

}  // namespace

bool ArcTolerance::holds(double r_start, double r_end) const {
    const double mismatch = std::abs(r_end - r_start);
    return mismatch <= always ||
           (mismatch <= most && mismatch <= kRelativeMismatch * std::max(r_start, r_end));
}

PlaneArc arc_with_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                         const Eigen::Vector2d& centre, bool clockwise, int turns,
                         const ArcTolerance& tolerance) {
    const double r_start = (start - centre).norm();
    const double r_end = (end - centre).norm();
    check_radius(r_start);
    check_radius(r_end);
    if (!tolerance.holds(r_start, r_end)) {
        throw ArcError(
            fmt::format("the arc's radii differ: {:.6g} mm at the start, {:.6g} mm at "
                        "the end",
                        r_start, r_end));
    }
    const Eigen::Vector2d arm = start - centre;
    double angle = sweep(arm, end - start, clockwise);
    if (r_start * std::min(angle, kTurnRadians - angle) < kSameDirection) angle = kTurnRadians;
    PlaneArc arc{centre, angle + kTurnRadians * (turns - 1), Eigen::Vector2d::Zero()};
    const Eigen::Vector2d rest = end - turned(start, arm, clockwise ? -angle : angle);
    if (rest.norm() > kSamePoint) arc.drift = rest;
    return arc;
}

PlaneArc arc_with_radius(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double radius,
                         bool clockwise, int turns, const ArcTolerance& tolerance) {
    check_radius(std::abs(radius));
    const Eigen::Vector2d chord = end - start;
    const double half = chord.norm() / 2;
    if (chord.norm() < kSamePoint) {
        throw ArcError("R with equal ends: a full circle needs a centre");
    }
    if (half > std::abs(radius) + tolerance.reach / 2) {
        throw ArcError(fmt::format("R is too small: the ends are {:.6g} mm apart", 2 * half));
    }
    // Makes half a circle if only roundings are between: the centre would move by the root of them.
    const double spare = std::abs(radius) - half;
    const bool more = spare > kRounding * (start.norm() + end.norm() + half);
    const double height = more ? std::sqrt(spare * (std::abs(radius) + half)) : 0;
    const Eigen::Vector2d left = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
    const double side = clockwise == (radius > 0) ? -1 : 1;
    const double minor = 2 * std::atan2(half, height);
    return {(start + end) / 2 + side * height * left,
            (radius > 0 ? minor : kTurnRadians - minor) + kTurnRadians * (turns - 1),
            Eigen::Vector2d::Zero()};
}

SpaceArc arc_through(const Eigen::Vector3d& start, const Eigen::Vector3d& middle,
                     const Eigen::Vector3d& end) {
    const Eigen::Vector3d a = middle - start;
    const Eigen::Vector3d b = end - start;
    if (a.norm() < kSamePoint || b.norm() < kSamePoint || (b - a).norm() < kSamePoint) {
        throw ArcError("two of the arc's three points are the same");
    }
    // Twice the triangle's area over its longest sides: the sine of its smallest angles.
    const Eigen::Vector3d area = a.cross(b);
    const double diameter = a.norm() * b.norm() * (b - a).norm() / area.norm();
    if (!(diameter <= 2 * kLargestRadius)) {
        throw ArcError("the arc's three points lie on a straight line");
    }
    check_radius(diameter / 2);
    const Eigen::Vector3d centre =
        start + (a.squaredNorm() * b - b.squaredNorm() * a).cross(area) / (2 * area.squaredNorm());
    const Eigen::Vector3d normal = area.normalized();
    const Eigen::Vector3d from = start - centre;
    const Eigen::Vector3d to = end - centre;
    const double angle = std::atan2(normal.dot(from.cross(to)), from.dot(to));
    return {centre, normal, angle > 0 ? angle : angle + kTurnRadians};
}

}  // namespace curvecore::ref
