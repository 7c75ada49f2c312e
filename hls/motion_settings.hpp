// SPDX-License-Identifier: Apache-2.0
// Settings of the motion: taken while nothing is under way, checked, and kept. Twins:
// rtl/time/motion_settings.sv, rtl/engine/programs/settings.asm.
//
// What is asked for is taken before a tick, if no program is under way; a program under way keeps
// the settings of its start. Time begins anew with others: a new TimeScaler, and a PathKernel
// without a past. It runs with good ones alone, otherwise every target is 0.
#pragma once

#include "hls/time_scaler.hpp"

namespace curvecore {
namespace hls {

struct TimeSettings {
    TimeSettings() = default;
    TimeSettings(int samples, std::int64_t acceleration, std::int64_t slope, std::int64_t stop)
        : samples_per_tick_log2(samples),
          hold_acceleration(acceleration),
          hold_slope(slope),
          stop_ticks(stop) {}

    int samples_per_tick_log2 = 0;
    std::int64_t hold_acceleration = 0;  // TimeScaler::fits
    std::int64_t hold_slope = 0;
    std::int64_t stop_ticks = 0;  // [1, 2^29)

    bool operator==(const TimeSettings& other) const {
        return samples_per_tick_log2 == other.samples_per_tick_log2 &&
               hold_acceleration == other.hold_acceleration && hold_slope == other.hold_slope &&
               stop_ticks == other.stop_ticks;
    }
};

class MotionSettings {
  public:
    /// Looks at what is asked for, before a tick; active: a program is under way, queued: a piece
    /// of one is. Returns true if it was taken.
    bool look(const TimeSettings& asked, bool active, bool queued) {
        const bool same = asked == taken_;
        fault_ = fault_ || (active ? !same : same && queued && !good());
        if (same || active) return false;
        taken_ = asked;
        return true;
    }

    bool good() const {
        return TimeScaler::fits(taken_.hold_acceleration, taken_.hold_slope) &&
               taken_.stop_ticks >= 1 && taken_.stop_ticks < std::int64_t(1) << 29;
    }
    /// Returns true once they changed while a program was under way, or one waited for good ones.
    bool fault() const { return fault_; }
    const TimeSettings& taken() const { return taken_; }

  private:
    TimeSettings taken_{-1, 0, 0, 0};  // none
    bool fault_ = false;
};

}  // namespace hls
}  // namespace curvecore
