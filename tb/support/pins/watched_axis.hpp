// SPDX-License-Identifier: Apache-2.0
// An axis of the step generator as its drive sees it, compared with the exact crossings of its
// places: every step once, in order, in the first clock that the drive's times allow.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>

#include "ref/numeric/step_crossings.hpp"
#include "tb/support/pins/pulse_monitor.hpp"
#include "tb/support/pins/step_motion.hpp"

namespace curvecore::tb {

/// Places in units of 2^-16 step.
inline const ref::StepCrossings kPlaces(1, int64_t{1} << hls::kStepFraction);

struct DueStep {
    int64_t clock;
    bool back;
};

/// An axis: the steps due by its places, and the steps at its pins.
class WatchedAxis {
  public:
    WatchedAxis(int64_t scale, int fine_bits, int64_t period, const hls::PulseTimes& times)
        : scale_(scale), fine_bits_(fine_bits), period_(period), monitor_(times), times_(times) {}

    void stands_at(int64_t position) { place_ = place_of(position); }

    /// Begins a period, whose first clock reaches the pins after `start`.
    void moves_to(int64_t position, int64_t start) {
        const int64_t place = place_of(position);
        kPlaces.between(place_, place, [&](const ref::StepCrossing& crossing) {
            due_.push_back({start + crossing.clock(period_), crossing.back});
        });
        place_ = place;
    }

    void watch(int64_t clock, bool step, bool direction) {
        const int64_t before = monitor_.rise();
        const bool rises = monitor_.watch(clock, step, direction);
        ASSERT_EQ(monitor_.complaint(), "");
        if (!rises) return;
        ASSERT_FALSE(due_.empty()) << "a step that is not due";
        const DueStep due = due_.front();
        due_.pop_front();
        ASSERT_EQ(due.back, direction) << "a step in the wrong direction";
        // Each step goes out in the first clock that the drive's times allow.
        const int64_t possible =
            std::max(before + std::max(times_.steplen, 1) + std::max(times_.stepspace, 1),
                     monitor_.turn() + std::max(times_.dirsetup, 1));
        ASSERT_EQ(clock, std::max(due.clock, possible));
        if (possible <= due.clock) ++free_;
    }

    /// Returns true if more steps wait than one turn, and 7 each way, can hold: an overrun must
    /// then be reported. It is decided two clocks before the step could go out, and seen one clock
    /// later.
    bool overruns(int64_t clock) const {
        bool pin = monitor_.direction();
        int waiting[2] = {0, 0};
        if (monitor_.rise() == clock) ++waiting[pin];
        if (monitor_.turn() == clock) pin = !pin;
        for (const DueStep& due : due_) {
            if (due.clock > clock + 1) break;
            const bool returns = due.back == pin && waiting[!pin] > 0;
            if (returns || ++waiting[due.back] > hls::StepPulse::kMostWaiting) return true;
        }
        return false;
    }

    /// The whole step at which the axis is.
    int64_t count() const { return kPlaces.count(place_); }
    bool idle() const { return due_.empty(); }
    int64_t free_steps() const { return free_; }
    const PulseMonitor& monitor() const { return monitor_; }

  private:
    int64_t place_of(int64_t position) const { return exact_place(position, scale_, fine_bits_); }

    int64_t scale_;
    int fine_bits_;
    int64_t period_;
    PulseMonitor monitor_;
    hls::PulseTimes times_;
    int64_t place_ = 0;
    std::deque<DueStep> due_;
    int64_t free_ = 0;
};

}  // namespace curvecore::tb
