// SPDX-License-Identifier: Apache-2.0
#include "ref/path/smooth_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ref/feed/limits.hpp"
#include "ref/path/corner.hpp"
#include "ref/path/tube_run.hpp"
#include "ref/program/move_part.hpp"

namespace curvecore::ref {
namespace {

constexpr double kReversal = 2.6;      // rad: beyond it a joint stops
constexpr double kMeantCorner = 0.35;  // rad: one of two lines is rounded on its own
constexpr double kCornerShare = 0.45;  // of a line, that a corner may take
constexpr double kArcCorner = 3.4;     // reaches of a corner of lines, with an arc: six spans
constexpr double kStepReach = 10.5;    // sqrt(tolerance / step of the curvature): six spans
constexpr double kMiddle = 1.2;        // reaches in a move that keeps its middle
constexpr double kLongMove = 25e-3;    // s: a move beside a joint that is no part of a curve
constexpr double kNoTurn = 1e-9;       // rad
constexpr double kNoStep = 1e-9;       // 1/mm
constexpr double kStraight = 1e-9;     // mm
constexpr double kNothing = 1e-9;      // mm: what is left between two curves is part of one
constexpr double kArcError = 0.01;     // of the tolerance, of an arc's cubics

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Between two moves of a group, or at its ends.
struct Joint {
    enum class Kind { kPassed, kStop, kCorner, kCurve };
    double s = 0;
    Kind kind = Kind::kPassed;
    double reach = 0;  // mm to both sides
};

/// Whether the machine stands still at the ends of a group.
struct Rest {
    bool before;
    bool after;
};

/// Moves that follow each other with one tolerance, all rapid or none, without a stop.
class Group {
  public:
    Group(const Move* moves, std::size_t count, double tolerance, Rest rest, const Pace& pace,
          Smoothed& report)
        : moves_(moves), count_(count), tolerance_(tolerance), pace_(pace), report_(report) {
        joints_.resize(count + 1);
        for (std::size_t i = 0; i < count; ++i) {
            path_.add(moves[i], kArcError * tolerance_);
            joints_[i + 1].s = path_.length();
        }
        if (rest.before) joints_.front().kind = Joint::Kind::kStop;
        if (rest.after) joints_.back().kind = Joint::Kind::kStop;
        for (std::size_t i = 1; i < count; ++i) look_at(i);
    }

    std::vector<Move> run() {
        std::size_t i = 1;
        while (i < count_) {
            if (joints_[i].kind == Joint::Kind::kCorner) {
                round_corner(i);
            } else if (joints_[i].kind == Joint::Kind::kCurve) {
                i = draw_curve(i);
            }
            ++i;
        }
        copy_to(path_.length());
        if (!result_.empty()) {
            result_.back().exact_stop = moves_[count_ - 1].exact_stop;
            result_.back().dwell = moves_[count_ - 1].dwell;
        }
        return std::move(result_);
    }

  private:
    double length(std::size_t move) const { return joints_[move + 1].s - joints_[move].s; }
    double feed(std::size_t move) const {
        return moves_[move].rapid ? pace_.speed : std::min(pace_.speed, moves_[move].feed);
    }

    /// Whether a joint is of two lines.
    bool lines(std::size_t i) const {
        return moves_[i - 1].kind == Move::Kind::kLine && moves_[i].kind == Move::Kind::kLine;
    }

    /// Turn between chords that noise within the tolerance does not bend.
    double seen_turn(std::size_t i) const {
        const double s = joints_[i].s;
        const double reach = 3 * tolerance_;
        const Vec3 in = moves_[i].start - path_.position(std::max(0.0, s - reach));
        const Vec3 out = path_.position(std::min(path_.length(), s + reach)) - moves_[i].start;
        return angle(in, out);
    }

    void look_at(std::size_t i) {
        Joint& joint = joints_[i];
        const MovePlace before = place_on(moves_[i - 1], length(i - 1));
        const MovePlace after = place_on(moves_[i], 0);
        const double turn = angle(before.tangent, after.tangent);
        const double step = (after.curvature - before.curvature).norm();
        if (turn < kNoTurn && step < kNoStep) return;
        const double seen = seen_turn(i);
        if (turn > kReversal && seen > kReversal) {
            joint.kind = Joint::Kind::kStop;
            return;
        }
        const double shorter = std::min(length(i - 1), length(i));
        if (turn > kMeantCorner && seen > kMeantCorner) {
            const std::optional<Corner> corner =
                longest_corner(moves_[i - 1], moves_[i], tolerance_, kCornerShare * shorter);
            if (corner && corner->reach > corner_reach(turn, tolerance_) / 2) {
                joint.kind = Joint::Kind::kCorner;
                joint.reach = corner->reach;
                return;
            }
        }
        joint.kind = Joint::Kind::kCurve;
        double reach = 0;
        if (turn > kNoTurn) reach = corner_reach(std::max(turn, seen), tolerance_);
        if (turn > kMeantCorner && !lines(i)) reach *= kArcCorner;
        // Between long moves no further than the feed asks for.
        const double most = std::max(feed(i - 1), feed(i));
        const double bend = std::min(pace_.acceleration / (most * most),
                                     std::sqrt(pace_.jerk / (most * most * most)));
        if (shorter > kLongMove * most) reach = std::min(reach, 3 * turn / bend);
        if (step > kNoStep && turn < kMeantCorner)
            reach = std::max(reach, kStepReach * std::sqrt(tolerance_ / step));
        joint.reach = reach;
    }

    /// Whether a move between two joints is drawn with both.
    bool joined(std::size_t move) const {
        return length(move) <= kMiddle * (joints_[move].reach + joints_[move + 1].reach);
    }

    void round_corner(std::size_t i) {
        const Corner corner = *corner_of(moves_[i - 1], moves_[i], joints_[i].reach);
        copy_to(joints_[i].s - corner.reach);
        Move move = moves_[i - 1];
        move.feed = std::min(move.feed, moves_[i].feed);
        Bezier points = corner.points;
        if (!result_.empty()) points[0] = result_.back().end;
        append(move, points, corner.deviation);
        reached_ = joints_[i].s + corner.reach;
        ++report_.corners;
    }

    TubeEnd end_at(double s, std::size_t move, bool stop) const {
        const MovePlace place =
            place_on(moves_[move], std::clamp(s - joints_[move].s, 0.0, length(move)));
        return {stop ? TubeEnd::Given::kPosition : TubeEnd::Given::kBend, place.position,
                place.tangent, place.curvature};
    }

    /// The curve goes on over short moves; where it would end, joints that are straight are none.
    std::size_t last_of_curve(std::size_t first) const {
        std::size_t last = first;
        for (std::size_t i = first; i + 1 < count_ && joined(i); ++i) {
            const Joint::Kind next = joints_[i + 1].kind;
            if (next == Joint::Kind::kCurve) last = i + 1;
            if (next != Joint::Kind::kCurve && next != Joint::Kind::kPassed) break;
        }
        return last;
    }

    /// The last joint that is drawn.
    std::size_t draw_curve(std::size_t first) {
        const std::size_t last = last_of_curve(first);
        if (last == first && lines(first) && !joined(first - 1) && !joined(first)) {
            round_corner(first);
            return first;
        }
        TubeTask task;
        task.tolerance = tolerance_;
        bool stop = false;
        task.from = joints_[first].s - joints_[first].reach;
        if (joined(first - 1) || task.from < reached_) {
            task.from = reached_ > joints_[first - 1].s ? reached_ : joints_[first - 1].s;
            stop =
                joints_[first - 1].kind == Joint::Kind::kStop && task.from == joints_[first - 1].s;
        }
        task.start = end_at(task.from, first - 1, stop);
        task.to = joints_[last].s + joints_[last].reach;
        const Joint& next = joints_[last + 1];
        stop = false;
        if (joined(last)) {
            task.to = next.s;
            if (next.kind == Joint::Kind::kCorner) task.to -= next.reach;
            stop = next.kind == Joint::Kind::kStop;
        }
        task.end = end_at(task.to, last, stop);
        for (std::size_t i = first; i <= last; ++i) {
            if (feed(i) != feed(i - 1)) task.knots.push_back(joints_[i].s);
        }
        const std::vector<TubePiece> pieces = tube_run(path_, task, pace_);
        if (pieces.empty()) return last;  // stays as it is
        copy_to(task.from);
        std::size_t move = first - 1;
        for (const TubePiece& piece : pieces) {
            const double middle = (piece.s0 + piece.s1) / 2;
            while (joints_[move + 1].s < middle) ++move;
            Bezier points = piece.points;
            if (!result_.empty()) points[0] = result_.back().end;
            append(moves_[move], points, piece.deviation);
        }
        reached_ = task.to;
        ++report_.curves;
        report_.cubics += pieces.size();
        return last;
    }

    /// The programmed path up to s, as it is.
    void copy_to(double s) {
        while (copied_ < count_ && reached_ < s) {
            const double from = joints_[copied_].s;
            const double to = joints_[copied_ + 1].s;
            if (std::min(s, to) - reached_ > kNothing) {
                const Move& move = moves_[copied_];
                Move part = part_of(move, std::max(0.0, reached_ - from),
                                    s < to ? s - from : move.length());
                if (!result_.empty()) part.start = result_.back().end;
                result_.push_back(part);
            }
            reached_ = std::max(reached_, std::min(s, to));
            if (to <= reached_) ++copied_;
        }
    }

    void append(const Move& programmed, const Bezier& points, double deviation) {
        Move move;
        move.line = programmed.line;
        move.rapid = programmed.rapid;
        move.feed = programmed.feed;
        move.tolerance = programmed.tolerance;
        move.aux_start = move.aux_end = programmed.aux_start;
        move.start = points[0];
        move.end = points[3];
        move.deviation = deviation;
        move.kind = Move::Kind::kCubic;
        move.cubic = from_bezier(points);
        const Vec3 chord = (move.end - move.start).normalized();
        const auto off = [&](const Vec3& point) {
            const Vec3 way = point - move.start;
            return (way - way.dot(chord) * chord).norm();
        };
        if (off(points[1]) < kStraight && off(points[2]) < kStraight) {
            move.kind = Move::Kind::kLine;
            move.cubic = Cubic();
        }
        result_.push_back(move);
    }

    const Move* moves_;
    std::size_t count_;
    double tolerance_;
    const Pace& pace_;
    Smoothed& report_;
    ProgrammedPath path_;
    std::vector<Joint> joints_;
    std::vector<Move> result_;
    double reached_ = 0;      // of the path
    std::size_t copied_ = 0;  // moves that are drawn
};

bool smoothable(const Move& move) {
    return move.tolerance > 0 && move.kind != Move::Kind::kCubic && move.start != move.end &&
           move.aux_start == move.aux_end;
}

bool together(const Move& a, const Move& b) {
    return smoothable(b) && a.rapid == b.rapid && a.tolerance == b.tolerance && !a.exact_stop &&
           !(a.dwell > 0);
}

bool stops(const Move& before, const Move& after) {
    const Vec3 out = place_on(before, before.length()).tangent;
    return before.exact_stop || before.dwell > 0 ||
           angle(out, place_on(after, 0).tangent) > kSmallTurn;
}

}  // namespace

Smoothed smooth_path(Program& program, const Machine& machine, double share) {
    Smoothed report;
    report.moves = program.moves.size();
    Pace pace;
    pace.speed = machine.velocity;
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
        Group group(first, count, share * first->tolerance, rest, pace, report);
        const std::vector<Move> drawn = group.run();
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
