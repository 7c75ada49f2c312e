// SPDX-License-Identifier: Apache-2.0
// Words of the time scaler: the rate of time r follows hold, resume and override with bounded first
// and second differences. Twin: rtl/path/time_scaler.sv.
//
// r has 32 fraction bits. Per tick its slope changes by at most `acceleration` and never exceeds
// `slope`; r slows down in time to meet the target without overshoot. The first tick lands on its
// target at once: nothing moves yet.
#pragma once

#include <cstdint>

namespace curvecore {
namespace hls {

class TimeScaler {
  public:
    /// acceleration in [1, 2^31], slope in [acceleration, 2^32]; 2^-32 per tick. What does not fit
    /// is not obeyed: rtl/path/motion_settings.sv.
    static constexpr bool fits(std::int64_t acceleration, std::int64_t slope) {
        return acceleration >= 1 && acceleration <= std::int64_t(1) << 31 &&
               slope >= acceleration && slope <= std::int64_t(1) << 32;
    }

    TimeScaler(std::int64_t acceleration, std::int64_t slope)
        : acceleration_(acceleration), max_slope_(slope) {}

    /// One tick towards target (0 .. 2^16 = 1.0); returns the new rate, 0 .. 2^16.
    std::int32_t tick(std::int32_t target) {
        if (fresh_) {
            fresh_ = false;
            rate_ = std::int64_t(target) << 16;
            return target;
        }
        const std::int64_t distance = (std::int64_t(target) << 16) - rate_;
        if (slope_ == 0) {
            rising_ = distance >= 0;
        }
        const std::int64_t rest = rising_ ? distance : -distance;
        std::int64_t move = 0;
        if (settling_) {
            settling_ = false;
        } else if (slope_ == 0 && rest < acceleration_) {
            move = rest;
            settling_ = move != 0;
        } else if (slope_ + acceleration_ <= max_slope_ &&
                   rest >= braking_ + 2 * slope_ + acceleration_) {
            braking_ += slope_;
            slope_ += acceleration_;
            move = slope_;
        } else if (rest >= braking_ + slope_) {
            move = slope_;
        } else {
            slope_ -= acceleration_;
            braking_ -= slope_;
            move = slope_;
        }
        rate_ += rising_ ? move : -move;
        return static_cast<std::int32_t>(rate_ >> 16);
    }

  private:
    std::int64_t acceleration_;
    std::int64_t max_slope_;
    bool fresh_ = true;
    std::int64_t rate_ = 0;
    std::int64_t slope_ = 0;    // n a: of the last tick, towards rising_
    std::int64_t braking_ = 0;  // a n (n-1) / 2: what r still moves when it brakes now
    bool rising_ = true;
    bool settling_ = false;  // the last tick moved less than a slope step: rest one tick, or a
                             // reversal would change the slope by more than `acceleration`
};

}  // namespace hls
}  // namespace curvecore
