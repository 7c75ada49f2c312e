// SPDX-License-Identifier: Apache-2.0
// Stop branches as they pass: the one that a stop may take, and the time when it begins. Twin:
// rtl/time/stop_memory.sv.
//
// A branch stands before a piece. If the piece begins in a tick of rate 1, the branch is the next
// one: due kStopLead ticks later, when every tick on its way has been taken. At other rates it
// cannot be taken, but reports, as late, the time until the next one. So does a program's first
// piece without a branch: branches before the program no longer count. A branch before the last
// one's due time is left out.
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
    /// Loads the first words of the branch before the next piece.
    void load_wait(std::int32_t wait) {
        loaded_ = true;
        count_ = 0;
        next_wait_ = wait;
    }
    void load_step(const StopStep& step) {
        banks_[write_][static_cast<std::size_t>(count_++ % kStopSteps)] = step;
    }

    /// Returns what is due, once per tick, before its rate is made.
    StopDue due() {
        if (gap_ <= kStopLead) ++gap_;
        if (due_ == 0 || --due_ > 0) return {};
        return next_;
    }

    /// Returns the next step of the branch that was due last.
    StopStep next_step() {
        return banks_[1 - write_][static_cast<std::size_t>(read_++ % kStopSteps)];
    }

    /// Begins the next piece in a tick of this rate; `first`: of a program.
    void begin_piece(std::int32_t rate, bool first) {
        if ((loaded_ || first) && gap_ > kStopLead) {
            const bool begins = loaded_ && rate == 1 << 16;
            if (begins) {
                write_ = 1 - write_;
                read_ = 0;
            }
            next_ = StopDue(loaded_ ? next_wait_ : 1, begins);
            due_ = kStopLead;
            gap_ = 0;
        }
        loaded_ = false;
    }

  private:
    std::array<std::array<StopStep, kStopSteps>, 2> banks_{};
    std::size_t write_ = 0;
    bool loaded_ = false;
    int count_ = 0;
    std::int32_t next_wait_ = 0;
    StopDue next_;
    int read_ = 0;
    int due_ = 0;
    int gap_ = kStopLead + 1;  // ticks since the last one that counted
};

}  // namespace hls
}  // namespace curvecore
