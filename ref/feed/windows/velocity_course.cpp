// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/windows/velocity_course.hpp"

#include <algorithm>
#include <cmath>

#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr double kRestSpeed = 1e-9;  // mm/s
// Share of an acceleration and of kStraight A T at which the jumps of all joints of a window are
// negligible.
constexpr double kSameShare = 1e-6;
constexpr std::size_t kMany = 1 << 14;  // knots of a part: 3 MB
constexpr double kReaches = 20;         // reaches of a part at least: two of them are in two parts

double position(const Phase& phase, double t) { return static_cast<double>(phase.place(t)); }

double speed(const Phase& phase, double t) { return std::max(0.0, phase.speed(t)); }

double local_length(const Segment& segment) {
    return std::ldexp(static_cast<double>(segment.length), -16);
}

}  // namespace

VelocityCourse::VelocityCourse(const std::vector<Segment>& segments, double unit_mm, int axes,
                               const Machine& machine)
    : segments_(segments),
      unit_mm_(unit_mm),
      axes_(static_cast<std::size_t>(axes)),
      resolution_(machine.joint_time) {
    const double straight = kStraight * machine.joint_time;
    const auto add = [&](double acceleration, double jerk) {
        resolution_ = std::min(resolution_, std::sqrt(8 * straight * acceleration / jerk));
        precision_ = std::min(precision_, straight * acceleration);
        least_acceleration_ = std::min(least_acceleration_, acceleration);
    };
    add(machine.acceleration, machine.jerk);
    for (std::size_t i = 0; i < axes_; ++i) {
        add(machine.axis[i].acceleration, machine.axis[i].jerk);
    }
}

AxisVector VelocityCourse::velocity(std::size_t segment, double s, double v) {
    if (v < kRestSpeed) return {};  // a spline may stand still there, without a direction
    const Segment& at = segments_[segment];
    const Vec3 xyz = v * curve_.on(at).direction(std::max(0.0, s));
    AxisVector velocity{xyz.x(), xyz.y(), xyz.z()};
    for (std::size_t i = 3; i < axes_; ++i) velocity[i] = v * at.aux_advance[i - 3];
    return velocity;
}

void VelocityCourse::run(const std::vector<Phase>& phases, std::size_t first_segment,
                         std::size_t last_segment) {
    std::size_t segment = first_segment;
    const auto path = [&](std::uint64_t s) {  // mm in this run
        return static_cast<double>(s - segments_[first_segment].s_start) * kQuantum * unit_mm_;
    };
    for (const Phase& phase : phases) {
        const double end = position(phase, phase.duration);
        bool leaves = true;  // leaves the segment within this phase
        for (double from = 0; leaves;) {
            const Segment& on = segments_[segment];
            const double start = path(on.s_start);
            const double edge = path(on.s_start + on.length);
            leaves = segment < last_segment && edge <= end;
            const double to = leaves ? time_at(phase, from, edge) : phase.duration;
            Piece piece{&phase, from, to, time_ + from, start, segment, leaves, false};
            piece.joint = leaves && is_joint(piece);
            if (piece.joint) all_joints_.push_back({piece.end(), segments_[segment + 1].s_start});
            pieces_.push_back(piece);
            from = to;
            if (leaves) ++segment;
        }
        time_ += phase.duration;
    }
}

/// Returns true if V or V' jumps at the end of a move: a joint.
bool VelocityCourse::is_joint(const Piece& piece) {
    const Segment& on = segments_[piece.segment];
    const Segment& next = segments_[piece.segment + 1];
    if (on.move == next.move) return false;
    const double v = speed(*piece.phase, piece.to);
    const double length = local_length(on);
    const double bend = (curve_.on(on).bend(length) - curve_.on(next).bend(0)).norm() / unit_mm_;
    if (!(v * v * bend <= kSameShare * least_acceleration_)) return true;
    const AxisVector before = velocity(piece.segment, length, v);
    const AxisVector after = velocity(piece.segment + 1, 0, v);
    double square = 0;
    for (std::size_t i = 0; i < axes_; ++i) {
        square += (after[i] - before[i]) * (after[i] - before[i]);
    }
    return std::sqrt(square) > kSameShare * precision_;
}

std::size_t VelocityCourse::look_at(std::size_t first, double reach) {
    knots_.clear();
    joints_.clear();
    const double begin = all_joints_[first].t - reach;
    const auto ended = [](const Piece& piece, double t) { return piece.end() < t; };
    auto piece = std::lower_bound(pieces_.begin(), pieces_.end(), begin, ended);
    std::size_t next = first;  // joint behind the piece
    while (next > 0 && piece != pieces_.end() && all_joints_[next - 1].t >= piece->end()) --next;
    std::size_t done = first;
    bool goes_on = false;
    for (; piece != pieces_.end(); ++piece) {
        const double near_since =
            next < all_joints_.size() ? all_joints_[next].t - reach : kUnlimited;
        const double near_until = next > 0 ? all_joints_[next - 1].t + reach : -kUnlimited;
        const bool near = piece->t <= near_until || piece->end() >= near_since;
        if (near) {
            if (!goes_on) knots_.push_back(knot(*piece, 0));
            add_knots(*piece, near_until, near_since);
        } else if (next == all_joints_.size()) {
            break;
        }
        goes_on = near;
        if (piece->joint) ++next;
        while (done < all_joints_.size() && all_joints_[done].t + reach <= piece->end()) ++done;
        if (done > first && knots_.size() > kMany && piece->end() > begin + kReaches * reach) {
            return done;
        }
    }
    return all_joints_.size();
}

/// The knot at a time of a piece, at its end perhaps on the next segment.
VelocityCourse::Knot VelocityCourse::knot(const Piece& piece, double after) {
    const double t = piece.from + after;
    const double v = speed(*piece.phase, t);
    const double s = (position(*piece.phase, t) - piece.start) / unit_mm_;
    const AxisVector now = velocity(piece.segment, s, v);
    return {piece.t + after, v, now, now, 0, false};
}

/// Adds the knots behind the piece's start: up to `until`, from `since` on, and the piece's end.
void VelocityCourse::add_knots(const Piece& piece, double until, double since) {
    const Segment& on = segments_[piece.segment];
    const double time = piece.to - piece.from;
    Knot last = knot(piece, time);
    if (piece.leaves) {
        last.before = velocity(piece.segment, local_length(on), last.v);
        last.after = last.before;
    }
    const bool line = curve_.on(on).straight();
    if ((piece.phase->j != 0 || !line) && time > resolution_) {
        const Knot middle = knot(piece, time / 2);
        const int parts = count(time, distance(middle, knots_.back(), last), line);
        for (int i = 1; i < parts; ++i) {
            const double after = time * i / parts;
            const double t = piece.t + after;
            if (t <= until || t >= since) knots_.push_back(knot(piece, after));
        }
    }
    if (piece.leaves) last.after = velocity(piece.segment + 1, 0, last.v);
    last.joint = piece.joint;
    if (piece.joint) {
        last.s = segments_[piece.segment + 1].s_start;
        joints_.push_back(knots_.size());
    }
    knots_.push_back(last);
}

/// Distance of V in the middle from the straight line.
double VelocityCourse::distance(const Knot& middle, const Knot& from, const Knot& to) const {
    double square = 0;
    for (std::size_t i = 0; i < axes_; ++i) {
        const double off = middle.before[i] - (from.after[i] + to.before[i]) / 2;
        square += off * off;
    }
    return std::sqrt(square);
}

/// Number of straight parts of a time over which one would be `off` in the middle.
int VelocityCourse::count(double time, double off, bool line) const {
    const double most = std::ceil(time / resolution_);
    const double least = line ? 1 : std::min(most, 8.0);  // curvature may vary
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(off / precision_)), least, most));
}

AxisVector VelocityCourse::at(double t, std::size_t& knot) const {
    while (knot > 0 && knots_[knot].t > t) --knot;
    while (knot + 1 < knots_.size() && knots_[knot + 1].t <= t) ++knot;
    const Knot& from = knots_[knot];
    if (t < from.t || knot + 1 == knots_.size()) return {};  // at rest
    const Knot& to = knots_[knot + 1];
    const double part = (t - from.t) / (to.t - from.t);
    AxisVector v{};
    for (std::size_t i = 0; i < axes_; ++i) {
        v[i] = from.after[i] + (to.before[i] - from.after[i]) * part;
    }
    return v;
}

}  // namespace curvecore::ref
