// SPDX-License-Identifier: Apache-2.0
// Sample period that a core has kept along a plan, from the clocks of its samples.
#pragma once

#include "sysc/board/board.hpp"
#include "sysc/core/core_clocks.hpp"
#include "sysc/job/job.hpp"
#include "sysc/watch/sample_pace.hpp"
#include "sysc/words/step_walk.hpp"

namespace curvecore::sysc {

class MeasuredPace {
  public:
    explicit MeasuredPace(const Job& job)
        : walk_(job.plan),
          in_turn_(hls::in_turn(job.options.core.build)),
          pace_(hls::samples_ahead(timed_core(job.options.core))) {}

    void take(const Sample& drawn) {
        bool first = samples_ == 0;
        if (first) first_clock_ = drawn.clock;
        s_ += static_cast<std::uint64_t>(drawn.ds);
        walk_.to(s_, [&first](const ref::Segment&, bool) { first = true; });
        if (in_turn_ || first) pace_.sample(samples_, drawn.clock);
        ++samples_;
    }

    double period() const { return pace_.period(); }
    std::uint64_t first_clock() const { return first_clock_; }

  private:
    StepWalk walk_;
    bool in_turn_;  // samples and steps are made in turn
    SamplePace pace_;
    std::uint64_t s_ = 0;  // quanta
    std::uint64_t samples_ = 0;
    std::uint64_t first_clock_ = 0;
};

}  // namespace curvecore::sysc
