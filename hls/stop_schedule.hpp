// SPDX-License-Identifier: Apache-2.0
// Stop branches as they pass: the one that a stop may take, and the time when it begins. Twin:
// rtl/time/stop_memory.sv.
//
// A branch stands before a piece, with its steps or with those of the branch before. It is due
// kStopLead ticks of path time after the tick in which the piece began, so that every tick on its
// way has been taken; and it can be taken if time rested in that tick and in all since. Else it
// only reports the time until the next one. So does a program's first piece without a branch:
// branches before the program no longer count. A branch before the last one's due time is left out.
#pragma once

#include <array>

#include "hls/time_scaler.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore {
namespace hls {

using ref::kStopLead;
using ref::kStopSteps;  // longer branches overwrite their start

class StopSchedule {
  public:
    /// Loads the first word of the branch before the next piece; `again`: the steps are those that
    /// were loaded last.
    void load_wait(std::int32_t wait, bool again = false) {
        loaded_ = true;
        next_wait_ = wait;
        if (again) return;
        count_ = 0;
        fresh_ = true;
    }
    void load_step(const StopStep& step) {
        banks_[write_][static_cast<std::size_t>(count_++ % kStopSteps)] = step;
    }

    /// Makes a tick of time with the branches; returns its rate.
    std::int32_t tick(TimeScaler& scaler, std::int32_t target, bool idle) {
        const std::int32_t rate = scaler.tick(target, idle, due(), [this] { return next_step(); });
        count(scaler.steady(), scaler.passed());
        return rate;
    }

    /// Returns what is due, once, before the rate of a tick is made.
    StopDue due() {
        if (left_ != 0) return {};
        left_ = -1;
        return next_;
    }

    /// Counts a tick: TimeScaler::steady(), passed().
    void count(bool steady, bool passed) {
        steady_ = steady;
        if (!steady) next_.begins = false;
        if (passed && left_ > 0) --left_;
    }

    /// Returns the next step of the branch that was due last.
    StopStep next_step() {
        return banks_[1 - write_][static_cast<std::size_t>(read_++ % kStopSteps)];
    }

    /// Begins the next piece in the tick that was counted last; `first`: of a program.
    void begin_piece(bool first) {
        if ((loaded_ || first) && left_ < 0) {
            const bool begins = loaded_ && steady_;
            if (begins) {
                if (fresh_) write_ = 1 - write_;
                fresh_ = false;
                read_ = 0;
            }
            next_ = StopDue(loaded_ ? next_wait_ : 1, begins);
            left_ = kStopLead - 1;
        }
        loaded_ = false;
    }

  private:
    std::array<std::array<StopStep, kStopSteps>, 2> banks_{};
    std::size_t write_ = 0;
    bool loaded_ = false;
    bool fresh_ = false;  // steps that no branch has begun with
    int count_ = 0;
    std::int32_t next_wait_ = 0;
    StopDue next_;
    int read_ = 0;
    bool steady_ = false;  // the last tick
    int left_ = -1;        // ticks of path time until next_ is due; -1: it was
};

}  // namespace hls
}  // namespace curvecore
