// SPDX-License-Identifier: Apache-2.0
// The step generator under test: settings, samples and pins, by axis.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "Vstep_generator.h"
#include "hls/step_axis.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;

constexpr int kStepAxes = CFG_Axes;
constexpr int kFineBits = CFG_FineBits;
constexpr int kScaleBits = CFG_ScaleBits;
constexpr int kPeriodLog2 = CFG_PeriodLog2;
constexpr int kTimeBits = CFG_TimeBits;
/// Scales of motions: a step is four units of the position or more.
constexpr int kMotionScaleBits = kScaleBits < kFineBits + 14 ? kScaleBits : kFineBits + 14;
/// Greatest time beside a pulse of at most 8 clocks.
constexpr int kMostTime = (1 << kTimeBits) - 9;
constexpr int64_t kPeriod = int64_t{1} << kPeriodLog2;
constexpr int64_t kEveryAxis = (1 << kStepAxes) - 1;

/// Clocks from the tick of a period to its first clock at axis 0, to the pin
/// (rtl/pulse/step_generator.sv).
constexpr int64_t kLatency = 6;

class StepBench {
  public:
    StepBench() {
        dut_.limit_cycles(UINT64_MAX);
        dut_->scale_write_i = 0;
        dut_->sample_valid_i = 0;
        dut_->reference_i = 0;
        dut_->estop_i = 0;
        dut_->limit_i = 0;
        dut_->limit_masked_i = 0;
        dut_->by_axis_i = 0;
        dut_->begins_i = 0;
        dut_->stop_i = 0;
        dut_->step_inverted_i = 0;
        dut_->direction_inverted_i = 0;
        set_times({});
        reset();
    }

    void reset() {
        dut_->sample_valid_i = 0;
        dut_.reset();
        clock_ = 0;
        tick_ = -1;
        late_ = 0;
    }

    void set_times(const hls::PulseTimes& times) {
        dut_->steplen_i = to_port(times.steplen, kTimeBits);
        dut_->stepspace_i = to_port(times.stepspace, kTimeBits);
        dut_->dirsetup_i = to_port(times.dirsetup, kTimeBits);
        dut_->dirhold_i = to_port(times.dirhold, kTimeBits);
    }

    void set_scale(int axis, int64_t scale) {
        dut_->scale_write_i = 1;
        dut_->scale_axis_i = static_cast<unsigned>(axis);
        dut_->scale_i = to_port(scale, kScaleBits);
        clock();
        dut_->scale_write_i = 0;
    }

    void reference(int64_t axes = kEveryAxis) {
        dut_->reference_i = to_port(axes, kStepAxes);
        clock();
        dut_->reference_i = 0;
    }

    void offer(const std::vector<int64_t>& positions) {
        for (int a = 0; a < kStepAxes; ++a) {
            set_field(dut_->sample_i, a * kFineBits, kFineBits, positions[a]);
        }
        dut_->sample_valid_i = 1;
    }

    /// Advances by one clock. Returns true if it took the sample.
    bool clock() {
        dut_.settle();
        const bool taken = dut_->sample_valid_i && dut_->sample_ready_o;
        if (dut_->tick_o) tick_ = clock_;
        dut_.tick();
        ++clock_;
        late_ += dut_->late_o;
        if (taken) dut_->sample_valid_i = 0;
        if (each_clock) each_clock();
        return taken;
    }
    void clocks(int64_t n) {
        while (n-- > 0) clock();
    }

    /// Offers a sample until it is taken.
    void sample(const std::vector<int64_t>& positions) {
        offer(positions);
        while (!clock()) {
        }
    }

    bool step(int axis) { return dut_->step_o >> axis & 1; }
    bool direction(int axis) { return dut_->direction_o >> axis & 1; }

    int64_t now() const { return clock_; }    // clocks so far
    int64_t ticked() const { return tick_; }  // the clock of the last tick
    int late() const { return late_; }        // clocks of late_o
    Vstep_generator* operator->() { return dut_.operator->(); }

    std::function<void()> each_clock;  // called after each

  private:
    ClockedDut<Vstep_generator> dut_;
    int64_t clock_ = 0;
    int64_t tick_ = -1;
    int late_ = 0;
};

}  // namespace curvecore::tb
