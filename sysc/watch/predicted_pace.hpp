// SPDX-License-Identifier: Apache-2.0
// Sample period that a core will keep along a plan, from its clocks alone.
#pragma once

#include <array>

#include "sysc/core/core_clocks.hpp"
#include "sysc/watch/sample_pace.hpp"
#include "sysc/words/step_walk.hpp"

namespace curvecore::sysc {

/// Predicts the pace. The serial core makes samples and steps in turn. The parallel core makes
/// steps beside the samples, up to three ahead of the one with the last sample.
class PredictedPace {
  public:
    template <class Plan>
    PredictedPace(const Plan& plan, const CoreParameters& core, int samples_per_tick = 1)
        : walk_(plan),
          serial_(core.build == Build::kSerial),
          latency_(hls::sample_latency(timed_core(core))),
          change_{{{change_clocks(core, ref::CurveKind::kArc),
                    change_clocks(core, ref::CurveKind::kSpline)}}},
          sample_clocks_(change_[plan.segments.front().kind()].sample),
          pace_(hls::samples_ahead(timed_core(core))),
          tick_share_(double(hls::tick_clocks(timed_core(core))) / samples_per_tick) {}

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
        clock_ = std::max(clock_ + sample_clocks_, ready);
        if (serial_ || first) pace_.sample(samples_, static_cast<std::uint64_t>(clock_));
        ++samples_;
    }

    double period() const { return std::max(pace_.period(), tick_share_); }

  private:
    /// Makes a step and returns the clock at which the next sample could be its first.
    double make_step(int clocks) {
        if (serial_) return clock_ += clocks;
        double& bank = free_[steps_++ % free_.size()];
        made_ = std::max(made_, bank) + clocks;
        clock_ = std::max(clock_, made_);
        bank = clock_ + latency_;
        return made_;
    }

    StepWalk walk_;
    bool serial_;
    int latency_;
    ref::ByKind<hls::Clocks> change_;
    int sample_clocks_;  // along the present segment
    SamplePace pace_;
    double tick_share_;             // clocks of a tick of time, for each of its samples
    double clock_ = 0;              // clock of the last sample
    double made_ = 0;               // clock of the last step
    std::array<double, 3> free_{};  // clocks at which the samples have left the step before
    std::size_t steps_ = 0;
    std::uint64_t samples_ = 0;
};

}  // namespace curvecore::sysc
