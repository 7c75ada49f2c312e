// SPDX-License-Identifier: Apache-2.0
// A plan drawn under holds and overrides by the hardware's words, with stop branches, and its
// limits over windows.
#pragma once

#include "hls/stop_schedule.hpp"
#include "tb/support/judge/tick_run.hpp"

namespace curvecore::tb {

class HoldRun {
  public:
    HoldRun(const ref::Plan& plan, const ref::Machine& machine)
        : plan_(plan),
          run_(plan, machine),
          scaler_(plan.hold_acceleration,
                  std::int64_t{plan.hold_acceleration} * plan.hold_slope_steps) {}

    /// Draws a tick towards a rate of time, 2^16 = 1; returns the rate.
    std::int32_t tick(std::int32_t target) {
        const std::int32_t rate = schedule_.tick(scaler_, target, false);
        const std::size_t begun = run_.begun();
        run_.tick(rate, target == 0);
        if (run_.begun() != begun) begin(begun);
        return rate;
    }

    /// Ticks until the rate is 0 or the program is over.
    std::uint64_t stop() {
        std::uint64_t ticks = 1;
        while (tick(0) != 0 && active()) ++ticks;
        return ticks;
    }

    bool active() const { return run_.active(); }
    std::uint64_t s() const { return run_.s(); }  // quanta of the path
    sysc::LimitLoads finish() { return run_.finish(); }

  private:
    void begin(std::size_t piece) {
        if (next_ < plan_.branches.size() && plan_.branches[next_].piece == piece) {
            const ref::PlannedBranch& branch = plan_.branches[next_++];
            schedule_.load_wait(static_cast<std::int32_t>(branch.wait));
            for (const ref::StopStep& step : branch.steps) {
                schedule_.load_step(hls::to_words(step, &step == &branch.steps.back()));
            }
        }
        schedule_.begin_piece(piece == 0);
    }

    const ref::Plan& plan_;
    TickRun run_;
    hls::TimeScaler scaler_;
    hls::StopSchedule schedule_;
    std::size_t next_ = 0;  // next branch
};

}  // namespace curvecore::tb
