// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/velocity_course.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kRest = 1e-9;  // mm/s
// Of an acceleration and of kStraight A T: so little that the jumps of all joints of a window are
// nothing.
constexpr double kSameShare = 1e-6;

double position(const Phase& phase, double t) { return static_cast<double>(phase.place(t)); }

double speed(const Phase& phase, double t) { return std::max(0.0, phase.speed(t)); }

double local_length(const Segment& segment) {
    return std::ldexp(static_cast<double>(segment.length), -16);
}

bool is_line(const Segment& segment) {
    return segment.kind == Segment::Kind::kArc && segment.radius == 0;
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
    if (v < kRest) return {};  // a spline may stand still there, without a direction
    const Segment& at = segments_[segment];
    const Vec3 xyz = v * curve_.direction(at, std::max(0.0, s));
    AxisVector velocity{xyz.x(), xyz.y(), xyz.z()};
    for (std::size_t i = 3; i < axes_; ++i) velocity[i] = v * at.aux_advance[i - 3];
    return velocity;
}

void VelocityCourse::run(const std::vector<Phase>& phases, std::size_t first_segment,
                         std::size_t last_segment) {
    std::size_t segment = first_segment;
    const auto path = [&](std::uint64_t s) {  // mm in this run
        return static_cast<double>(s - segments_[first_segment].s_start) * unit_mm_ / 65536;
    };
    const auto place = [&](double t, double s, double v) {
        const double local = (s - path(segments_[segment].s_start)) / unit_mm_;
        const AxisVector now = velocity(segment, local, v);
        knots_.push_back({t, v, now, now, 0, false});
    };
    place(time_, 0, speed(phases.front(), 0));
    for (const Phase& phase : phases) {
        const double end = position(phase, phase.duration);
        bool leaves = true;  // the segment, within this phase
        for (double from = 0; leaves;) {
            const Segment& on = segments_[segment];
            const double edge = path(on.s_start + on.length);
            leaves = segment < last_segment && edge <= end;
            const double to = leaves ? time_at(phase, from, edge) : phase.duration;
            const std::size_t first = knots_.size() - 1;
            place(time_ + to, leaves ? edge : end, speed(phase, to));
            const Knot last = knots_.back();
            if ((phase.j != 0 || !is_line(on)) && to - from > resolution_) {
                const double half = from + (to - from) / 2;
                place(time_ + half, position(phase, half), speed(phase, half));
                const double off = distance(knots_.back(), knots_[first], last);
                const int parts = count(to - from, off, is_line(on));
                knots_.resize(first + 1);
                for (int i = 1; i < parts; ++i) {
                    const double t = from + (to - from) * i / parts;
                    place(time_ + t, position(phase, t), speed(phase, t));
                }
                knots_.push_back(last);
            }
            from = to;
            if (!leaves) break;
            const Segment& next = segments_[++segment];
            Knot& knot = knots_.back();
            const bool joint = on.move != next.move;
            const Vec3 bend = joint ? curve_.bend(on, local_length(on)) : Vec3::Zero();
            knot.after = velocity(segment, 0, knot.v);
            if (!joint || passes(knot, (curve_.bend(next, 0) - bend).norm() / unit_mm_)) continue;
            knot.s = next.s_start;
            knot.joint = true;
            joints_.push_back(knots_.size() - 1);
        }
        time_ += phase.duration;
    }
}

/// Whether neither V nor V' jumps, by the bend's jump, 1/mm: V goes on as it does inside a move.
bool VelocityCourse::passes(const Knot& knot, double bend) const {
    if (!(knot.v * knot.v * bend <= kSameShare * least_acceleration_)) return false;
    double square = 0;
    for (std::size_t i = 0; i < axes_; ++i) {
        square += (knot.after[i] - knot.before[i]) * (knot.after[i] - knot.before[i]);
    }
    return std::sqrt(square) <= kSameShare * precision_;
}

/// Of V in the middle from the straight line.
double VelocityCourse::distance(const Knot& middle, const Knot& from, const Knot& to) const {
    double square = 0;
    for (std::size_t i = 0; i < axes_; ++i) {
        const double off = middle.before[i] - (from.after[i] + to.before[i]) / 2;
        square += off * off;
    }
    return std::sqrt(square);
}

/// Straight parts of a time over which one would be `off` in the middle.
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
