// SPDX-License-Identifier: Apache-2.0
// Steps as pulses, from event to event: hls::StepPulse in closed form.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "hls/step_axis.hpp"

namespace curvecore::sysc {

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

class PulseLine {
  public:
    explicit PulseLine(const hls::PulseTimes& times)
        : length_(at_least_1(times.steplen)),
          space_(at_least_1(times.stepspace)),
          setup_(at_least_1(times.dirsetup)),
          hold_(at_least_1(times.dirhold)) {}

    bool step() const { return step_; }
    bool direction() const { return direction_; }
    bool overrun() const { return overrun_; }

    /// Next clock in which a pin changes if no load comes; `back`: direction of the rate.
    std::uint64_t next(bool back) const {
        const std::uint64_t fall = step_ ? fall_ : kNever;
        if (waiting_[direction_] > 0) return std::min(fall, rise_clock());
        if (waiting_[!direction_] > 0 || back != direction_) return std::min(fall, turn_clock());
        return fall;
    }

    void clock(std::uint64_t clock, bool hit, bool back) {
        int& here = waiting_[direction_];
        const int there = waiting_[!direction_];
        const bool overrun = hit && (waiting_[back] == hls::StepPulse::kMostWaiting ||
                                     (there > 0 && back == direction_));
        const bool rises = here > 0 && clock >= rise_clock();
        const bool turns = here == 0 && (there > 0 || back != direction_) && clock >= turn_clock();
        if (step_ && clock >= fall_) step_ = false;
        if (rises) {
            step_ = true;
            --here;
            fall_ = clock + length_;
            rise_from_ = fall_ + space_;
            turn_from_ = fall_ + std::max(space_, hold_);
        }
        overrun_ = overrun_ || overrun;
        if (hit && !overrun) ++waiting_[back];
        if (!turns) return;
        direction_ = !direction_;
        set_from_ = clock + setup_;
    }

    /// Ends the reference after this clock: a pulse of the axis is cut in the next.
    void stop(std::uint64_t clock) {
        waiting_[0] = waiting_[1] = 0;
        fall_ = clock + 1;
    }

  private:
    static std::uint64_t at_least_1(int time) { return time < 1 ? 1 : static_cast<unsigned>(time); }

    std::uint64_t rise_clock() const { return std::max(rise_from_, set_from_); }
    std::uint64_t turn_clock() const { return std::max(turn_from_, set_from_); }

    std::uint64_t length_;
    std::uint64_t space_;
    std::uint64_t setup_;
    std::uint64_t hold_;
    int waiting_[2] = {0, 0};
    bool step_ = false;
    bool direction_ = false;
    bool overrun_ = false;
    std::uint64_t fall_ = 0;
    std::uint64_t rise_from_ = 0;
    std::uint64_t turn_from_ = 0;
    std::uint64_t set_from_ = 0;
};

}  // namespace curvecore::sysc
