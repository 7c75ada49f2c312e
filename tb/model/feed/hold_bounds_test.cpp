// SPDX-License-Identifier: Apache-2.0
// Bounds of holds: before anything is planned, of what path and axes can take together; of a plan
// that is short of words, of what its motion takes.
#include "ref/feed/stops/hold_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/planner.hpp"
#include "ref/format/path_words.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::hold_bounds_test {

/// Ticks of a stop from 50 mm/s on slow axes.
std::uint32_t stop_ticks(double path_acceleration, double path_jerk, double unused) {
    ref::Machine machine;
    machine.velocity = 94;
    machine.acceleration = path_acceleration;
    machine.jerk = path_jerk;
    machine.axis[0].velocity = machine.axis[1].velocity = machine.axis[2].velocity = 80;
    machine.axis[0].acceleration = 79;
    machine.axis[1].acceleration = 131;
    machine.axis[2].acceleration = 154;
    machine.axis[0].jerk = machine.axis[1].jerk = 1700;
    machine.axis[2].jerk = 24000;
    machine.axis[3].acceleration = unused;
    ref::Plan plan;
    plan.unit_mm = 1e-6;
    plan.tick_s = 1e-4;
    ref::set_hold_bounds(machine, ref::PlanOptions(), 50, plan);
    return plan.stop_ticks;
}

TEST(HoldBounds, APathLimitBeyondThatOfAllAxesCostsNoTime) {
    std::uint32_t before = stop_ticks(220, 1690, 5000);
    for (const double times : {2, 4, 8, 100}) {
        const std::uint32_t ticks = stop_ticks(220 * times, 1690, 5000);
        EXPECT_LE(ticks, before) << times;
        before = ticks;
    }
    before = stop_ticks(220, 25000, 5000);
    for (const double times : {2, 4, 8, 100}) {
        const std::uint32_t ticks = stop_ticks(220, 25000 * times, 5000);
        EXPECT_LE(ticks, before) << times;
        before = ticks;
    }
}

TEST(HoldBounds, AnAxisThatTheProgramDoesNotUseCostsNoTime) {
    EXPECT_EQ(stop_ticks(220, 1690, 1), stop_ticks(220, 1690, 5000));
}

/// A circle of short arcs with two feeds, so that the path alone has limits, in closed form.
ref::Plan circle(const ref::Machine& machine, double radius, int words) {
    ProgramBuilder builder;
    for (int i = 0; i < 240; ++i) {
        builder.arc({0, radius, 0}, {0, 0, 1}, 0.02, 0, i / 20 % 2 == 0 ? 60 : 200);
    }
    ref::PlanOptions options;
    options.aux_axes = 0;
    options.segment_queue_words = words;
    return ref::make_plan(builder.program(), machine, options);
}

/// Largest share of the limits that a hold takes of this circle's motion at any place.
double hold_load(const ref::Plan& plan, const ref::Machine& machine, double radius) {
    const double change = std::ldexp(plan.hold_acceleration / (plan.tick_s * plan.tick_s), -32);
    const double slope = change * plan.hold_slope_steps * plan.tick_s;
    const double v_unit = plan.unit_mm * ref::kQuantum / plan.tick_s;
    constexpr int kSamples = 32;
    double worst = 0;
    for (const ref::ProfilePiece& piece : plan.pieces) {
        for (int i = 0; i <= kSamples; ++i) {
            const ref::PieceState at = ref::piece_state(piece, piece.ticks * i / double{kSamples});
            const double v = at.v * v_unit;
            const double a = at.a * v_unit / plan.tick_s;
            const double j = at.j * v_unit / (plan.tick_s * plan.tick_s);
            const double acceleration = std::hypot(a, v * v / radius);
            const double jerk = std::hypot(j - v * v * v / (radius * radius), 3 * v * a / radius);
            for (const auto& [rate, part] : {std::pair{7 / 8., 1.}, std::pair{1., 1 / 8.}}) {
                worst = std::max(
                    {worst, (rate * rate * acceleration + part * slope * v) / machine.acceleration,
                     (rate * rate * rate * jerk +
                      part * (3 * rate * slope * acceleration + change * v)) /
                         machine.jerk});
            }
        }
    }
    return worst;
}

/// Stops where a queue is short take all that the motion leaves, and no more.
TEST(HoldBounds, OfAShortQueueTakeWhatTheMotionLeaves) {
    ref::Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.velocity = 1e4;
        axis.acceleration = 1e6;
        axis.jerk = 1e9;
    }
    machine.acceleration = 2000;
    machine.jerk = 50000;
    constexpr double kRadius = 20;
    const ref::Plan free = circle(machine, kRadius, 4096);
    EXPECT_EQ(free.slowed_moves, 0);
    for (const int words : {2048, 1024, 512}) {
        const ref::Plan plan = circle(machine, kRadius, words);
        EXPECT_GT(plan.slowed_moves, 0) << words;
        EXPECT_LT(plan.stop_ticks, free.stop_ticks) << words;
        const double load = hold_load(plan, machine, kRadius);
        EXPECT_LE(load, 1) << words;
        EXPECT_GE(load, 0.9) << words;
    }
}

}  // namespace curvecore::tb::hold_bounds_test
