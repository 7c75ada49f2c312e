// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/tool_meter.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::sysc {
namespace {

ref::Vec3 vec(const ToolMeter::Point& point) { return {point[0], point[1], point[2]}; }

/// Distance of a point from the way between two others.
double distance(const ref::Vec3& point, const ref::Vec3& from, const ref::Vec3& to) {
    const ref::Vec3 way = to - from;
    const double square = way.squaredNorm();
    const double part = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
    return (from + part * way - point).norm();
}

/// Samples of the path that count: those of the taps, and until the tool is there.
std::size_t kept(const std::array<ref::ShaperTaps, ref::kMachineAxes>& taps, int late) {
    auto most = static_cast<std::size_t>(late);
    for (const ref::ShaperTaps& axis : taps) {
        most = std::max(most, 2 * static_cast<std::size_t>(axis.delay));
    }
    constexpr std::size_t kMore = 5;  // of the path ahead of where the tool should be
    return most + kMore;
}

}  // namespace

SwingingMass::SwingingMass(const ref::Vibration& mode, double period_s, double place)
    : rigid_(mode.hertz == 0), period_(period_s), drive_(place), place_(place) {
    if (rigid_) return;
    const double w = 2 * M_PI * mode.hertz;
    const double root = std::sqrt(1 - mode.damping * mode.damping);
    const double left = std::exp(-mode.damping * w * period_s);
    const double c = left * std::cos(w * root * period_s);
    const double s = left * std::sin(w * root * period_s) / root;
    lag_ = 2 * mode.damping / w;
    go_ = {{{c + mode.damping * s, s / w}, {-w * s, c - mode.damping * s}}};
}

double SwingingMass::follow(double drive) {
    if (rigid_) return place_ = drive;
    // Behind a drive of constant speed it would be lag_ late; what it is off that swings.
    const double speed = (drive - drive_) / period_;
    const double place = place_ - (drive_ - lag_ * speed);
    const double moves = speed_ - speed;
    place_ = go_[0][0] * place + go_[0][1] * moves + drive - lag_ * speed;
    speed_ = go_[1][0] * place + go_[1][1] * moves + speed;
    drive_ = drive;
    return place_;
}

bool ToolMeter::is_asked(const ref::Machine& machine) {
    return std::any_of(machine.modes.begin(), machine.modes.end(),
                       [](const ref::Vibration& mode) { return mode.hertz > 0; });
}

ToolMeter::ToolMeter(const ref::Machine& machine, double unit_mm, double period_s,
                     int samples_per_tick, int axes)
    : machine_(machine),
      unit_mm_(unit_mm),
      period_s_(period_s),
      axes_(static_cast<std::size_t>(axes)),
      taps_(ref::shaper_taps(machine, period_s, kMostDelay)),
      kept_(kept(taps_, std::max(ref::tool_delay(machine, {}, period_s),
                                 ref::tool_delay(machine, taps_, period_s)))),
      drives_(machine, unit_mm, period_s, samples_per_tick, axes) {}

void ToolMeter::take(const Point& point, std::size_t segment) {
    if (points_.empty()) {
        points_.assign(kept_, point);
        for (std::size_t axis = 0; axis < axes_; ++axis) {
            const SwingingMass mass(machine_.modes[axis], period_s_, point[axis]);
            without_.masses.push_back(mass);
            shaped_.masses.push_back(mass);
        }
        drives_.take(point, segment);
        return;
    }
    step(point);
    drives_.take(shaped(), segment);
    segment_ = segment;
}

ToolResult ToolMeter::finish() {
    if (points_.empty()) return {};
    const Point last = points_.front();
    without_.rests = true;
    for (std::size_t n = 0; n < kept_; ++n) {
        step(last);
        drives_.take(shaped(), segment_);
    }
    shaped_.rests = true;
    double least = 0;  // Hz
    for (const ref::Vibration& mode : machine_.modes) {
        if (mode.hertz > 0 && (least == 0 || mode.hertz < least)) least = mode.hertz;
    }
    for (double time = 0; time < 1 / least; time += period_s_) step(last);
    return {ref::tool_delay(machine_, taps_, period_s_) * period_s_, without_.path, shaped_.path,
            drives_.finish()};
}

void ToolMeter::step(const Point& point) {
    points_.pop_back();
    points_.push_front(point);
    follow(without_, point);
    follow(shaped_, shaped());
}

/// Returns the place that the drives are given: hls/input_shaper.hpp, in real numbers.
ToolMeter::Point ToolMeter::shaped() const {
    Point q{};
    for (std::size_t axis = 0; axis < axes_; ++axis) {
        const ref::ShaperTaps& taps = taps_[axis];
        const auto k = static_cast<std::size_t>(taps.delay);
        const double now = points_[0][axis];
        const double before = points_[k][axis];
        const double last = points_[2 * k][axis];
        q[axis] = before + taps.near * (now - before) + taps.far * (before - last);
    }
    return q;
}

void ToolMeter::follow(Tool& tool, const Point& drives) {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
        const double place = tool.masses[axis].follow(drives[axis]);
        if (axis < 3) tool.place[static_cast<int>(axis)] = place;
    }
    double& worst = tool.rests ? tool.path.rest : tool.path.off;
    const double away = tool.rests ? (tool.place - vec(points_.front())).norm() : off(tool);
    worst = std::max(worst, unit_mm_ * away);
}

/// Distance from the path of the last samples, units.
double ToolMeter::off(const Tool& tool) const {
    double least = (tool.place - vec(points_.front())).norm();
    for (std::size_t n = 1; n < kept_; ++n) {
        least = std::min(least, distance(tool.place, vec(points_[n - 1]), vec(points_[n])));
    }
    return least;
}

}  // namespace curvecore::sysc
