// SPDX-License-Identifier: Apache-2.0
#include "ref/path/smooth_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "ref/curve/angle_between.hpp"
#include "ref/feed/limits.hpp"
#include "ref/path/corner.hpp"
#include "ref/path/path_joints.hpp"
#include "ref/path/tube_run.hpp"
#include "ref/program/move_part.hpp"

namespace curvecore::ref {
namespace {

constexpr double kStraight = 1e-9;  // mm: a cubic that is a line
constexpr double kNothing = 1e-9;   // mm: what is left between two curves is part of one

bool is_straight(const Bezier& points) {
    const Vec3 chord = (points[3] - points[0]).normalized();
    return (points[1] - points[0]).cross(chord).norm() < kStraight &&
           (points[2] - points[0]).cross(chord).norm() < kStraight;
}

/// What is drawn in a group's place.
class Drawing {
  public:
    Drawing(const PathJoints& joints, const Pace& pace, Smoothed& report)
        : joints_(joints), pace_(pace), report_(report) {}

    std::vector<Move> run() {
        for (std::size_t i = 1; i < joints_.count(); ++i) {
            if (joints_[i].kind == PathJoint::Kind::kCorner) {
                round_corner(i);
            } else if (joints_[i].kind == PathJoint::Kind::kCurve) {
                i = draw_curve(i);
            }
        }
        copy_to(joints_.path().length());
        const Move& last = joints_.move(joints_.count() - 1);
        drawn_.back().exact_stop = last.exact_stop;
        drawn_.back().dwell = last.dwell;
        return std::move(drawn_);
    }

  private:
    void round_corner(std::size_t i) {
        const Move& before = joints_.move(i - 1);
        const Corner corner = *corner_of(before, joints_.move(i), joints_[i].reach);
        copy_to(joints_[i].s - corner.reach);
        append(before, corner.points, corner.deviation);
        drawn_.back().feed = std::min(before.feed, joints_.move(i).feed);
        reached_ = joints_[i].s + corner.reach;
        ++report_.corners;
    }

    TubeEnd end_at(double s, std::size_t move, bool stop) const {
        const double local = std::clamp(s - joints_[move].s, 0.0, joints_.length(move));
        const MovePlace place = place_on(joints_.move(move), local);
        return {stop, place.position, place.tangent, place.curvature};
    }

    /// The curve goes on over short moves; where it would end, joints that are straight are none.
    std::size_t last_of_curve(std::size_t first) const {
        std::size_t last = first;
        for (std::size_t i = first; i + 1 < joints_.count() && joints_.joined(i); ++i) {
            const PathJoint::Kind next = joints_[i + 1].kind;
            if (next == PathJoint::Kind::kCurve) last = i + 1;
            if (next != PathJoint::Kind::kCurve && next != PathJoint::Kind::kPassed) break;
        }
        return last;
    }

    /// From joint `first` on; the last joint that is drawn.
    std::size_t draw_curve(std::size_t first) {
        const std::size_t last = last_of_curve(first);
        if (last == first && joints_.lines(first) && !joints_.joined(first - 1) &&
            !joints_.joined(first)) {
            round_corner(first);
            return first;
        }
        const TubeTask task = task_of(first, last);
        const std::vector<TubePiece> pieces = tube_run(joints_.path(), task, pace_);
        if (pieces.empty()) return last;  // stays as it is
        copy_to(task.from);
        std::size_t move = first - 1;
        for (const TubePiece& piece : pieces) {
            while (joints_[move + 1].s < (piece.s0 + piece.s1) / 2) ++move;
            append(joints_.move(move), piece.points, piece.deviation);
        }
        reached_ = task.to;
        ++report_.curves;
        report_.cubics += pieces.size();
        return last;
    }

    TubeTask task_of(std::size_t first, std::size_t last) const {
        TubeTask task;
        task.tolerance = joints_.tolerance();
        const PathJoint& before = joints_[first - 1];
        const PathJoint& after = joints_[last + 1];
        task.from = joints_[first].s - joints_[first].reach;
        task.to = joints_[last].s + joints_[last].reach;
        if (joints_.joined(first - 1)) task.from = before.s;
        if (joints_.joined(last)) {
            task.to = after.kind == PathJoint::Kind::kCorner ? after.s - after.reach : after.s;
        }
        task.from = std::max(task.from, reached_);
        const bool rest_before = before.kind == PathJoint::Kind::kStop && task.from == before.s;
        const bool rest_after = after.kind == PathJoint::Kind::kStop && task.to == after.s;
        task.start = end_at(task.from, first - 1, rest_before);
        task.end = end_at(task.to, last, rest_after);
        for (std::size_t i = first; i <= last; ++i) {
            if (joints_.feed(i) != joints_.feed(i - 1)) task.knots.push_back(joints_[i].s);
        }
        return task;
    }

    /// The programmed path up to s, as it is.
    void copy_to(double s) {
        while (copied_ < joints_.count() && reached_ < s) {
            const double from = joints_[copied_].s;
            const double to = joints_[copied_ + 1].s;
            if (std::min(s, to) - reached_ > kNothing) {
                const Move& move = joints_.move(copied_);
                Move part = part_of(move, std::max(0.0, reached_ - from),
                                    s < to ? s - from : move.length());
                if (!drawn_.empty()) part.start = drawn_.back().end;
                drawn_.push_back(part);
            }
            reached_ = std::max(reached_, std::min(s, to));
            if (to <= reached_) ++copied_;
        }
    }

    /// A cubic with the words of a programmed move.
    void append(const Move& programmed, Bezier points, double deviation) {
        if (!drawn_.empty()) points[0] = drawn_.back().end;
        Move move;
        move.line = programmed.line;
        move.rapid = programmed.rapid;
        move.feed = programmed.feed;
        move.tolerance = programmed.tolerance;
        move.aux_start = move.aux_end = programmed.aux_start;
        move.start = points[0];
        move.end = points[3];
        move.deviation = deviation;
        if (!is_straight(points)) {
            move.kind = Move::Kind::kCubic;
            move.cubic = from_bezier(points);
        }
        drawn_.push_back(move);
    }

    const PathJoints& joints_;
    const Pace& pace_;
    Smoothed& report_;
    std::vector<Move> drawn_;
    double reached_ = 0;      // of the path
    std::size_t copied_ = 0;  // moves that are drawn
};

bool smoothable(const Move& move) {
    const bool moves = move.kind == Move::Kind::kArc || move.start != move.end;  // X Y Z
    return move.tolerance > 0 && move.kind != Move::Kind::kCubic && moves &&
           move.aux_start == move.aux_end;
}

bool together(const Move& a, const Move& b) {
    return smoothable(b) && a.rapid == b.rapid && a.tolerance == b.tolerance && !a.exact_stop &&
           !(a.dwell > 0);
}

bool stops(const Move& before, const Move& after) {
    const Vec3 out = place_on(before, before.length()).tangent;
    return before.exact_stop || before.dwell > 0 ||
           angle_between(out, place_on(after, 0).tangent) > kSmallTurn;
}

}  // namespace

Smoothed smooth_path(Program& program, const Machine& machine, double share) {
    Smoothed report;
    report.moves = program.moves.size();
    Pace pace;
    pace.speed = machine.velocity;
    pace.joint_time = machine.joint_time;
    pace.acceleration = kAccelerationShare * machine.acceleration;
    pace.jerk = kJerkShare * machine.jerk;
    std::vector<Move> moves;
    for (std::size_t i = 0; i < program.moves.size();) {
        const Move* first = &program.moves[i];
        if (!smoothable(*first)) {
            moves.push_back(*first);
            ++i;
            continue;
        }
        std::size_t count = 1;
        while (i + count < program.moves.size() && together(first[count - 1], first[count])) {
            ++count;
        }
        const Rest rest{i == 0 || stops(first[-1], *first),
                        i + count == program.moves.size() || stops(first[count - 1], first[count])};
        const PathJoints joints(first, count, share * first->tolerance, rest, pace);
        const std::vector<Move> drawn = Drawing(joints, pace, report).run();
        moves.insert(moves.end(), drawn.begin(), drawn.end());
        i += count;
    }
    program.moves = std::move(moves);
    look_again(program, report);
    return report;
}

void look_again(const Program& program, Smoothed& smoothed) {
    smoothed.tolerance = smoothed.deviation = smoothed.share = 0;
    for (const Move& move : program.moves) {
        smoothed.tolerance = std::max(smoothed.tolerance, move.tolerance);
        smoothed.deviation = std::max(smoothed.deviation, move.deviation);
        const double share = move.deviation > 0 ? move.deviation / move.tolerance : 0;
        if (share > smoothed.share) {
            smoothed.share = share;
            smoothed.line = move.line;
        }
    }
}

}  // namespace curvecore::ref
