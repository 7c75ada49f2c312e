// SPDX-License-Identifier: Apache-2.0
// One axis of the step generator, clock by clock. Twins: rtl/pulse/step_phase.sv, step_pulse.sv and
// step_axis.sv, which explain it; clock() is one rising edge, what it returns is seen after it.
#pragma once

#include <cstdint>

#include "hls/place_scaler.hpp"

namespace curvecore {
namespace hls {

/// When steps are due.
class StepPhase {
  public:
    explicit StepPhase(int period_log2)
        : one_(std::int64_t(1) << (kStepFraction + period_log2)), phase_(one_ / 2) {}

    /// `load` is null in clocks without one; `none`: a load without a rate.
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

/// Times of the drives, in clocks; 0 counts as 1.
struct PulseTimes {
    int steplen = 1;
    int stepspace = 1;
    int dirsetup = 1;
    int dirhold = 1;
};

/// Steps as pulses.
class StepPulse {
  public:
    static constexpr int kMostWaiting = 7;  // in each direction

    void clock(const PulseTimes& times, bool hit, bool back, bool stop, bool clear) {
        int& here = waiting_[direction_];
        const int there = waiting_[!direction_];
        const bool overrun =
            hit && !stop && (waiting_[back] == kMostWaiting || (there > 0 && back == direction_));
        const bool free = state_ == State::kReady || (state_ != State::kHigh && done_);
        const bool rise = free && here > 0 && !stop;
        const bool turn = state_ == State::kReady && done_ && here == 0 &&
                          (there > 0 || back != direction_) && !stop;
        const bool fall = state_ == State::kHigh && (done_ || stop);
        uncertain_ = !clear && (uncertain_ || (fall && !done_));
        overrun_ = !clear && (overrun_ || overrun);
        if (rise) --here;
        if (hit && !overrun) ++waiting_[back];
        if (stop) waiting_[0] = waiting_[1] = 0;
        if (turn) direction_ = !direction_;
        if (rise) {
            begin(State::kHigh, times.steplen);
        } else if (fall) {
            begin(State::kSpace, times.stepspace);
        } else if (turn) {
            begin(State::kSetup, times.dirsetup);
        } else {
            const int least = state_ == State::kHigh    ? times.steplen
                              : state_ == State::kSpace ? times.stepspace
                              : state_ == State::kSetup ? times.dirsetup
                                                        : times.dirhold;
            const bool rests = state_ != State::kReady && free;
            const bool over = age_ >= least;
            if (!done_) ++age_;
            done_ = over && !rests;
            if (rests) state_ = State::kReady;
        }
    }

    bool step() const { return state_ == State::kHigh; }
    bool direction() const { return direction_; }
    bool overrun() const { return overrun_; }
    bool uncertain() const { return uncertain_; }

  private:
    enum class State { kReady, kHigh, kSpace, kSetup };

    void begin(State state, int time) {
        state_ = state;
        age_ = 2;
        done_ = time <= 1;
    }

    State state_ = State::kReady;
    int age_ = 0;  // clocks since the last edge, as they will be after the next
    bool done_ = false;
    bool direction_ = false;
    int waiting_[2] = {0, 0};
    bool overrun_ = false;
    bool uncertain_ = false;
};

class StepAxis {
  public:
    explicit StepAxis(int period_log2) : phase_(period_log2) {}

    void clock(const PulseTimes& times, const StepRate* load, bool none, bool stop) {
        const bool refused = load != nullptr && load->refused;
        const bool begins = load != nullptr && load->fresh;
        pulse_.clock(times, phase_.hit(), phase_.back(), stop || !referenced_, begins);
        phase_.clock(load, none);
        referenced_ = !stop && !refused && (referenced_ || begins);
        refused_ = !begins && (refused_ || refused);
    }

    const StepPulse& pulse() const { return pulse_; }
    bool referenced() const { return referenced_; }
    bool refused() const { return refused_; }

  private:
    StepPhase phase_;
    StepPulse pulse_;
    bool referenced_ = false;
    bool refused_ = false;
};

}  // namespace hls
}  // namespace curvecore
