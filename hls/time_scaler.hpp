// SPDX-License-Identifier: Apache-2.0
// Words of the time scaler: the rate of time r follows hold, resume and override with bounded first
// and second differences. Twin: rtl/time/time_scaler.sv.
//
// r has 32 fraction bits. Per tick its slope changes by at most `acceleration` and never exceeds
// `slope`; r slows down in time to meet the target without overshoot. While nothing is under way r
// equals its target at once: before the first tick that is not held, and after kIdleTicks ticks
// without a program, except for a stop on a branch, which goes on.
//
// Near 1 a plan leaves little of the limits, below 7/8 a third and more: r^2 a, r^3 j. So from 7/8
// on an eighth of both bounds holds, and r rests on 7/8 when it goes from one side to the other.
//
// If a plan has stop branches, a stop from a rate r0 of kBranchRate or more, at which time rests,
// waits for the next of them and then goes by its steps, R'' each, which end at R = 0: the branch
// is the rate R from 1 on, so r(t) = r0 R(r0 t) takes r0, r0^2 and r0^3 of what it takes of
// velocity, acceleration and jerk. The bounds serve all other changes. A clock of 16 fraction bits
// counts the ticks of path time, in which branches are measured; between two of its ticks R is a
// straight line. The branches that pass report the longest wait, in these ticks; only those at rest
// are counted. A stop always waits kStopLead of them, the time that a branch may be on its way.
#pragma once

#include <cstdint>

#include "ref/format/path_words.hpp"

namespace curvecore {
namespace hls {

/// A step of `ticks` ticks of path time, in each of which the slope of R changes by `change`, 2^-32
/// per tick.
struct StopStep {
    std::int32_t ticks = 1;  // [1, 2047]
    std::int32_t change = 0;
    bool last = false;  // last step of its branch: then the rate is 0
};

/// Events at the start of a tick: a stop waits for the next branch for `wait` ticks of path time
/// from here on, 0: as before; a branch begins, with these.
struct StopDue {
    StopDue() = default;
    StopDue(std::int32_t ticks, bool is_branch) : wait(ticks), begins(is_branch) {}

    std::int32_t wait = 0;
    bool begins = false;
};

class TimeScaler {
  public:
    /// Checks acceleration in [8, 2^31], slope in [acceleration, 2^32]; 2^-32 per tick. Other
    /// values are refused: rtl/time/motion_settings.sv.
    static constexpr bool fits(std::int64_t acceleration, std::int64_t slope) {
        return acceleration >= 1 << ref::kFineShift && acceleration <= std::int64_t(1) << 31 &&
               slope >= acceleration && slope <= std::int64_t(1) << 32;
    }

    TimeScaler(std::int64_t acceleration, std::int64_t slope)
        : acceleration_(acceleration), max_slope_(slope) {}

    /// Returns true if the next tick is on its target at once; idle: PathKernel::idle() before it.
    /// A rate that has its target anyway needs nothing.
    bool lands(std::int32_t target, bool idle) const {
        return (idle || fresh_) && (unsettled_ || target != asked_) && !stopping_;
    }

    /// Returns true while a branch makes a stop, with the next tick too.
    bool stopping() const { return stopping_; }

    /// Returns true if time rested in the last tick: at the rate of the one before or on its target
    /// at once, kBranchRate or more.
    bool steady() const { return steady_; }
    /// Returns true if the branches' clock went on by a tick in the last one: in ticks that are
    /// neither steady nor of a stop always.
    bool passed() const { return passed_; }

    /// Makes one tick towards target (0 .. 2^16 = 1.0); returns the new rate, 0 .. 2^16.
    std::int32_t tick(std::int32_t target, bool idle = false) {
        return tick(target, idle, StopDue(), [] { return StopStep{1, 0, true}; });
    }

    /// Makes a tick with branches; next_step() gives the steps of the one that began last.
    template <class NextStep>
    std::int32_t tick(std::int32_t target, bool idle, const StopDue& due, NextStep&& next_step) {
        const bool now = lands(target, idle);
        unsettled_ = !now && (unsettled_ || target != asked_);
        asked_ = target;
        fresh_ = fresh_ && target == 0;
        const bool held = resting_ && target == 0 && !now;
        const bool waits = held && wait_ > 0;
        const bool begins = held && due.begins;
        const std::int32_t obeyed = waits ? target_ : target;
        const bool goes_on = resting_ && obeyed == target_ && !now && !begins;
        passed_ = pass(goes_on || stopping_ || begins);
        steady_ = goes_on || (now && target >= ref::kBranchRate);
        count(due.wait, waits);
        if (begins) {
            stopping_ = true;
            left_ = 0;
            last_ = false;
            resting_ = false;
            rate_ = std::int64_t(1) << 32;
        }
        if (stopping_) return stop_on(next_step);
        const bool same = now || obeyed == target_;
        target_ = obeyed;
        if (now) rest();
        const std::int32_t rate = now ? land(obeyed) : follow(obeyed);
        resting_ = same && arrived_ && !settling_ && rate == obeyed && rate >= ref::kBranchRate;
        return rate;
    }

  private:
    /// Lets the branches' clock go on, by the rate at which time rests or by a whole tick; returns
    /// true if a tick of it begins, `ahead_` before its end.
    bool pass(bool at_rate) {
        ahead_ = at_rate ? ahead_ - target_ : -1;
        if (ahead_ >= 0) return false;
        ahead_ = at_rate ? ahead_ + (1 << 16) : 0;
        return true;
    }

    /// Counts wait_ in ticks of path time that pass at rest.
    void count(std::int32_t told, bool waits) {
        if (told > 0) {
            wait_ = told;
        } else if (steady_ && (waits || wait_ >= ref::kStopLead)) {
            wait_ -= passed_ ? 1 : 0;
        } else if (wait_ < ref::kStopLead) {
            wait_ = ref::kStopLead - 1;
        }
    }

    template <class NextStep>
    std::int32_t stop_on(NextStep&& next_step) {
        if (passed_) {
            if (left_ == 0) {
                const StopStep step = next_step();
                left_ = step.ticks;
                change_ = step.change;
                last_ = step.last;
            }
            --left_;
            stop_slope_ += change_;
            rate_ = to_rate(rate_ + stop_slope_);
            if (last_ && left_ == 0) {
                stopping_ = false;
                stop_slope_ = 0;
                target_ = 0;
                return land(0);
            }
        }
        // R on the way to rate_; at 1 or beyond it is the most that is below.
        const std::int64_t between = (rate_ >> kLeft) - (to_slope(stop_slope_) * ahead_ >> 16);
        const std::int64_t most = (1 << kBetweenFrac) - 1;
        const std::int64_t below = (between & 1 << kBetweenFrac) != 0 ? most : between & most;
        return static_cast<std::int32_t>(target_ * below >> kBetweenFrac);
    }

    /// Cuts R and its slope to the bits of the hardware.
    static constexpr int kBetweenFrac = 17;
    static constexpr int kLeft = 32 - kBetweenFrac;
    static std::int64_t to_rate(std::int64_t rate) { return rate & ((std::int64_t(1) << 33) - 1); }
    static std::int64_t to_slope(std::int64_t slope) {
        constexpr std::int64_t kOne = 1 << kBetweenFrac;
        return (((slope >> kLeft) + kOne) & (2 * kOne - 1)) - kOne;
    }

    std::int32_t land(std::int32_t target) {
        fine_ = target >= ref::kFineRate;
        rate_ = std::int64_t(target) << 16;
        return target;
    }

    void rest() {
        slope_ = 0;
        braking_ = 0;
        settling_ = false;
        arrived_ = true;
    }

    std::int32_t follow(std::int32_t target) {
        const bool high = target >= ref::kFineRate;
        const std::int64_t border = std::int64_t(ref::kFineRate) << 16;
        if (slope_ == 0 && !settling_ && rate_ == border) fine_ = high;
        const std::int64_t goal = high == fine_ ? std::int64_t(target) << 16 : border;
        const std::int64_t acceleration = fine_ ? acceleration_ >> ref::kFineShift : acceleration_;
        const std::int64_t max_slope = fine_ ? max_slope_ >> ref::kFineShift : max_slope_;

        const std::int64_t distance = goal - rate_;
        if (slope_ == 0) {
            rising_ = distance >= 0;
        }
        const std::int64_t rest = rising_ ? distance : -distance;
        std::int64_t move = 0;
        arrived_ = arrived_ && rest == 0;
        if (settling_) {
            settling_ = false;
        } else if (slope_ == 0 && rest < acceleration) {
            move = rest;
            settling_ = move != 0;
            arrived_ = true;
        } else if (slope_ + acceleration <= max_slope &&
                   rest >= braking_ + 2 * slope_ + acceleration) {
            braking_ += slope_;
            slope_ += acceleration;
            move = slope_;
        } else if (rest >= braking_ + slope_) {
            move = slope_;
        } else {
            slope_ -= acceleration;
            braking_ -= slope_;
            move = slope_;
        }
        rate_ += rising_ ? move : -move;
        return static_cast<std::int32_t>(rate_ >> 16);
    }

    std::int64_t acceleration_;
    std::int64_t max_slope_;
    bool fresh_ = true;       // no tick came that was not held
    bool unsettled_ = true;   // the target changed since a tick was on it at once
    std::int32_t asked_ = 0;  // target of the last tick, obeyed or not
    bool fine_ = false;       // the bounds are those from 7/8 on
    std::int64_t rate_ = 0;
    std::int64_t slope_ = 0;    // n a: of the last tick, towards rising_
    std::int64_t braking_ = 0;  // a n (n-1) / 2: r still moves by this if it brakes now
    bool rising_ = true;
    bool settling_ = false;  // the last tick moved less than a slope step: rest one tick, or a
                             // reversal would change the slope by more than `acceleration`

    std::int32_t target_ = 0;  // of the last tick, as obeyed; in a stop r0
    bool arrived_ = false;     // at rest, on it or on 7/8
    bool resting_ = false;     // at rest on target_, from kBranchRate on
    bool steady_ = false;
    bool passed_ = true;
    std::int32_t ahead_ = 0;                  // ticks of path time, 16 fraction bits, below 1
    std::int32_t wait_ = ref::kStopLead - 1;  // ticks until a branch is due, at most
    bool stopping_ = false;
    std::int32_t left_ = 0;  // ticks of the present step, after this one
    std::int32_t change_ = 0;
    bool last_ = false;
    std::int64_t stop_slope_ = 0;  // of R
};

}  // namespace hls
}  // namespace curvecore
