// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv keeps the time of a plan: with requests waiting, a sample is ready
// whenever one is due.
#include <algorithm>
#include <cmath>

#include "hls/quantise.hpp"
#include "ref/feed/planner.hpp"
#include "sysc/core/core_clocks.hpp"
#include "tb/support/bench/motion_bench.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/tiny_moves.hpp"

namespace curvecore::tb {
namespace {

class MotionTime : public MotionInterpolator {
  protected:
    /// Plans for `period` clocks in a sample period; the machine stops quickly, since otherwise the
    /// bench's short queues would bound the speed.
    /// @returns moves that the queues slowed
    std::size_t planned(const ref::Program& program, int period) {
        constexpr double kPeriod = 100e-6;
        ref::PlanOptions options;
        options.sample_period_s = kPeriod;
        options.format = core_;
        options.core = core_time(core_, period / kPeriod);
        options.segment_queue_words = core_configuration().segment_queue_words;
        options.profile_queue_words = core_configuration().profile_queue_words;
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
        std::vector<RunSegment> words;
        for (const ref::Segment& segment : plan.segments) {
            words.push_back(hls::to_words(segment, format_));
        }
        join(words);
        send(pieces, words);
        return plan.slowed_moves;
    }

    /// Number of samples that are late, with one due every `period` clocks.
    int late_samples(int period) {
        fill();
        requesting_ = true;
        taking_ = false;
        wait(4000);
        int late = 0;
        while (path_ < length_ && !HasFatalFailure()) {
            const int64_t before = samples_;
            taking_ = true;
            clock();
            late += samples_ == before ? 1 : 0;
            taking_ = false;
            for (int n = 1; n < period; ++n) clock();
        }
        return late;
    }

    ref::Program tiny_program(unsigned seed) const {
        return core_.splines != 0 ? tiny_splines(seed, 60) : tiny_moves(seed, 120);
    }
};

/// Plans for a period short enough that the core bounds the speed.
TEST_F(MotionTime, EverySampleOfAPlanIsThereWhenItIsDue) {
    const double clocks = least_period_clocks(core_, core_.splines != 0);
    const int least = std::max(8, static_cast<int>(std::ceil(clocks)));
    for (const int period : {least, std::max(60, 2 * least)}) {
        for (unsigned seed = 1; seed <= static_cast<unsigned>(cases(1, 4)); ++seed) {
            EXPECT_EQ(planned(tiny_program(seed), period), 0);
            EXPECT_EQ(late_samples(period), 0) << period << " clocks, seed " << seed;
            EXPECT_FALSE(dut_->underrun_o);
            EXPECT_GT(samples_, 100);
            start_afresh();
        }
    }
    // Control: samples are taken twice as fast as planned, of the engine, whose bounds are those of
    // its longest ways, eight times. They are late, or their words are.
    planned(even_lines(1000), least);
    rates_ = Rates::kAny;
    const int part = core_.build == Build::kEngine ? 8 : 2;
    EXPECT_TRUE(late_samples(least / part) > 0 || dut_->underrun_o);
}

}  // namespace
}  // namespace curvecore::tb
