// SPDX-License-Identifier: Apache-2.0
#include "ref/join/jumps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/curve/angle_between.hpp"

namespace curvecore::ref {
namespace {

JoinJumps jumps_of(const std::string& name, const IdleMove& move, SpeedLaw law, double length,
                   const Joint& first, const Joint& last) {
    const SpeedCourse course{law, move.start.feed, move.end.feed, length};
    return {name, length, jump(move.start, first, course.acceleration(0)),
            jump(move.end, last, course.acceleration(length))};
}

/// Returns a jump in rad or 1/mm, 0 if it is only the rounding of points and derivatives.
double above_rounding(double value) { return value < 1e-9 ? 0 : value; }

}  // namespace

double SpeedCourse::speed(double s) const {
    const double x = s / length;
    if (law == SpeedLaw::kEven) return std::sqrt(v0 * v0 + (v1 * v1 - v0 * v0) * x);
    return v0 + (v1 - v0) * x * x * x * (10 + x * (6 * x - 15));
}

double SpeedCourse::acceleration(double s) const {
    const double x = s / length;
    if (law == SpeedLaw::kEven) return (v1 * v1 - v0 * v0) / (2 * length);
    return speed(s) * (v1 - v0) * 30 * x * x * (1 - x) * (1 - x) / length;
}

Jump jump(const Joint& working, const Joint& idle, double acceleration) {
    Jump found;
    found.slope = above_rounding(angle_between(working.tangent, idle.tangent));
    found.curvature = above_rounding((idle.curvature - working.curvature).norm());
    found.across = working.feed * working.feed * found.curvature / kGravity;
    found.along = std::abs(acceleration) / kGravity;
    return found;
}

JoinJumps jumps(const IdleMove& move, SpeedLaw law) {
    const PathTable path(move.pieces());
    const PathTable::Place last{path.pieces().size() - 1, 1};
    return jumps_of(std::string(kJoinFitNames[static_cast<std::size_t>(move.fit)]), move, law,
                    path.length(), path.at(PathTable::Place{}), path.at(last));
}

Jump worst_inside(const IdleMove& move, SpeedLaw law) {
    const PathTable path(move.pieces());
    const SpeedCourse course{law, move.start.feed, move.end.feed, path.length()};
    const std::vector<double> starts = path.starts();
    Jump worst;
    for (std::size_t piece = 1; piece < path.pieces().size(); ++piece) {
        Joint before = path.at(PathTable::Place{piece - 1, 1});
        before.feed = course.speed(starts[piece]);
        const Jump here = jump(before, path.at(PathTable::Place{piece, 0}), 0);
        worst.slope = std::max(worst.slope, here.slope);
        worst.curvature = std::max(worst.curvature, here.curvature);
        worst.across = std::max(worst.across, here.across);
    }
    return worst;
}

std::vector<JoinJumps> compare_joins(const IdleMove& move, SpeedLaw law) {
    const Vec3 chord = move.end.position - move.start.position;
    const double length = chord.norm();
    const Vec3 along = chord / length;
    const auto mirrored = [&along](const Vec3& v) { return Vec3(v - 2 * along * along.dot(v)); };

    const Joint line{{move.start.position, along, Vec3::Zero()}, 0};
    Joint first = move.start;  // the arc's: curvature 2 sin(angle) / chord, towards the chord
    const Vec3 across = chord - first.tangent * first.tangent.dot(chord);
    first.curvature = 2 * across / chord.squaredNorm();
    const Joint last{{move.end.position, -mirrored(first.tangent), mirrored(first.curvature)}, 0};
    const double angle = angle_between(first.tangent, along);
    // A path straight on, or straight back, has no arc.
    const double arc = std::sin(angle) > 1e-9 ? length * angle / std::sin(angle) : length;

    std::vector<JoinJumps> found{jumps_of("line", move, law, length, line, line),
                                 jumps_of("arc", move, law, arc, first, last)};
    IdleMove other = move;
    for (std::size_t fit = 0; fit < kJoinFitNames.size(); ++fit) {
        other.fit = static_cast<JoinFit>(fit);
        found.push_back(jumps(other, law));
    }
    return found;
}

}  // namespace curvecore::ref
