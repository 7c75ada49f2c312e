// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv keeps the time that a plan gives it: with requests waiting, a sample
// is there whenever one is due.
#include <algorithm>
#include <cmath>

#include "hls/quantise.hpp"
#include "sysc/host/core_clocks.hpp"
#include "tb/support/motion_bench.hpp"
#include "tb/support/tiny_moves.hpp"

namespace curvecore::tb {
namespace {

class MotionTime : public MotionInterpolator {
  protected:
    static CoreParameters core() {
        CoreParameters core;
        core.build = static_cast<Build>(CFG_Build);
        core.order = CFG_Order;
        core.coef_bits = CFG_CoefBits;
        core.position_bits = CFG_PositionBits;
        core.guard_bits = CFG_GuardBits;
        core.aux_axes = CFG_AuxAxes;
        core.splines = CFG_Splines;
        core.mode = CFG_Mode;
        core.anchor = CFG_Anchor;
        core.sample_interval = CFG_SampleInterval;
        core.parameter_guard = CFG_ParameterGuard;
        core.turn_bits = CFG_TurnBits;
        return core;
    }

    /// A plan for so many clocks in a sample period; for a machine that stops quickly, since else
    /// the bench's short queues would bound the speed.
    /// @returns moves that the queues slowed
    std::size_t planned(const ref::Program& program, int period) {
        constexpr double kPeriod = 100e-6;
        ref::PlanOptions options;
        options.sample_period_s = kPeriod;
        options.format = core();
        options.core = core_time(core(), period / kPeriod);
        options.segment_queue_words = CFG_SegmentQueueWords;
        options.profile_queue_words = CFG_ProfileQueueWords;
        ref::Machine machine;
        machine.acceleration = 1e6;
        machine.jerk = 1e9;
        for (ref::AxisLimits& axis : machine.axis) {
            axis.acceleration = machine.acceleration;
            axis.jerk = machine.jerk;
        }
        const ref::Plan plan = make_plan(program, machine, options);
        dut_->hold_acceleration_i = plan.hold_acceleration;
        dut_->hold_slope_i = static_cast<uint64_t>(plan.hold_slope_steps) * plan.hold_acceleration;
        dut_->stop_ticks_i = plan.stop_ticks;
        std::vector<hls::ProfileWords> pieces;
        for (const ref::ProfilePiece& piece : plan.pieces) pieces.push_back(hls::to_words(piece));
        std::vector<hls::SegmentWords<C>> words;
        for (const ref::Segment& segment : plan.segments) {
            words.push_back(hls::to_words<C>(segment));
        }
        send(pieces, words);
        return plan.slowed_moves;
    }

    /// Samples that are not there when they are due, one every `period` clocks.
    int late_samples(int period) {
        fill();
        requesting_ = true;
        taking_ = false;
        for (int n = 0; n < 4000; ++n) clock();
        int late = 0;
        while (path_ < length_ && !HasFatalFailure()) {
            const int64_t before = samples_;
            taking_ = true;
            clock();
            late += samples_ == before ? 1 : 0;
            taking_ = false;
            for (int n = 1; n < period; ++n) clock();
        }
        EXPECT_FALSE(dut_->underrun_o);
        return late;
    }

    static ref::Program tiny_program(unsigned seed) {
        return CFG_Splines ? tiny_splines(seed, 60) : tiny_moves(seed, 120);
    }
};

/// For so few clocks that the core bounds the speed.
TEST_F(MotionTime, EverySampleOfAPlanIsThereWhenItIsDue) {
    if (CFG_Anchor == 0 && CFG_Splines == 1) GTEST_SKIP() << "planned for Anchor 1";
    const double clocks = least_period_clocks(core(), CFG_Splines != 0);
    const int least = std::max(8, static_cast<int>(std::ceil(clocks)));
    for (const int period : {least, std::max(60, 2 * least)}) {
        for (unsigned seed = 1; seed <= 2; ++seed) {
            EXPECT_EQ(planned(tiny_program(seed), period), 0);
            EXPECT_EQ(late_samples(period), 0) << period << " clocks, seed " << seed;
            EXPECT_GT(samples_, 100);
            start_afresh();
        }
    }
    // Control: samples are taken twice as fast as was planned.
    planned(even_lines(1000), least);
    EXPECT_GT(late_samples(least / 2), 0);
}

}  // namespace
}  // namespace curvecore::tb
