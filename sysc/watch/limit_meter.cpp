// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/limit_meter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace curvecore::sysc {
namespace {

constexpr double kDense = 20;  // sufficient number of samples in the shortest window

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

/// Norm of X Y Z, or of U V W where X Y Z do not move.
template <class Value>
double path_length(int axes, Value value) {
    const double xyz = length(value(0), value(1), value(2));
    if (xyz > 0 || axes < 7) return xyz;
    return length(value(6), axes > 7 ? value(7) : 0, axes > 8 ? value(8) : 0);
}

}  // namespace

bool LimitLoads::resolved() const {
    return std::any_of(windows.begin(), windows.end(),
                       [](const WindowLoads& window) { return !window.of.empty(); });
}

double LimitLoads::most() const {
    return std::max({worst[0].ratio, worst[1].ratio, worst[2].ratio});
}

double LimitLoads::rounding() const {
    double most = 0;
    for (const WindowLoads& window : windows) {
        if (window.of.empty()) continue;
        most = std::max(most, *std::max_element(window.rounding.begin(), window.rounding.end()));
    }
    return most;
}

LimitMeter::LimitMeter(const ref::Machine& machine, double unit_mm, double period_s,
                       int samples_per_tick, int axes, double error,
                       const std::vector<double>& windows)
    : axes_(axes),
      unit_mm_(unit_mm),
      stride_(static_cast<std::uint64_t>(samples_per_tick) *
              static_cast<std::uint64_t>(std::max(
                  1.0, std::floor(windows.front() / (kDense * period_s * samples_per_tick))))),
      step_(static_cast<double>(stride_) * period_s),
      kinematics_(machine.kinematics),
      error_mm_(error * unit_mm) {
    std::size_t longest = 0;
    for (const double seconds : windows) {
        loads_.windows.push_back({seconds, {}, {}});
        const double ticks = seconds / (period_s * samples_per_tick) * (1 + 1e-9);
        if (ticks < kLeastTicks || seconds < machine.joint_time * (1 - 1e-9)) continue;
        loads_.windows.back().of.resize(static_cast<std::size_t>(axes) + 1);
        const auto steps = static_cast<std::size_t>(std::llround(seconds / step_));
        windows_.push_back({steps, loads_.windows.size() - 1});
        longest = std::max(longest, steps);
    }
    std::size_t ring = 2;
    while (ring < 2 * longest + 2) ring *= 2;
    mask_ = ring - 1;
    place_.resize(ring);
    velocity_.resize(ring, Point{});
    if (!ref::is_trivial(kinematics_)) {
        tool_.resize(ring);
        tool_velocity_.resize(ring, ref::Vec3::Zero());
    }
    allow(machine, error * unit_mm);
}

void LimitMeter::allow(const ref::Machine& machine, double error) {
    const double t = machine.joint_time;
    for (const Window& window : windows_) {
        const double w = static_cast<double>(window.steps) * step_;
        std::vector<std::array<double, 3>>& allowed = allowed_.emplace_back();
        for (int of = 0; of <= axes_; ++of) {
            const ref::AxisLimits& axis =
                machine.axis[static_cast<std::size_t>(std::max(0, of - 1))];
            const double v = of == 0 ? machine.velocity : axis.velocity;
            const double a = of == 0 ? machine.acceleration : axis.acceleration;
            const double j = of == 0 ? machine.jerk : axis.jerk;
            const double off = of == 0 ? std::sqrt(3.0) * error : error;
            const std::array<double, 3> rounding{2 * off, 4 * off / step_, 8 * off / step_};
            allowed.push_back({v * w, a * (w + t), j * w * (w + t) + a * t});
            for (std::size_t i = 0; i < 3; ++i) {
                allowed.back()[i] += rounding[i];
                if (of == 0) {
                    loads_.windows[window.loads].rounding[i] = rounding[i] / allowed.back()[i];
                }
            }
        }
    }
}

std::optional<LimitMeter::Longest> LimitMeter::look_with(Look look) {
    if (windows_.empty()) return std::nullopt;
    look_ = std::move(look);
    const double w = static_cast<double>(windows_.back().steps) * step_;
    const std::array<double, 3>& allowed = allowed_.back().front();
    return Longest{w, allowed[kAcceleration] / w, allowed[kJerk] / (w * w)};
}

void LimitMeter::take(const Point& point, std::size_t segment) {
    last_ = point;
    segment_ = segment;
    if (samples_++ % stride_ == 0) place(point);
}

const LimitLoads& LimitMeter::finish() {
    const std::uint64_t last = samples_ - 1;
    for (std::size_t i = 0; i <= mask_; ++i) place(last_);
    for (LimitLoads::Worst& worst : loads_.worst) worst.sample = std::min(worst.sample, last);
    return loads_;
}

void LimitMeter::place(const Point& point) {
    Point& now = place_[steps_ & mask_];
    for (std::size_t i = 0; i < point.size(); ++i) now[i] = point[i] * unit_mm_;
    if (steps_ == 0) std::fill(place_.begin(), place_.end(), now);  // at rest before
    const Point& before = place_[(steps_ - 1) & mask_];
    Point& velocity = velocity_[steps_ & mask_];
    for (std::size_t i = 0; i < point.size(); ++i) velocity[i] = (now[i] - before[i]) / step_;
    if (!tool_.empty()) {
        const ref::Vec3 tool =
            ref::tool_of(kinematics_, {now[0], now[1], now[2]}, {now[3], now[4], now[5]});
        if (steps_ == 0) std::fill(tool_.begin(), tool_.end(), tool);
        tool_[steps_ & mask_] = tool;
        if (error_mm_ > 0) {
            const double off = ref::tool_error(kinematics_, {now[0], now[1], now[2]},
                                               {now[3], now[4], now[5]}, error_mm_);
            gain_ = std::max(gain_, off / (std::sqrt(3.0) * error_mm_));
        }
        tool_velocity_[steps_ & mask_] = (tool - tool_[(steps_ - 1) & mask_]) / step_;
    }
    for (const Window& window : windows_) measure(window);
    ++steps_;
}

void LimitMeter::measure(const Window& window) {
    const Point& r2 = place_[steps_ & mask_];
    const Point& r1 = place_[(steps_ - window.steps) & mask_];
    const Point& v2 = velocity_[steps_ & mask_];
    const Point& v1 = velocity_[(steps_ - window.steps) & mask_];
    const Point& v0 = velocity_[(steps_ - 2 * window.steps) & mask_];
    const auto moved = [&](std::size_t i) { return r2[i] - r1[i]; };
    const auto change = [&](std::size_t i) { return v2[i] - v1[i]; };
    const auto second = [&](std::size_t i) { return v2[i] - 2 * v1[i] + v0[i]; };
    const auto& allowed = allowed_[static_cast<std::size_t>(&window - windows_.data())];
    WindowLoads& loads = loads_.windows[window.loads];
    const auto keep = [&](std::size_t of, const std::array<double, 3>& size) {
        for (std::size_t i = 0; i < 3; ++i) {
            // The path's own rounding is that of the tool.
            const double more = of == 0 ? (gain_ - 1) * loads.rounding[i] * allowed[of][i] : 0;
            const double ratio = size[i] / (allowed[of][i] + more);
            if (ratio <= loads.of[of][i]) continue;
            loads.of[of][i] = ratio;
            LimitLoads::Worst& worst = loads_.worst[i];
            if (ratio > worst.ratio) {
                worst = {ratio, loads.seconds, of, steps_ * stride_, segment_};
            }
        }
    };
    std::array<double, 3> path{path_length(axes_, moved), path_length(axes_, change),
                               path_length(axes_, second)};
    if (!tool_.empty()) {
        const auto ago = [&](std::size_t steps) { return (steps_ - steps) & mask_; };
        const ref::Vec3& now = tool_velocity_[ago(0)];
        const ref::Vec3& before = tool_velocity_[ago(window.steps)];
        path = {(tool_[ago(0)] - tool_[ago(window.steps)]).norm(), (now - before).norm(),
                (now - 2 * before + tool_velocity_[ago(2 * window.steps)]).norm()};
    }
    keep(0, path);
    if (look_ && &window == &windows_.back()) {
        const double w = static_cast<double>(window.steps) * step_;
        look_(static_cast<double>(steps_) * step_, path[kAcceleration] / w, path[kJerk] / (w * w));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(axes_); ++i) {
        keep(i + 1, {std::abs(moved(i)), std::abs(change(i)), std::abs(second(i))});
    }
}

}  // namespace curvecore::sysc
