// SPDX-License-Identifier: Apache-2.0
// Sample period that a core will keep along a plan, from its clocks alone.
#pragma once

#include <array>

#include "sysc/core/core_clocks.hpp"
#include "sysc/watch/sample_pace.hpp"
#include "sysc/words/step_walk.hpp"

namespace curvecore::sysc {

/// Predicts the pace. The serial core makes samples and steps in turn, the engine ticks of time as
/// well. The parallel core makes steps beside the samples, up to three ahead of the one with the
/// last sample.
class PredictedPace {
  public:
    template <class Plan>
    PredictedPace(const Plan& plan, const CoreParameters& core, int samples_per_tick = 1)
        : walk_(plan),
          in_turn_(hls::in_turn(core.build)),
          latency_(hls::sample_latency(timed_core(core))),
          change_{{{change_clocks(core, ref::CurveKind::kArc),
                    change_clocks(core, ref::CurveKind::kSpline),
                    change_clocks(core, ref::CurveKind::kTable)}}},
          sample_clocks_(change_[plan.segments.front().kind()].sample),
          pace_(hls::samples_ahead(timed_core(core))),
          tick_clocks_(hls::tick_clocks(timed_core(core))),
          samples_per_tick_(static_cast<std::uint64_t>(samples_per_tick)),
          ticks_in_turn_(core.build == Build::kEngine) {}

    /// Adds the next sample, `s` quanta along the path.
    void sample(std::uint64_t s) {
        bool first = samples_ == 0;
        double ready = 0;
        walk_.to(s, [&](const ref::Segment& segment, bool fresh) {
            const hls::Clocks& clocks = change_[segment.kind()];
            ready = make_step(fresh ? clocks.segment : clocks.step);
            sample_clocks_ = clocks.sample;
            first = true;
        });
        if (ticks_in_turn_ && samples_ % samples_per_tick_ == 0) clock_ += tick_clocks_;
        clock_ = std::max(clock_ + sample_clocks_, ready);
        if (in_turn_ || first) pace_.sample(samples_, static_cast<std::uint64_t>(clock_));
        ++samples_;
    }

    double period() const {
        return std::max(pace_.period(), tick_clocks_ / static_cast<double>(samples_per_tick_));
    }

  private:
    /// Makes a step and returns the clock at which the next sample could be its first.
    double make_step(int clocks) {
        if (in_turn_) return clock_ += clocks;
        double& bank = free_[steps_++ % free_.size()];
        made_ = std::max(made_, bank) + clocks;
        clock_ = std::max(clock_, made_);
        bank = clock_ + latency_;
        return made_;
    }

    StepWalk walk_;
    bool in_turn_;
    int latency_;
    ref::ByKind<hls::Clocks> change_;
    int sample_clocks_;  // along the present segment
    SamplePace pace_;
    int tick_clocks_;  // of a tick of time
    std::uint64_t samples_per_tick_;
    bool ticks_in_turn_;
    double clock_ = 0;              // clock of the last sample
    double made_ = 0;               // clock of the last step
    std::array<double, 3> free_{};  // clocks at which the samples have left the step before
    std::size_t steps_ = 0;
    std::uint64_t samples_ = 0;
};

}  // namespace curvecore::sysc
