// SPDX-License-Identifier: Apache-2.0
// Programs in G64 P as they are drawn: the machine's limits hold over every window, by differences
// of the drawn positions, however they were smoothed.
#include <gtest/gtest.h>

#include "ref/feed/planner.hpp"
#include "ref/path/smooth_path.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/random_lines.hpp"

namespace curvecore::tb::smooth_plan_test {

using ref::Effort;
using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;

/// Plans the smooth program, and checks it against the limits.
void expect_kept(Program program, double tolerance, Effort effort) {
    program = with_tolerance(std::move(program), tolerance);
    const ref::Vec3 end = program.moves.back().end;
    const Machine machine;
    ref::smooth_path(program, machine);
    PlanOptions options;
    options.effort = effort;
    const Plan plan = ref::make_plan(program, machine, options);
    const sysc::LimitLoads loads = drawn_limits(plan, machine, options);
    EXPECT_LE(loads.most(), 1 + 1e-9) << text(loads);
    EXPECT_LE((plan.segments.back().end - end / options.unit_mm).norm(), 0.1);
    std::uint64_t ticks = 0;
    std::uint64_t ds = 0;
    for (const ref::ProfilePiece& piece : plan.pieces) {
        ticks += piece.ticks;
        ds += piece.ds;
    }
    EXPECT_DOUBLE_EQ(static_cast<double>(ticks) * plan.tick_s, plan.duration_s);
    const ref::Segment& last = plan.segments.back();
    EXPECT_EQ(ds, last.s_start + last.length);
}

TEST(SmoothPlan, OfChoppedCurvesKeepsTheLimits) {
    for (const ChoppedCurve curve : {chopped_turn, chopped_wave, chopped_circle}) {
        for (const double chord : {0.02, 0.1}) {
            expect_kept(curve(chord, 500), 0.005, Effort::kOptimum);
        }
    }
}

class SmoothPlans : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, SmoothPlans, testing::Range(0, cases(4, 10)),
                         [](const auto& seed) { return "seed_" + std::to_string(seed.param); });

TEST_P(SmoothPlans, KeepTheLimits) {
    for (const Effort effort : {Effort::kRules, Effort::kOptimum}) {
        expect_kept(random_lines(GetParam()), 0.005, effort);
        expect_kept(random_program(GetParam(), 15, 10), 0.05, effort);
    }
}

}  // namespace curvecore::tb::smooth_plan_test
