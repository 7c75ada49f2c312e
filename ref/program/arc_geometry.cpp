// SPDX-License-Identifier: Apache-2.0
#include "ref/program/arc_geometry.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;
constexpr double kSamePoint = 1e-9;       // mm: below any length unit
constexpr double kSmallestRadius = 1e-6;  // mm
constexpr double kLargestRadius = 1e6;    // mm
constexpr double kRounding = 0.005;       // mm: a file's rounding, always accepted
constexpr double kLargestMismatch = 0.5;  // mm, if also within
constexpr double kRelativeMismatch = 1e-3;
constexpr double kSameAngle = 1e-6;   // rad: below, the file may mean a full circle
constexpr double kSweepChange = 0.1;  // rad: a moved centre that changes more is another arc

void check_radius(double radius) {
    if (radius < kSmallestRadius) {
        throw ArcError("the arc's radius is 0");
    }
    if (!(radius <= kLargestRadius)) {
        throw ArcError(fmt::format("the arc's radius is out of range ({:g} mm)", radius));
    }
}

/// The angle from `a` to `b`, 0 .. one turn.
double sweep(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool clockwise) {
    const double cross = a.x() * b.y() - a.y() * b.x();
    const double angle = std::atan2(clockwise ? -cross : cross, a.dot(b));
    return angle < 0 ? angle + kTurn : angle;
}

}  // namespace

PlaneArc arc_with_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                         const Eigen::Vector2d& centre, bool clockwise, int turns) {
    const double r_start = (start - centre).norm();
    const double r_end = (end - centre).norm();
    check_radius(r_start);
    const double mismatch = std::abs(r_end - r_start);
    const double relative = mismatch / std::max(r_start, r_end);
    if (mismatch > kRounding && (mismatch > kLargestMismatch || relative > kRelativeMismatch)) {
        throw ArcError(
            fmt::format("the arc's radii differ: {:.6g} mm at the start, {:.6g} mm at "
                        "the end",
                        r_start, r_end));
    }
    const Eigen::Vector2d chord = end - start;
    if (chord.norm() < kSamePoint) {
        return {centre, kTurn * turns};
    }
    const Eigen::Vector2d along = chord.normalized();
    const Eigen::Vector2d moved = centre - along * along.dot(centre - (start + end) / 2);
    const double wanted = sweep(start - centre, end - centre, clockwise);
    const double angle = sweep(start - moved, end - moved, clockwise);
    if (std::abs(angle - wanted) > kSweepChange) {
        if (chord.norm() <= 2 * kRounding && wanted > kSameAngle && wanted < kTurn / 2) {
            return {centre, 0};
        }
        throw ArcError(
            fmt::format("the arc's ends are {:.3g} mm apart along its radius: no circle "
                        "about this centre holds both",
                        chord.norm()));
    }
    check_radius((start - moved).norm());
    return {moved, angle + kTurn * (turns - 1)};
}

PlaneArc arc_with_radius(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double radius,
                         bool clockwise, int turns) {
    check_radius(std::abs(radius));
    const Eigen::Vector2d chord = end - start;
    const double half = chord.norm() / 2;
    if (chord.norm() < kSamePoint) {
        throw ArcError("R with equal ends: a full circle needs a centre");
    }
    if (half > std::abs(radius) + kRounding / 2) {
        throw ArcError(fmt::format("R is too small: the ends are {:.6g} mm apart", 2 * half));
    }
    const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
    const Eigen::Vector2d left = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
    const double side = clockwise == (radius > 0) ? -1 : 1;
    const double minor = 2 * std::atan2(half, height);
    return {(start + end) / 2 + side * height * left,
            (radius > 0 ? minor : kTurn - minor) + kTurn * (turns - 1)};
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
    return {centre, normal, angle > 0 ? angle : angle + kTurn};
}

}  // namespace curvecore::ref
