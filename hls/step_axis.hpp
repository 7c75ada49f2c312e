// SPDX-License-Identifier: Apache-2.0
// One axis of the step generator, clock by clock. Twins: rtl/pulse/step_phase.sv, step_pulse.sv and
// step_axis.sv, which explain it; clock() is one rising edge, its result the state after it.
#pragma once

#include <cstdint>

#include "hls/place_scaler.hpp"

namespace curvecore {
namespace hls {

/// The phase of an axis: the times at which steps are due.
class StepPhase {
  public:
    explicit StepPhase(int period_log2)
        : one_(std::int64_t(1) << (kStepFraction + period_log2)), phase_(one_ / 2) {}

    /// Advances by a clock; `load` is null in clocks without one; `none`: a load without a rate.
    void clock(const StepRate* load, bool none) {
        if (moves_) back_ = rate_ < 0;
        const std::int64_t sum = phase_ + rate_;
        hit_ = sum < 0 || sum >= one_;
        phase_ = sum & (one_ - 1);
        if (none) {
            rate_ = 0;
            moves_ = false;
        } else if (load != nullptr) {
            rate_ = load->rate;
            moves_ = load->moves;
            if (load->fresh) {
                phase_ = one_ / 2;
                hit_ = false;
            }
        }
    }

    bool hit() const { return hit_; }
    bool back() const { return back_; }

  private:
    std::int64_t one_;
    std::int64_t phase_;
    std::int64_t rate_ = 0;
    bool moves_ = false;
    bool hit_ = false;
    bool back_ = false;
};

/// Times of the drives, clocks; 0 counts as 1.
struct PulseTimes {
    int steplen = 1;
    int stepspace = 1;
    int dirsetup = 1;
    int dirhold = 1;
};

/// Steps made pulses.
class StepPulse {
  public:
    static constexpr int kMostWaiting = 3;  // in each direction

    void clock(const PulseTimes& times, bool hit, bool back, bool stop, bool clear) {
        const int length = at_least_1(times.steplen);
        int& here = waiting_[direction_];
        const int there = waiting_[!direction_];
        const bool overrun =
            hit && (waiting_[back] == kMostWaiting || (there > 0 && back == direction_));
        const bool rise = here > 0 && space_ && set_ && !stop;
        const bool turn =
            here == 0 && (there > 0 || back != direction_) && space_ && hold_ && set_ && !stop;
        uncertain_ = !clear && (uncertain_ || (step_ && stop && !long_));
        overrun_ = !clear && (overrun_ || (overrun && !stop));
        if (step_ && (long_ || stop)) step_ = false;
        if (rise) {
            step_ = true;
            --here;
        }
        if (hit && !overrun) ++waiting_[back];
        if (stop) waiting_[0] = waiting_[1] = 0;
        if (turn) direction_ = !direction_;
        long_ = rise ? length == 1 : long_ || age_ == length;
        space_ = !rise && (space_ || age_ == length + at_least_1(times.stepspace));
        hold_ = !rise && (hold_ || age_ == length + at_least_1(times.dirhold));
        set_ = turn ? times.dirsetup <= 1 : set_ || age_ == times.dirsetup;
        age_ = rise || turn ? 2 : age_ + 1;
    }

    bool step() const { return step_; }
    bool direction() const { return direction_; }
    bool overrun() const { return overrun_; }
    bool uncertain() const { return uncertain_; }

  private:
    static int at_least_1(int time) { return time < 1 ? 1 : time; }

    int waiting_[2] = {0, 0};
    std::int64_t age_ = 0;  // clocks since the last pulse's start or turn, as in the next clock
    bool long_ = false;     // times that are over
    bool space_ = true;
    bool hold_ = true;
    bool set_ = true;
    bool step_ = false;
    bool direction_ = false;
    bool overrun_ = false;
    bool uncertain_ = false;
};

class StepAxis {
  public:
    explicit StepAxis(int period_log2) : phase_(period_log2) {}

    void clock(const PulseTimes& times, const StepRate* load, bool none, bool stop) {
        const bool refused = load != nullptr && load->refused;
        const bool begins = load != nullptr && load->fresh;
        pulse_.clock(times, phase_.hit(), phase_.back(), stop || !referenced_, begun_);
        phase_.clock(load, none);
        referenced_ = !stop && !refused && (referenced_ || begins);
        refused_ = !begins && (refused_ || refused);
        begun_ = begins;
    }

    const StepPulse& pulse() const { return pulse_; }
    bool referenced() const { return referenced_; }
    bool refused() const { return refused_; }

  private:
    StepPhase phase_;
    StepPulse pulse_;
    bool referenced_ = false;
    bool refused_ = false;
    bool begun_ = false;  // in the clock before
};

}  // namespace hls
}  // namespace curvecore
