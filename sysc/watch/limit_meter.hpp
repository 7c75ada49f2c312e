// SPDX-License-Identifier: Apache-2.0
// A meter of how close a drawn motion comes to the machine's limits, from its positions alone.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ref/machine/machine.hpp"
#include "ref/plan/segment_curve.hpp"

namespace curvecore::sysc {

inline const std::vector<double> kLimitWindows{1e-3, 2e-3, 5e-3, 10e-3, 20e-3};  // s
constexpr int kLeastTicks = 4;  // of a window; shorter windows are not resolved

enum Limited : std::size_t { kVelocity, kAcceleration, kJerk };
constexpr std::array<const char*, 3> kLimitedNames{"velocity", "acceleration", "jerk"};

/// Loads over one window; empty if it is not resolved, or shorter than JointTime.
struct WindowLoads {
    using Ratios = std::array<double, 3>;  // by Limited

    double seconds = 0;
    std::vector<Ratios> of;  // the path, then the axes
    Ratios rounding{};       // share of the path's allowance that comes from `error`
};

struct LimitLoads {
    struct Worst {
        double ratio = 0;
        double window = 0;   // s
        std::size_t of = 0;  // 0: the path; otherwise axis + 1
        std::uint64_t sample = 0;
        std::size_t segment = 0;
    };

    std::vector<WindowLoads> windows;
    std::array<Worst, 3> worst;  // by Limited

    bool resolved() const;
    double most() const;
    /// Returns the worst share of the allowance that comes from `error`.
    double rounding() const;
};

/// Measures, with the mean velocity v(t) over one tick h, within which samples are even, for every
/// window w (T = JointTime), of the path (X Y Z as a vector; U V W while these stand; the tool's
/// place where the axes are joints) and of every axis:
///
///     |r(t + w) - r(t)|                 <=  V w
///     |v(t + w) - v(t)|                 <=  A (w + T)
///     |v(t + 2w) - 2 v(t + w) + v(t)|   <=  J w (w + T) + A T
///
/// The last is the change of the mean acceleration between adjacent windows, times w. Positions
/// that are `error` units off on every axis are allowed 2, 4 / h and 8 / h times that more. If
/// ticks are much denser than the shortest window, only a part of them is taken.
class LimitMeter {
  public:
    using Point = ref::AxisPoint;

    /// Creates a meter with h = samples_per_tick * period_s.
    LimitMeter(const ref::Machine& machine, double unit_mm, double period_s, int samples_per_tick,
               int axes, double error = 0, const std::vector<double>& windows = kLimitWindows);

    /// The longest resolved window, and the mean acceleration and jerk that the path may have over
    /// it, by the second and the third bound above; mm and s.
    struct Longest {
        double seconds;
        double acceleration;
        double jerk;
    };
    /// Receives the path's loads over one window and two of them up to `end`, from the start point
    /// on.
    using Look = std::function<void(double end, double acceleration, double jerk)>;
    /// Sets the receiver, before the first point. None: no window is resolved, and it is never
    /// called.
    std::optional<Longest> look_with(Look look);

    /// Takes the start point first, then every sample; units. `segment` is kept for the worst.
    void take(const Point& point, std::size_t segment);

    /// Returns the loads, with the last point held for ever; to be called once.
    const LimitLoads& finish();

  private:
    struct Window {
        std::size_t steps;
        std::size_t loads;  // index in LimitLoads::windows
    };

    void place(const Point& point);
    void measure(const Window& window);
    void allow(const ref::Machine& machine, double error);

    int axes_;
    double unit_mm_;
    std::uint64_t stride_;  // samples
    double step_;           // s
    std::vector<Window> windows_;
    std::vector<std::vector<std::array<double, 3>>> allowed_;  // by window, path and axes
    std::vector<Point> place_, velocity_;                      // rings
    ref::Kinematics kinematics_;
    double error_mm_;
    double gain_ = 1;  // of an error of the joints to that of the tool, the largest yet
    std::vector<ref::Vec3> tool_, tool_velocity_;  // rings, where the axes are joints
    std::size_t mask_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t samples_ = 0;
    Point last_{};
    std::size_t segment_ = 0;
    LimitLoads loads_;
    Look look_;
};

}  // namespace curvecore::sysc
