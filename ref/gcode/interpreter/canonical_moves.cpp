// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/interpreter/canonical_moves.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/moves/arc_geometry.hpp"
#include "ref/moves/asked_arc.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSecondsOfMinute = 60;
constexpr double kUnitVector = 1e-6;  // largest error of a normal's length

/// Keeps groups of axes (X Y Z, A B C, U V W) that all but stand exactly in place.
Point without_trembling(Point to, const Point& at) {
    for (int group = 0; group < kMachineAxes; group += 3) {
        bool still = true;
        for (int i = group; i < group + 3; ++i) still &= std::abs(to[i] - at[i]) < kStill;
        if (still) std::copy_n(at.begin() + group, 3, to.begin() + group);
    }
    return to;
}

void check_range(double value, const char* what, const Place& place) {
    if (std::abs(value) <= kFarthest) return;
    place.refuse(fmt::format("{} is out of range: beyond {:.10g} mm", what, kFarthest));
}

}  // namespace

void CanonicalMoves::start(const Point& at) {
    if (moved_) refuse("the machine is said to stand elsewhere after its first motion", 0);
    for (const double value : at) check_range(value, "the start", place(0));
    at_ = at;
}

Move CanonicalMoves::move_to(const Target& target) const {
    const Place here = place(target.line);
    for (const double value : target.to) check_range(value, "the target", here);
    const Point to = without_trembling(target.to, at_);
    Move move;
    move.line = target.line;
    move.rapid = target.rapid;
    move.start = xyz(at_);
    move.end = xyz(to);
    move.aux_start = aux_of(at_);
    move.aux_end = aux_of(to);
    move.exact_stop = exact_stop_;
    move.tolerance = tolerance_;
    return move;
}

void CanonicalMoves::add(const Move& move, const Place& place) {
    if (!moves_.moves(move, place)) return;
    moves_.append(move);
    moved_ = true;
    for (int i = 0; i < 3; ++i) at_[i] = move.end[i];
    std::copy(move.aux_end.begin(), move.aux_end.end(), at_.begin() + 3);
}

void CanonicalMoves::line(const Target& target) {
    const Place here = place(target.line);
    Move move = move_to(target);
    if (move.length() > 0 && !target.rapid) {
        move.feed = feed_of(target.feed * kSecondsOfMinute, here);
    }
    add(move, here);
}

void CanonicalMoves::arc(const Target& target, const Vec3& centre, const Vec3& normal, int turns) {
    const Place here = place(target.line);
    if (!(std::abs(normal.norm() - 1) <= kUnitVector)) {
        here.refuse("the arc's normal is no unit vector");
    }
    if (turns < 1 || turns > kMostTurns) {
        here.refuse(fmt::format("an arc of {} turns: 1 to {} are drawn", turns, kMostTurns));
    }
    Move move = move_to(target);
    move.normal = normal.normalized();
    const Vec3 across = move.normal.unitOrthogonal();
    const Vec3 up = move.normal.cross(across);
    const auto flat = [&](const Vec3& point) -> Eigen::Vector2d {
        return {across.dot(point - centre), up.dot(point - centre)};
    };
    PlaneArc found{};
    try {
        found = arc_with_centre(flat(move.start), flat(move.end), {0, 0}, false, turns, kAnyArc);
    } catch (const ArcError& error) {
        here.refuse(error.what());
    }
    move.kind = Move::Kind::kArc;
    move.angle = found.angle;
    move.centre = centre + move.normal * move.normal.dot(move.start - centre);
    move.advance = move.normal * move.normal.dot(move.end - move.start) + across * found.drift.x() +
                   up * found.drift.y();
    move.deviation = distance({move.start, move.end, centre, move.normal, turns}, move);
    move.feed = feed_of(target.feed * kSecondsOfMinute, here);
    add(move, here);
}

void CanonicalMoves::nurbs(const Target& target, const Nurbs& nurbs) {
    const Place here = place(target.line);
    const int count = static_cast<int>(nurbs.points.size());
    if (nurbs.order < 2 || nurbs.order > std::min(kHighestOrder, count) ||
        nurbs.weights.size() != nurbs.points.size()) {
        here.refuse(fmt::format("a NURBS of order {} with {} points and {} weights", nurbs.order,
                                count, nurbs.weights.size()));
    }
    for (const double weight : nurbs.weights) {
        if (!(weight > 0)) here.refuse(fmt::format("the weight {:g} is not above 0", weight));
    }
    for (const Vec3& point : nurbs.points) {
        for (const double value : point) check_range(value, "a control point", here);
    }
    Nurbs curve = nurbs;
    curve.points.front() = xyz(at_);
    const Move whole = move_to(target);
    for (Move& piece : moves_.pieces_of(cubics_of(curve, fit_tolerance_), whole, here)) {
        piece.feed = feed_of(target.feed * kSecondsOfMinute, here);
        add(piece, here);
    }
}

void CanonicalMoves::set_path(PathControl control, double tolerance) {
    exact_stop_ = control == PathControl::kExactStop;
    tolerance_ = 0;
    if (control != PathControl::kContinuous) return;
    tolerance_ = tolerance > 0 ? std::min(tolerance, kLargestTolerance) : kPathTolerance;
    if (tolerance_ < kSmallestTolerance) tolerance_ = 0;
}

void CanonicalMoves::dwell(double seconds) {
    if (!(seconds >= 0 && seconds <= kLongestDwell)) {
        refuse(fmt::format("a dwell must be 0 to {:g} seconds, not {:g}", kLongestDwell, seconds),
               0);
    }
    if (seconds > 0) moves_.dwell(seconds, place(0));
}

void CanonicalMoves::warn(const std::string& text, int line) { moves_.warn(text, place(line)); }

void CanonicalMoves::leave_out(const std::string& code, int line, double value) {
    moves_.leave_out(code, place(line), value, true);
}

void CanonicalMoves::refuse(const std::string& reason, int line) const {
    place(line).refuse(reason);
}

}  // namespace curvecore::ref
