// SPDX-License-Identifier: Apache-2.0
#include "ref/path/drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "ref/moves/move_part.hpp"
#include "ref/path/corner.hpp"

namespace curvecore::ref {
namespace {

constexpr double kStraight = 1e-9;  // mm: a straighter cubic is a line
constexpr double kCutTurn = 0.1;    // rad: sharper places are no cuts
constexpr double kNothing = 1e-9;   // mm: a shorter rest between two curves is part of one

bool is_straight(const Bezier& points) {
    const Vec3 chord = (points[3] - points[0]).normalized();
    return (points[1] - points[0]).cross(chord).norm() < kStraight &&
           (points[2] - points[0]).cross(chord).norm() < kStraight;
}

}  // namespace

Drawing::Drawing(const PathJoints& joints, const Pace& pace, const std::optional<PathCut>& begun,
                 Smoothed& report)
    : joints_(joints), pace_(pace), begun_(begun), report_(report) {
    if (begun_) reached_ = begun_->s;
}

std::deque<Move> Drawing::run(const std::optional<PathCut>& cut) {
    cut_ = cut;
    const std::size_t end = cut_ ? cut_->joint + (cut_->curve ? 0 : 1) : joints_.count();
    std::size_t first = 1;
    if (begun_ && begun_->curve) first = 1 + draw_curve(0);
    for (std::size_t i = first; i < end; ++i) {
        if (joints_[i].kind == PathJoint::Kind::kCorner) {
            round_corner(i);
        } else if (joints_[i].kind == PathJoint::Kind::kCurve) {
            i = draw_curve(i);
        }
    }
    return finish();
}

std::deque<Move> Drawing::run_as_programmed(const std::optional<PathCut>& cut) {
    cut_ = cut;
    return finish();
}

std::deque<Move> Drawing::finish() {
    copy_to(cut_ ? cut_->s : joints_.path().length());
    if (!cut_) {
        const Move& last = joints_.move(joints_.count() - 1);
        drawn_.back().exact_stop = last.exact_stop;
        drawn_.back().dwell = last.dwell;
    }
    return std::move(drawn_);
}

/// Returns true if the path before and after a move is drawn apart.
bool Drawing::free(std::size_t move) const {
    const auto apart = [this](std::size_t joint) {
        return joints_[joint].kind == PathJoint::Kind::kCorner ||
               joints_[joint].kind == PathJoint::Kind::kStop;
    };
    return !joints_.joined(move) || apart(move) || apart(move + 1);
}

bool Drawing::inside_curve(std::size_t joint) const {
    return joints_.joined(joint - 1) && joints_.joined(joint) &&
           joints_[joint - 1].kind == PathJoint::Kind::kCurve &&
           joints_[joint].kind == PathJoint::Kind::kCurve &&
           joints_[joint + 1].kind == PathJoint::Kind::kCurve;
}

std::optional<PathCut> Drawing::best_cut() const {
    const std::size_t count = joints_.count();
    const std::size_t first = std::max<std::size_t>(count / 2, 1);
    const std::size_t end = count - count / 8;  // later joints may still change
    for (std::size_t i = end; i-- > first;) {
        if (!free(i)) continue;
        double s = joints_[i].s + joints_[i].reach;
        const double after = joints_[i + 1].s - joints_[i + 1].reach;
        if (!joints_.joined(i)) {
            s = (s + after) / 2;
        } else if (joints_[i + 1].kind != PathJoint::Kind::kCurve) {
            s = after;
        }
        return PathCut{i, s, {}};
    }
    std::optional<PathCut> best;
    double least = kCutTurn;
    for (std::size_t i = first; i < end; ++i) {
        if (!inside_curve(i)) continue;
        const SeenBend seen = seen_bend(joints_.path(), joints_[i].s, joints_.tolerance());
        if (seen.turn >= least) continue;
        least = seen.turn;
        const Vec3 at = joints_.path().position(joints_[i].s);
        best = PathCut{i, joints_[i].s, TubeEnd{false, at, seen.direction, seen.bend}};
    }
    return best;
}

void Drawing::round_corner(std::size_t i) {
    const Move& before = joints_.move(i - 1);
    const Corner corner = *corner_of(before, joints_.move(i), joints_[i].reach);
    copy_to(joints_[i].s - corner.reach);
    append(before, {joints_[i].s - corner.reach, joints_[i].s + corner.reach, corner.points,
                    corner.deviation});
    drawn_.back().feed = std::min(before.feed, joints_.move(i).feed);
    reached_ = joints_[i].s + corner.reach;
    ++report_.corners;
}

TubeEnd Drawing::end_at(double s, std::size_t move, bool stop) const {
    const double local = std::clamp(s - joints_[move].s, 0.0, joints_.length(move));
    const MovePlace place = place_on(joints_.move(move), local);
    return {stop, place.position, place.tangent, place.curvature};
}

/// Extends the curve over short moves; straight joints where it would end are no joints.
std::size_t Drawing::last_of_curve(std::size_t first) const {
    std::size_t last = first;
    const std::size_t end = cut_ && cut_->curve ? cut_->joint : joints_.count();
    for (std::size_t i = first; i < end && i + 1 < joints_.count() && joints_.joined(i); ++i) {
        const PathJoint::Kind next = joints_[i + 1].kind;
        if (next == PathJoint::Kind::kCurve) last = i + 1;
        if (next != PathJoint::Kind::kCurve && next != PathJoint::Kind::kPassed) break;
    }
    return last;
}

/// Draws the curve from joint `first` on; returns the last joint that is drawn.
std::size_t Drawing::draw_curve(std::size_t first) {
    const std::size_t last = last_of_curve(first);
    if (last == first && first > 0 && joints_.lines(first) && !joints_.joined(first - 1) &&
        !joints_.joined(first)) {
        round_corner(first);
        return first;
    }
    const TubeTask task = task_of(first, last);
    const std::vector<TubePiece> pieces = tube_run(joints_.path(), task, pace_);
    if (pieces.empty()) return last;  // unchanged
    copy_to(task.from);
    std::size_t move = first > 0 ? first - 1 : 0;
    for (const TubePiece& piece : pieces) {
        while (joints_[move + 1].s < (piece.s0 + piece.s1) / 2) ++move;
        append(joints_.move(move), piece);
    }
    reached_ = task.to;
    ++report_.curves;
    report_.cubics += pieces.size();
    return last;
}

/// Sets the start of the task.
void Drawing::begin(TubeTask& task, std::size_t first) const {
    if (first == 0) {
        task.from = 0;
        task.start = *begun_->curve;
        return;
    }
    const PathJoint& before = joints_[first - 1];
    task.from = joints_.joined(first - 1) ? before.s : joints_[first].s - joints_[first].reach;
    task.from = std::max(task.from, reached_);
    const bool rest = before.kind == PathJoint::Kind::kStop && task.from == before.s;
    task.start = end_at(task.from, first - 1, rest);
}

void Drawing::end(TubeTask& task, std::size_t last) const {
    if (cut_ && cut_->curve && last == cut_->joint) {
        task.to = cut_->s;
        task.end = *cut_->curve;
        return;
    }
    const PathJoint& after = joints_[last + 1];
    task.to = joints_[last].s + joints_[last].reach;
    if (joints_.joined(last)) {
        task.to = after.kind == PathJoint::Kind::kCorner ? after.s - after.reach : after.s;
    }
    const bool rest = after.kind == PathJoint::Kind::kStop && task.to == after.s;
    task.end = end_at(task.to, last, rest);
}

TubeTask Drawing::task_of(std::size_t first, std::size_t last) const {
    TubeTask task;
    task.tolerance = joints_.tolerance();
    begin(task, first);
    end(task, last);
    for (std::size_t i = std::max<std::size_t>(first, 1); i <= last; ++i) {
        const bool changes = joints_.feed(i) != joints_.feed(i - 1);
        if (changes && joints_[i].s < task.to) task.knots.push_back(joints_[i].s);
    }
    return task;
}

/// Copies the programmed path up to s unchanged.
void Drawing::copy_to(double s) {
    while (copied_ < joints_.count() && reached_ < s) {
        const double from = joints_[copied_].s;
        const double to = joints_[copied_ + 1].s;
        if (std::min(s, to) - reached_ > kNothing) {
            const Move& move = joints_.move(copied_);
            Move part =
                part_of(move, std::max(0.0, reached_ - from), s < to ? s - from : move.length());
            if (!drawn_.empty()) part.start = drawn_.back().end;
            drawn_.push_back(part);
        }
        reached_ = std::max(reached_, std::min(s, to));
        if (to <= reached_) ++copied_;
    }
}

/// Appends a cubic with the words of a programmed move.
void Drawing::append(const Move& programmed, const TubePiece& piece) {
    Bezier points = piece.points;
    if (!drawn_.empty()) points[0] = drawn_.back().end;
    Move move;
    move.from = joints_.move(0).from + piece.s0;
    move.to = joints_.move(0).from + piece.s1;
    move.line = programmed.line;
    move.rapid = programmed.rapid;
    move.feed = programmed.feed;
    move.tolerance = programmed.tolerance;
    move.aux_start = move.aux_end = programmed.aux_start;
    move.start = points[0];
    move.end = points[3];
    move.deviation = piece.deviation + programmed.deviation;
    if (!is_straight(points)) {
        move.kind = Move::Kind::kCubic;
        move.cubic = from_bezier(points);
    }
    drawn_.push_back(move);
}

}  // namespace curvecore::ref
