// SPDX-License-Identifier: Apache-2.0
// The Verilated step_generator as a block, clock by clock.
#pragma once

#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "sysc/steps/step_block.hpp"

namespace curvecore::sysc {

template <class Model>
class RtlSteps : public StepBlock {
  public:
    RtlSteps(const StepSetup& setup, int model_axes)
        : axes_(setup.axes), period_(std::uint64_t(1) << setup.period_log2) {
        dut_.limit_cycles(~std::uint64_t(0));
        drive_idle();
        drive(setup.times);
        dut_.reset();
        for (int a = 0; a < model_axes; ++a) set_scale(a, setup.scale);
        dut_->reference_i = to_port((1 << model_axes) - 1, model_axes);
        dut_.tick();
        dut_->reference_i = 0;
        while (!dut_->tick_o) dut_.tick();
        dut_.tick();
    }

    void period(const std::int64_t* positions, std::vector<PinChange>& changes) override {
        if (positions != nullptr) {
            for (int a = 0; a < axes_; ++a) {
                set_field(dut_->sample_i, a * kStepFineBits, kStepFineBits, positions[a]);
            }
            dut_->sample_valid_i = 1;
            dut_.settle();
        }
        for (std::uint64_t left = period_; left > 0; --left) {
            const bool taken = dut_->sample_valid_i && dut_->sample_ready_o;
            dut_.tick();
            if (taken) dut_->sample_valid_i = 0;
            look(changes);
            ++clock_;
        }
    }

    StepFlags flags(int axis) const override {
        return {(dut_->overrun_o >> axis & 1) != 0, (dut_->refused_o >> axis & 1) != 0};
    }

  private:
    void drive_idle() {
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
    }

    void drive(const hls::PulseTimes& times) {
        dut_->steplen_i = to_port(times.steplen, kStepTimeBits);
        dut_->stepspace_i = to_port(times.stepspace, kStepTimeBits);
        dut_->dirsetup_i = to_port(times.dirsetup, kStepTimeBits);
        dut_->dirhold_i = to_port(times.dirhold, kStepTimeBits);
    }

    void set_scale(int axis, std::int64_t scale) {
        dut_->scale_write_i = 1;
        dut_->scale_axis_i = static_cast<unsigned>(axis);
        dut_->scale_i = to_port(scale, kStepScaleBits);
        dut_.tick();
        dut_->scale_write_i = 0;
    }

    void look(std::vector<PinChange>& changes) {
        const unsigned step = dut_->step_o;
        const unsigned direction = dut_->direction_o;
        if (step == step_ && direction == direction_) return;
        for (int a = 0; a < axes_; ++a) {
            const bool steps = ((step ^ step_) >> a & 1) != 0;
            const bool turns = ((direction ^ direction_) >> a & 1) != 0;
            if (steps) changes.push_back({clock_, a, Pin::kStep, (step >> a & 1) != 0});
            if (turns) changes.push_back({clock_, a, Pin::kDirection, (direction >> a & 1) != 0});
        }
        step_ = step;
        direction_ = direction;
    }

    ClockedDut<Model> dut_;
    int axes_;
    std::uint64_t period_;
    std::uint64_t clock_ = 0;
    unsigned step_ = 0;
    unsigned direction_ = 0;
};

}  // namespace curvecore::sysc
