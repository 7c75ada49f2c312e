// SPDX-License-Identifier: Apache-2.0
// A tool that swings behind its drives: how far it is off the path with the steps of the path, and
// with those that the machine's shaper makes of them (ref/machine/shaper.hpp).
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "ref/machine/shaper.hpp"
#include "sysc/watch/limit_meter.hpp"

namespace curvecore::sysc {

/// A mass behind a drive, x'' = w^2 (u - x) - 2 z w x', where u is even between samples: solved as
/// it stands.
class SwingingMass {
  public:
    SwingingMass(const ref::Vibration& mode, double period_s, double place);

    /// Goes on to the next sample; returns the mass's place there.
    double follow(double drive);

  private:
    bool rigid_;
    double period_, lag_;                      // lag_: 2 z / w
    std::array<std::array<double, 2>, 2> go_;  // of place and speed, without a drive
    double drive_, place_, speed_ = 0;
};

/// Distances in mm, of X Y Z.
struct ToolPath {
    double off = 0;   // of the path up to there, at most
    double rest = 0;  // of the program's end, once the drives rest there
};

struct ToolResult {
    double delay_s = 0;  // by which the shaped tool is behind the path
    ToolPath without, shaped;
    LimitLoads drives;  // of the shaped steps
};

class ToolMeter {
  public:
    using Point = LimitMeter::Point;

    /// Samples of delay, at most: more than any board keeps.
    static constexpr int kMostDelay = 1 << 16;

    static bool is_asked(const ref::Machine& machine);

    /// @throws InputError: the machine's shaper needs another delay
    ToolMeter(const ref::Machine& machine, double unit_mm, double period_s, int samples_per_tick,
              int axes);

    /// Takes the start point first, then every sample; units. `segment` is that of `drives`.
    void take(const Point& point, std::size_t segment);

    /// Returns the result, with the last point held; to be called once.
    ToolResult finish();

  private:
    struct Tool {
        std::vector<SwingingMass> masses;
        bool rests = false;  // its drives do
        ToolPath path;
        ref::Vec3 place = ref::Vec3::Zero();  // units
    };

    void step(const Point& point);
    Point shaped() const;
    void follow(Tool& tool, const Point& drives);
    double off(const Tool& tool) const;

    ref::Machine machine_;
    double unit_mm_;
    double period_s_;
    std::size_t axes_;
    std::array<ref::ShaperTaps, ref::kMachineAxes> taps_;
    std::deque<Point> points_;  // the newest first
    std::size_t kept_;
    std::size_t segment_ = 0;
    Tool without_, shaped_;
    LimitMeter drives_;
};

}  // namespace curvecore::sysc
