// SPDX-License-Identifier: Apache-2.0
#include "ref/path/path_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/curve/angle_between.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/path/corner.hpp"

namespace curvecore::ref {
namespace {

constexpr double kReversal = 2.6;      // rad: a sharper joint is a stop
constexpr double kMeantCorner = 0.35;  // rad: above it a corner of long moves is rounded alone
constexpr double kCornerShare = 0.45;  // share of a move that a corner may take
constexpr double kArcCorner = 3.4;     // times a corner of lines, with an arc: six spans
constexpr double kStepReach = 10.5;    // sqrt(tolerance / step of the curvature): six spans
constexpr double kBendReach = 3;       // turn / curvature
constexpr double kThirdReach = 3;      // turn / third derivative, of its square
constexpr double kMiddle = 1.2;        // reaches in a move that keeps its middle
constexpr double kLongMove = 25e-3;    // s: a longer move beside a joint is not part of a curve
constexpr double kNoTurn = 1e-9;       // rad
constexpr double kNoStep = 1e-9;       // 1/mm
constexpr double kOneLine = 1e-10;     // mm: largest error of lines in one direction
constexpr double kArcError = 0.01;     // share of the tolerance for the error of an arc's cubics

bool one_line(const Move& a, const Move& b) {
    if (a.kind != Move::Kind::kLine || b.kind != Move::Kind::kLine || a.feed != b.feed) {
        return false;
    }
    const double turn = angle_between(a.end - a.start, b.end - b.start);
    return turn < kNoTurn && turn * b.length() < kOneLine;
}

}  // namespace

std::size_t PathJoints::parts(const Move& move, double tolerance) {
    return ProgrammedPath::parts(move, kArcError * tolerance);
}

PathJoints::PathJoints(const std::vector<Move>& moves, double tolerance, Rest rest,
                       const std::optional<PathJoint>& first, const Pace& pace)
    : tolerance_(tolerance), pace_(pace) {
    for (const Move& move : moves) {
        if (!moves_.empty() && one_line(moves_.back(), move)) {
            moves_.back().end = move.end;
            moves_.back().to = move.to;
            moves_.back().exact_stop = move.exact_stop;
            moves_.back().dwell = move.dwell;
        } else {
            moves_.push_back(move);
        }
    }
    joints_.resize(moves_.size() + 1);
    for (std::size_t i = 0; i < moves_.size(); ++i) {
        path_.add(moves_[i], kArcError * tolerance_);
        joints_[i + 1].s = path_.length();
    }
    if (rest.before) joints_.front().kind = PathJoint::Kind::kStop;
    if (rest.after) joints_.back().kind = PathJoint::Kind::kStop;
    if (first) {
        joints_.front() = *first;
        joints_.front().s = 0;
    }
    for (std::size_t i = 1; i < moves_.size(); ++i) look_at(i);
}

double PathJoints::feed(std::size_t move) const {
    const double most = pace_.velocity.path;
    return moves_[move].rapid ? most : std::min(most, moves_[move].feed);
}

/// Speed that the axes allow of a feed, mm/s.
double PathJoints::speed(std::size_t move) const {
    const Move& on = moves_[move];
    const bool line = on.kind == Move::Kind::kLine;
    return std::min(feed(move),
                    pace_.velocity.along(line ? Vec3(on.end - on.start) : Vec3(0, 0, 0)));
}

bool PathJoints::lines(std::size_t joint) const {
    return moves_[joint - 1].kind == Move::Kind::kLine && moves_[joint].kind == Move::Kind::kLine;
}

bool PathJoints::joined(std::size_t move) const {
    return length(move) <= kMiddle * (joints_[move].reach + joints_[move + 1].reach);
}

/// Returns true if both moves last too long to be parts of one curve.
bool PathJoints::is_long(std::size_t joint) const {
    return std::min(length(joint - 1) / speed(joint - 1), length(joint) / speed(joint)) > kLongMove;
}

/// Returns true if a joint may be passed at the feed: over the joint time (ref/limits/limits.hpp)
/// neither the change of velocity nor that of v^2 r'' asks for more than the allowed jerk.
bool PathJoints::passed(std::size_t joint, const Change& change) const {
    const double v = std::max(speed(joint - 1), speed(joint));
    const double t = pace_.joint_time;
    return v * pace_.acceleration.load(change.turn) <= t &&
           v * pace_.jerk.load(change.turn) <= t * t && v * v * pace_.jerk.load(change.step) <= t;
}

void PathJoints::look_at(std::size_t i) {
    PathJoint& joint = joints_[i];
    const MovePlace before = place_on(moves_[i - 1], moves_[i - 1].length());
    const MovePlace after = place_on(moves_[i], 0);
    const Change change{before.tangent, after.tangent - before.tangent,
                        after.curvature - before.curvature};
    const double turn = angle_between(before.tangent, after.tangent);
    if (turn < kNoTurn && change.step.norm() < kNoStep) return;
    if (is_long(i) && passed(i, change)) return;
    const double seen = seen_turn(path_, joint.s, tolerance_);
    if (turn > kReversal && seen > kReversal) {
        joint.kind = PathJoint::Kind::kStop;
        return;
    }
    if (turn > kMeantCorner && seen > kMeantCorner) {
        const double most = kCornerShare * std::min(length(i - 1), length(i));
        const std::optional<Corner> corner =
            longest_corner(moves_[i - 1], moves_[i], tolerance_, most);
        if (corner && corner->reach > corner_reach(turn, tolerance_) / 2) {
            joint.kind = PathJoint::Kind::kCorner;
            joint.reach = corner->reach;
            return;
        }
    }
    joint.kind = PathJoint::Kind::kCurve;
    joint.reach = curve_reach(i, turn > kNoTurn ? std::max(turn, seen) : 0, change);
}

double PathJoints::curve_reach(std::size_t i, double turn, const Change& change) const {
    double reach = turn > 0 ? corner_reach(turn, tolerance_) : 0;
    if (turn > kMeantCorner) return lines(i) ? reach : kArcCorner * reach;
    if (turn > 0 && is_long(i)) reach = std::min(reach, asked_reach(i, turn, change));
    const double step = change.step.norm();
    return step > kNoStep ? std::max(reach, kStepReach * std::sqrt(tolerance_ / step)) : reach;
}

/// Reach that a corner needs for the feed: its curvature is 4/3 turn / reach at most, its third
/// derivative 2.64 turn / reach^2.
double PathJoints::asked_reach(std::size_t i, double turn, const Change& change) const {
    const double v = std::max(speed(i - 1), speed(i));
    const double bend = std::min(pace_.acceleration.along(change.turn) / (v * v),
                                 std::sqrt(pace_.jerk.along(change.direction) / (v * v * v)));
    const double third = pace_.jerk.along(change.turn) / (v * v * v);
    return std::max(kBendReach * turn / bend, std::sqrt(kThirdReach * turn / third));
}

}  // namespace curvecore::ref
