// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv with stop branches between its pieces: every rate is the kernel's.
#include "hls/quantise.hpp"
#include "ref/feed/planner.hpp"
#include "ref/feed/stops/planned_branches.hpp"
#include "sysc/core/core_clocks.hpp"
#include "tb/support/bench/motion_bench.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {
namespace {

class MotionStop : public MotionInterpolator {
  protected:
    /// Adds the pieces of a plan with its stop branches and bounds; the segments are random.
    void program_of(const ref::Plan& plan) {
        const int64_t slope = int64_t{plan.hold_acceleration} * plan.hold_slope_steps;
        dut_->hold_acceleration_i = plan.hold_acceleration;
        dut_->hold_slope_i = static_cast<uint64_t>(slope);
        dut_->stop_ticks_i = plan.stop_ticks;
        scaler_ = {plan.hold_acceleration, slope};
        std::vector<hls::ProfileWords> pieces;
        for (const ref::ProfilePiece& piece : plan.pieces) pieces.push_back(hls::to_words(piece));
        planned_stops_.resize(pieces.size());
        for (const ref::PlannedBranch& branch : plan.branches) {
            Stop& stop = planned_stops_[branch.piece];
            stop.wait = static_cast<int32_t>(branch.wait);
            for (const ref::StopStep& step : branch.steps) {
                stop.steps.push_back(hls::to_words(step, &step == &branch.steps.back()));
            }
        }
        program(pieces);
    }
};

/// A line and a turn at full speed.
ref::Plan fast_plan() {
    ProgramBuilder builder;
    builder.line({120, 0, 0}, 500);
    builder.tangent_arc({0, 0, 1}, {1, 0, 0}, 30, 6, 500);
    ref::PlanOptions options;
    options.unit_mm = 0.1;
    ref::Machine machine;  // its stops are shorter than the queue with such short segments
    machine.acceleration *= 4;
    machine.jerk *= 20;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.acceleration *= 4;
        axis.jerk *= 20;
    }
    return make_plan(builder.program(), machine, options);
}

TEST_F(MotionStop, EqualsKernelsUnderHoldsAndOverrides) {
    rates_ = Rates::kOfKernel;
    branch_percent_ = 60;
    int64_t stops = 0;
    const int rounds = cases(core_.build == Build::kEngine ? 5 : 10, 30);
    for (int round = 0; round < rounds; ++round) {
        program(pieces(static_cast<uint32_t>(500 + round), 60, 10, 60, 3 << 16));
        fill();
        const auto every = static_cast<unsigned>(50 << round % 4) *
                           static_cast<unsigned>(hls::tick_clocks(timed_core(core_)));
        unsigned clocks_to_hold = 0;
        run([&] {
            if (random_() % every == 0) dut_->hold_i = random_() % 2;
            if (random_() % (8 * every) == 0) {
                dut_->override_i = random_() % 3 == 0 ? random_() % 65537 : 65536;
            }
            // A rate that is at rest again at once, and a hold while the branch before is due.
            if (random_() % (2 * every) == 0) {
                dut_->override_i = 65536 - random_() % 256;
                clocks_to_hold = 1 + random_() % every;
            }
            if (clocks_to_hold > 0 && --clocks_to_hold == 0) dut_->hold_i = 1;
        });
        if (HasFatalFailure()) FAIL() << "round " << round;
        dut_->hold_i = 0;
        dut_->override_i = 65536;
        stops = steps_;
    }
    EXPECT_GT(stops, 5 * rounds / 3);
    const auto is_again = [](const Stop& stop) { return stop.again; };
    EXPECT_GT(std::count_if(stops_.begin(), stops_.end(), is_again), rounds);
}

/// A hold lasts as long as the plan says, if the rate has been 1 for as long as branches are apart.
TEST_F(MotionStop, OfAPlanIsOverInTheTimeThatItTells) {
    rates_ = Rates::kOfKernel;
    const ref::Plan plan = fast_plan();
    ASSERT_GT(plan.branches.size(), 10U);
    program_of(plan);
    fill();
    const auto longest = static_cast<std::size_t>(longest_stop(plan)) + 1;
    const std::size_t apart = 400;  // ticks, and the way to the core
    std::size_t held = 0;           // ticks since the hold began; 0: none
    std::size_t full = 0;           // ticks at the rate 1
    std::size_t moves = 0;          // checked moves
    int stops = 0;
    run([&] {
        if (moves == moves_.size()) return;
        moves = moves_.size();
        full = rate_ == 1 << 16 ? full + 1 : 0;
        const std::size_t under_way = targets_.size();  // the hold has no effect yet
        if (held == 0 && full > apart && random_() % 200 == 0) {
            dut_->hold_i = 1;
            held = moves + under_way;
        } else if (held > 0 && rate_ == 0) {
            EXPECT_LE(moves - held, longest) << stops;
            dut_->hold_i = 0;
            held = 0;
            ++stops;
        }
    });
    EXPECT_GE(stops, 2);
}

}  // namespace
}  // namespace curvecore::tb
