// SPDX-License-Identifier: Apache-2.0
// A drive's view of one axis: it knows only its two pins and its four times.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "hls/step_axis.hpp"

namespace curvecore::tb {

class PulseMonitor {
  public:
    explicit PulseMonitor(const hls::PulseTimes& times) : times_(times) {}

    /// Takes the pins in one clock. Returns true if a step begins in it.
    bool watch(int64_t clock, bool step, bool direction) {
        const bool rises = step && !step_;
        const bool falls = !step && step_;
        const bool turns = direction != direction_;
        if (turns) {
            check(!step && !step_, clock, "the direction turns in a pulse");
            check(clock - fall_ >= times_.dirhold, clock, "dirhold");
            turn_ = clock;
            ++turns_;
        }
        if (rises) {
            check(clock - fall_ >= times_.stepspace, clock, "stepspace");
            check(clock - turn_ >= times_.dirsetup, clock, "dirsetup");
            rise_ = clock;
            ++steps_;
            count_ += direction ? -1 : 1;
        }
        if (falls) {
            check(clock - rise_ >= times_.steplen, clock, "steplen");
            fall_ = clock;
        }
        step_ = step;
        direction_ = direction;
        return rises;
    }

    const std::string& complaint() const { return complaint_; }  // the first one
    int64_t count() const { return count_; }
    int64_t steps() const { return steps_; }
    int64_t turns() const { return turns_; }
    int64_t rise() const { return rise_; }
    int64_t turn() const { return turn_; }
    bool direction() const { return direction_; }

  private:
    void check(bool good, int64_t clock, const char* what) {
        if (!good && complaint_.empty()) {
            complaint_ = what + std::string(" at clock ") + std::to_string(clock);
        }
    }

    static constexpr int64_t kLongAgo = std::numeric_limits<int32_t>::min();

    hls::PulseTimes times_;
    bool step_ = false;
    bool direction_ = false;
    int64_t rise_ = kLongAgo;
    int64_t fall_ = kLongAgo;
    int64_t turn_ = kLongAgo;
    int64_t count_ = 0;
    int64_t steps_ = 0;
    int64_t turns_ = 0;
    std::string complaint_;
};

}  // namespace curvecore::tb
