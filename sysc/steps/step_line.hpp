// SPDX-License-Identifier: Apache-2.0
// Steps of an axis by their clocks, without the clocks in between: hls::StepPhase in closed form.
#pragma once

#include <cstdint>

#include "hls/place_scaler.hpp"
#include "sysc/steps/pulse_line.hpp"

namespace curvecore::sysc {

class StepLine {
  public:
    explicit StepLine(int period_log2)
        : one_(std::int64_t(1) << (hls::kStepFraction + period_log2)), phase_(one_ / 2) {}

    /// Clock of the next hit at the present rate.
    std::uint64_t hit() const { return hit_; }

    /// Takes the hit and finds the next.
    void take_hit() {
        advance(hit_);
        find_hit();
    }

    /// Loads a rate on this clock, whose own sum still has the old rate. Returns true if that sum
    /// is a hit.
    bool load(std::uint64_t clock, const hls::StepRate* load) {
        bool hits = hit_ == clock;
        advance(clock);
        rate_ = load != nullptr ? load->rate : 0;
        if (load != nullptr && load->fresh) {
            phase_ = one_ / 2;
            hits = false;
        }
        find_hit();
        return hits;
    }

  private:
    /// Advances to the state after a clock.
    void advance(std::uint64_t clock) {
        const auto clocks = static_cast<std::int64_t>(clock + 1 - next_);
        phase_ = (phase_ + clocks * rate_) & (one_ - 1);
        next_ = clock + 1;
    }

    void find_hit() {
        hit_ = kNever;
        if (rate_ > 0) hit_ = next_ + static_cast<std::uint64_t>((one_ - phase_ - 1) / rate_);
        if (rate_ < 0) hit_ = next_ + static_cast<std::uint64_t>(phase_ / -rate_);
    }

    std::int64_t one_;
    std::int64_t phase_;  // phase before the clock next_
    std::uint64_t next_ = 0;
    std::int64_t rate_ = 0;
    std::uint64_t hit_ = kNever;
};

}  // namespace curvecore::sysc
