// SPDX-License-Identifier: Apache-2.0
// A motion_system made of scripts/flat.sh's file: it has the inputs of the sources, and must have
// their outputs, on every clock.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "Vflat_motion_system.h"
#include "Vmotion_system.h"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::tb {

class FlatTwin {
  public:
    FlatTwin() {
        dut_.limit_cycles(UINT64_MAX);
        dut_->valid_i = 0;
        dut_->estop_i = 0;
        dut_->limit_i = 0;
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        dut_->probe_i = 0;
        dut_->home_i = 0;
        dut_->encoder_a_i = 0;
        dut_->encoder_b_i = 0;
        dut_.reset();
    }

    /// Advances by one clock, after which both had the same inputs.
    void follow(const Vmotion_system& source, int64_t clock) {
        dut_->rst_ni = source.rst_ni;
        dut_->valid_i = source.valid_i;
        dut_->write_i = source.write_i;
        dut_->word_i = source.word_i;
        dut_->data_i = source.data_i;
        dut_->estop_i = source.estop_i;
        dut_->limit_i = source.limit_i;
        dut_->segment_valid_i = source.segment_valid_i;
        dut_->segment_data_i = source.segment_data_i;
        dut_->profile_valid_i = source.profile_valid_i;
        dut_->profile_data_i = source.profile_data_i;
        dut_->probe_i = source.probe_i;
        dut_->home_i = source.home_i;
        dut_.tick();
        const bool reads = source.done_o && !source.error_o && !source.write_i;
        const bool equal =
            dut_->done_o == source.done_o && (!source.done_o || dut_->error_o == source.error_o) &&
            (!reads || dut_->data_o == source.data_o) && dut_->step_o == source.step_o &&
            dut_->direction_o == source.direction_o && dut_->enable_o == source.enable_o;
        if (!equal && !testing::Test::HasFailure()) ADD_FAILURE() << "differs at clock " << clock;
    }

  private:
    sysc::ClockedDut<Vflat_motion_system> dut_;
};

}  // namespace curvecore::tb
