// SPDX-License-Identifier: Apache-2.0
// A Verilated motion_board as a VirtualModel: compiled once for each model.
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/virtual/virtual_model.hpp"
#include CFG_HEADER

namespace curvecore::sysc {
namespace {

class CompiledBoard : public VirtualModel {
  public:
    CompiledBoard() {
        dut_.limit_cycles(UINT64_MAX);
        dut_->byte_ready_i = 1;
        dut_->estop_i = 0;
        dut_->probe_i = 0;
    }

    void reset() override {
        drive();
        dut_.reset();
        follow();
    }

    void tick() override {
        drive();
        dut_.tick();
        follow();
    }

  private:
    void drive() {
        dut_->byte_valid_i = in.byte_valid ? 1 : 0;
        dut_->byte_i = in.byte;
        dut_->home_i = in.home;
        dut_->limit_i = in.limit;
        dut_->encoder_a_i = in.encoder_a;
        dut_->encoder_b_i = in.encoder_b;
    }

    void follow() {
        out.byte_ready = dut_->byte_ready_o != 0;
        out.byte_valid = dut_->byte_valid_o != 0;
        out.byte = dut_->byte_o;
        out.enable = dut_->enable_o != 0;
        out.step = dut_->step_o;
        out.direction = dut_->direction_o;
        out.outputs = dut_->output_o | (dut_->pwm_o != 0 ? 1U << 8 : 0);
        clocks = dut_.cycle();
    }

    ClockedDut<CFG_MODEL> dut_;
};

}  // namespace

extern "C" VirtualModel* CFG_FUNCTION() { return new CompiledBoard; }

}  // namespace curvecore::sysc
