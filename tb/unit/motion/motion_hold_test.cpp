// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv under hold, kill and invalid settings: what stands, what moves.
#include "hls/registers/registers.h"
#include "tb/support/bench/motion_bench.hpp"

namespace curvecore::tb {
namespace {

using MotionHold = MotionInterpolator;

TEST_F(MotionHold, KillStopsForGood) {
    program(pieces(6, 90, 200, 400, 3 << 16));
    fill();
    requesting_ = true;
    wait(4000 * core_.sample_interval);
    dut_->kill_i = 1;
    clock();
    dut_->kill_i = 0;
    EXPECT_TRUE(dut_->killed_o);
    stand();
    const int64_t path = path_;
    wait(1000);
    EXPECT_EQ(path_, path);
    dut_.reset();
    EXPECT_FALSE(dut_->killed_o);
}

// Hold, kill or override 0, with requests before or without.
TEST_F(MotionHold, NothingMovesWhenTimeIsHeldFromTheStart) {
    for (int round = 0; round < 6; ++round) {
        const bool ahead = round >= 3;
        program(pieces(30 + round, 20, 20, 40, 3 << 16));
        requesting_ = ahead;
        dut_->override_i = round % 3 == 2 ? 0 : 65536;
        dut_->kill_i = round % 3 == 1;
        dut_->hold_i = round % 3 == 0;
        fill();
        requesting_ = true;
        stand();
        fill();
        EXPECT_EQ(path_, 0) << "round " << round;
        EXPECT_FALSE(dut_->active_o) << "round " << round;
        dut_->override_i = 65536;
        if (round % 3 != 1) {
            dut_->hold_i = 0;
            run();
        }
        start_afresh();
        if (HasFatalFailure()) FAIL() << "round " << round;
    }
}

// Holds between programs, while requests continue or pause.
TEST_F(MotionHold, NoProgramBeginsUnderAHold) {
    for (const bool pause : {false, true}) {
        program(pieces(40, 10, 10, 20, 3 << 16));
        fill();
        run();
        const int64_t path = path_;
        requesting_ = !pause;
        dut_->hold_i = pause ? 0 : 1;
        wait(100);
        dut_->hold_i = 1;
        program(pieces(50, 10, 10, 20, 3 << 16));
        requesting_ = true;
        stand();
        fill();
        EXPECT_EQ(path_, path);
        EXPECT_FALSE(dut_->active_o);
        dut_->hold_i = 0;
        run();
        if (HasFatalFailure()) FAIL() << "pause " << pause;
    }
}

// Holds from the ticks before the program's first piece comes to those after it; for a tick or
// until the machine stands.
TEST_F(MotionHold, HoldsAroundTheStartOfAProgram) {
    for (int before = 0; before < 40; ++before) {
        program(pieces(80 + before, 4, 10, 20, 3 << 16));
        requesting_ = true;
        wait(60 + 2 * before);
        dut_->hold_i = 1;
        clock();
        if (before % 2 == 0) stand();
        const int64_t path = path_;
        if (before % 2 == 0) fill();
        EXPECT_EQ(path_, path);
        dut_->hold_i = 0;
        run();
        if (HasFatalFailure()) FAIL() << before;
    }
}

TEST_F(MotionHold, AHoldInAKillChangesNothing) {
    program(pieces(60, 90, 200, 400, 3 << 16));
    fill();
    requesting_ = true;
    wait(2000 * core_.sample_interval);
    dut_->kill_i = 1;
    clock();
    dut_->kill_i = 0;
    for (int n = 0; n < 4000 * core_.sample_interval && !HasFatalFailure(); ++n) {
        dut_->hold_i = n / 50 % 2;
        clock();
    }
    EXPECT_TRUE(dut_->killed_o);
    stand();
    EXPECT_GT(path_, 0);
}

TEST_F(MotionHold, NoTimeRunsWithSettingsThatCannotBe) {
    for (const int which : {0, 1, 2}) {
        if (which == 0) dut_->hold_acceleration_i = 0;
        if (which == 1) dut_->hold_slope_i = kAcceleration - 1;
        if (which == 2) dut_->stop_ticks_i = 0;
        start_afresh();
        program(pieces(70, 10, 10, 20, 3 << 16));
        fill();
        EXPECT_TRUE(dut_->fault_o & CURVECORE_STATE_MOTION_SETTINGS) << which;
        requesting_ = true;
        fill();
        EXPECT_EQ(path_, 0) << which;
        EXPECT_GT(samples_, 100) << which << ": samples come, where it stands";
        dut_->hold_acceleration_i = kAcceleration;
        dut_->hold_slope_i = kSlope;
        dut_->stop_ticks_i = kStopTicks;
        start_afresh();
        EXPECT_FALSE(dut_->fault_o & CURVECORE_STATE_MOTION_SETTINGS) << which;
    }
}

}  // namespace
}  // namespace curvecore::tb
