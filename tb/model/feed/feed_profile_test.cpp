// SPDX-License-Identifier: Apache-2.0
// Feed profiles: exact stops, continuous speed, limits that hold, look-ahead that pays.
#include <gtest/gtest.h>

#include <climits>
#include <ctime>

#include "hls/path_kernel.hpp"
#include "hls/quantise.hpp"
#include "hls/time_scaler.hpp"
#include "ref/feed/pieces/limit_report.hpp"
#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/planner.hpp"
#include "ref/feed/ramps/ramp.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::feed_profile_test {

using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::ProfilePiece;
using ref::Program;

double ulp(const ProfilePiece& piece) { return std::ldexp(1.0, piece.exponent - 34); }

/// Largest jump of speed between pieces, in last bits of the coarser word.
double worst_jump(const Plan& plan) {
    double worst = 0;
    double v = 0;
    double bit = 0;
    for (const ProfilePiece& piece : plan.pieces) {
        const double own = ulp(piece) * std::ldexp(1.0, -piece.time_exponent);
        const double jump = std::abs(ref::piece_state(piece, 0).v - v);
        worst = std::max(worst, jump / std::max(own, bit));
        v = ref::piece_state(piece, piece.ticks).v;
        bit = own;
    }
    return std::max(worst, std::abs(v) / bit);
}

std::uint64_t path(const Plan& plan) {
    std::uint64_t sum = 0;
    for (const ProfilePiece& piece : plan.pieces) sum += piece.ds;
    return sum;
}

std::uint64_t length(const Plan& plan) {
    return plan.segments.back().s_start + plan.segments.back().length;
}

/// A stop: a boundary of pieces where the speed is zero, at the path length `s`; ticks of rest
/// there.
struct Stop {
    bool found = false;
    double rest_s = 0;
};
Stop stop_at(const Plan& plan, std::uint64_t s) {
    Stop stop;
    std::uint64_t sum = 0;
    for (const ProfilePiece& piece : plan.pieces) {
        if (sum == s && piece.ds == 0) stop.rest_s += piece.ticks * plan.tick_s;
        sum += piece.ds;
        const double v = ref::piece_state(piece, piece.ticks).v;
        if (sum == s && v < 16 * ulp(piece)) stop.found = true;
    }
    return stop;
}

double feed_after(const Plan& plan, std::size_t move) {
    double feed = -1;
    for (const ref::Segment& segment : plan.segments) {
        if (segment.move == move) feed = segment.feed_end;
    }
    return feed;
}

Program line(double mm, double feed) {
    ProgramBuilder builder;
    builder.line({mm, 0, 0}, feed);
    return builder.program();
}

TEST(FeedProfile, PiecesSumToThePathAndFitTheirWords) {
    for (int seed = 1; seed <= cases(2, 8); ++seed) {
        const Plan plan = make_plan(random_program(seed, 400), Machine(), PlanOptions());
        EXPECT_EQ(path(plan), length(plan)) << seed;
        EXPECT_LT(worst_jump(plan), 8) << seed;
        for (const ProfilePiece& piece : plan.pieces) {
            EXPECT_GE(piece.ticks, 1u);
            EXPECT_LE(piece.ticks, 1u << piece.time_exponent);
            EXPECT_LE(piece.time_exponent, 19);
            EXPECT_LE(piece.exponent, ref::kMaxPlannedExponent);
            for (const std::int64_t c : piece.c) EXPECT_LT(std::abs(c), std::int64_t{1} << 35);
            EXPECT_EQ(piece.final, &piece == &plan.pieces.back());
            const double end = ref::piece_state(piece, piece.ticks).s;
            EXPECT_LE(std::abs(end - static_cast<double>(piece.ds)), ulp(piece) / 2 * 1.01);
            // Horner's partial sums.
            for (int i = 0; i <= 8; ++i) {
                const double tau = i / 8.0 * piece.ticks / std::ldexp(1.0, piece.time_exponent);
                const double c2 =
                    static_cast<double>(piece.c[1]) + tau * static_cast<double>(piece.c[2]);
                EXPECT_LT(std::abs(c2), 0x1p35);
                EXPECT_LT(std::abs(static_cast<double>(piece.c[0]) + tau * c2), 0x1p35);
            }
        }
    }
}

TEST(FeedProfile, KernelWalksThePathWithoutGoingBack) {
    const Plan plan = make_plan(random_program(11, 60, 2), Machine(), PlanOptions());
    hls::PathKernel kernel;
    std::size_t next = 0;
    const auto feed = [&](hls::ProfileWords& words) {
        if (next == plan.pieces.size()) return false;
        words = hls::to_words(plan.pieces[next++]);
        return true;
    };
    std::int64_t s = 0;
    std::int64_t ticks = 0;
    do {
        const std::int64_t ds = hls::to_int(kernel.tick(1 << 16, feed));
        ASSERT_GE(ds, 0);
        s += ds;
        ++ticks;
    } while (kernel.active());
    EXPECT_EQ(static_cast<std::uint64_t>(s), length(plan));
    EXPECT_NEAR(static_cast<double>(ticks) * plan.tick_s, plan.duration_s, 1.5 * plan.tick_s);
}

// Control: the checks above fail after a change of one part in a million, or of a quantum.
TEST(FeedProfile, ContinuityAndSumSeeSmallFaults) {
    Plan plan = make_plan(line(10, 100), Machine(), PlanOptions());
    EXPECT_LT(worst_jump(plan), 8);
    plan.pieces[2].c[0] += plan.pieces[2].c[0] / 1000000;
    EXPECT_GT(worst_jump(plan), 8);
    plan.pieces[1].ds += 1;
    EXPECT_NE(path(plan), length(plan));
}

class FeedEffort : public testing::TestWithParam<ref::Effort> {};

TEST_P(FeedEffort, LimitsHoldOnRandomPrograms) {
    const int programs = GetParam() == ref::Effort::kRules ? cases(8, 20) : cases(3, 6);
    for (unsigned seed = 20; seed < 20U + programs; ++seed) {
        const Machine machine = unequal_machine(seed);
        PlanOptions options;
        options.effort = GetParam();
        options.unit_mm = seed % 2 ? 1e-6 : 1e-5;
        options.sample_period_s = seed % 3 ? 1e-4 : 2e-5;
        options.samples_per_tick = seed % 5 ? 1 : 4;
        const Program program = random_program(seed, 300);
        const Plan plan = make_plan(program, machine, options);
        const ref::LimitReport report = limit_report(program, machine, plan);
        EXPECT_LE(report.inside.velocity, 1) << seed;
        EXPECT_LE(report.inside.acceleration, 1) << seed;
        EXPECT_LE(report.inside.jerk, 1) << seed;
        EXPECT_LE(report.joints.acceleration, 1) << seed;
        EXPECT_LE(report.joints.jerk, 1) << seed;
        EXPECT_GT(report.passed, 20) << seed;
        // Control: a weaker machine is overloaded by the same plan.
        Machine weak = machine;
        weak.jerk /= 3;
        weak.acceleration /= 3;
        for (ref::AxisLimits& axis : weak.axis) {
            axis.jerk /= 3;
            axis.acceleration /= 3;
        }
        const ref::LimitReport over = limit_report(program, weak, plan);
        EXPECT_GT(over.inside.acceleration, 1) << seed;
        EXPECT_GT(over.inside.jerk, 1) << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(, FeedEffort, testing::Values(ref::Effort::kRules, ref::Effort::kOptimum),
                         [](const auto& effort) {
                             return effort.param == ref::Effort::kRules ? "rules" : "optimum";
                         });

TEST(FeedProfile, LineIsAsFastAsItsLimitsAllow) {
    const Machine machine;
    const double a = 0.95 * machine.acceleration;  // the rest is for holds
    const double j = 0.95 * machine.jerk;
    for (const double mm : {0.01, 1.0, 10.0, 300.0}) {
        for (const double feed : {1.0, 50.0, 400.0}) {
            const double peak = ref::peak_speed(0, 0, mm, a, j, feed);
            const ref::Ramp ramp(0, peak, a, j);
            const double best = 2 * ramp.duration() + (mm - 2 * ramp.length()) / peak;
            const Plan plan = make_plan(line(mm, feed), machine, PlanOptions());
            EXPECT_GE(plan.duration_s, best - 1e-9);
            EXPECT_LE(plan.duration_s, best + plan.tick_s + 1e-9) << mm << " at " << feed;
        }
    }
}

TEST(FeedProfile, ChainOfTangentMovesTakesAsLongAsOne) {
    const double whole = make_plan(line(100, 150), Machine(), PlanOptions()).duration_s;
    ProgramBuilder chain;
    for (int i = 1; i <= 80; ++i) chain.line({i * 1.25, 0, 0}, 150);
    const Plan plan = make_plan(chain.program(), Machine(), PlanOptions());
    EXPECT_NEAR(plan.duration_s, whole, 2 * plan.tick_s);
    EXPECT_NEAR(feed_after(plan, 39), 150, 150 * plan.tick_s / plan.duration_s);
    EXPECT_LT(plan.pieces.size(), 100u);  // branches stand between them
}

// Feeds that vary from move to move: a ramp runs over moves whose limits it does not touch.
TEST(FeedProfile, RampsRunAcrossMovesOfDifferentFeed) {
    const double whole = make_plan(line(100, 150), Machine(), PlanOptions()).duration_s;
    ProgramBuilder chain;
    for (int i = 1; i <= 1000; ++i) chain.line({i * 0.1, 0, 0}, 150 + 20 * ((i * 7) % 5));
    PlanOptions options;
    options.segment_queue_words = INT_MAX;  // not what queues of segments cover
    EXPECT_LE(make_plan(chain.program(), Machine(), options).duration_s, 1.1 * whole)
        << "evened out where ramps are more words than the queue has";
    options.profile_queue_words = 1 << 16;
    EXPECT_LE(make_plan(chain.program(), Machine(), options).duration_s, whole + options.tick_s());
}

TEST(FeedProfile, CornersStopAndTangentJointsDoNot) {
    ProgramBuilder builder;
    builder.line({50, 0, 0}, 100);
    builder.line({50, 50, 0}, 100);                              // corner
    builder.tangent_arc({0, 1, 0}, {1, 0, 0}, 2000, 0.02, 100);  // tangent
    builder.line(builder.at() + 30 * end_tangent(builder.program().moves.back()), 100);
    Machine machine;
    const Plan plan = make_plan(builder.program(), machine, PlanOptions());
    EXPECT_NEAR(feed_after(plan, 0), 0, 1e-6);
    EXPECT_TRUE(stop_at(plan, plan.segments[1].s_start).found);
    EXPECT_NEAR(feed_after(plan, 1), 100, 1e-2);
    EXPECT_NEAR(feed_after(plan, 2), 100, 1e-2);
    EXPECT_NEAR(feed_after(plan, 3), 0, 1e-6);
}

TEST(FeedProfile, SmallTurnIsPassedAtTheSpeedOfJointTime) {
    const double turn = 0.1;
    ProgramBuilder builder;
    builder.line({50, 0, 0}, 200);
    builder.line(builder.at() + 50 * ref::Vec3(std::cos(turn), std::sin(turn), 0), 200);
    const Machine machine;
    const double limit = machine.acceleration * machine.joint_time / (2 * std::sin(turn / 2));
    const Plan plan = make_plan(builder.program(), machine, PlanOptions());
    EXPECT_LE(feed_after(plan, 0), limit);
    EXPECT_GE(feed_after(plan, 0), 0.98 * limit);
}

TEST(FeedProfile, StepOfCurvatureIsPassedAtTheSpeedOfJointTime) {
    const double radius = 20;
    ProgramBuilder builder;
    builder.line({50, 0, 0}, 200);
    builder.tangent_arc({1, 0, 0}, {0, 1, 0}, radius, 2, 200);
    const Machine machine;
    const double limit = std::sqrt(machine.jerk * machine.joint_time * radius);
    const Plan plan = make_plan(builder.program(), machine, PlanOptions());
    EXPECT_LE(feed_after(plan, 0), limit);
    EXPECT_GE(feed_after(plan, 0), 0.98 * limit);
}

TEST(FeedProfile, ExactStopAndDwellRest) {
    ProgramBuilder builder;
    builder.line({5, 0, 0}, 50).exact_stop = true;
    builder.line({10, 0, 0}, 50).dwell = 0.25;
    builder.line({15, 0, 0}, 50).dwell = 60;
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_TRUE(stop_at(plan, plan.segments[1].s_start).found);
    EXPECT_NEAR(stop_at(plan, plan.segments[2].s_start).rest_s, 0.25, 1e-9);
    EXPECT_NEAR(stop_at(plan, length(plan)).rest_s, 60, 1e-9);
    EXPECT_TRUE(plan.pieces.back().final);
    EXPECT_EQ(plan.pieces.back().ds, 0u);
}

TEST(FeedProfile, DwellBeforeTheFirstMotionIsARest) {
    ProgramBuilder builder;
    builder.line({0, 0, 0}, 50).dwell = 0.1;
    builder.line({1, 0, 0}, 50);
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_EQ(plan.pieces.front().ds, 0u);
    EXPECT_EQ(plan.pieces[0].ticks + plan.pieces[1].ticks, 1000u);
    EXPECT_EQ(plan.segments.size(), 1u);
}

TEST(FeedProfile, MovesOfAFewQuantaWork) {
    for (const double units : {1.0 / 65536, 3.0 / 65536, 0.01, 1.0, 20.0}) {
        const Plan plan = make_plan(line(units * 1e-6, 0), Machine(), PlanOptions());
        EXPECT_EQ(path(plan), static_cast<std::uint64_t>(std::llround(units * 65536)));
        EXPECT_TRUE(plan.pieces.back().final);
    }
}

TEST(FeedProfile, LatencyOfTheNetworkBoundsTheSpeed) {
    ProgramBuilder builder;
    builder.line({900, 0, 0}, 0);
    PlanOptions options;
    options.sample_period_s = 1e-6;  // shorter than the latency: one step at a time
    options.samples_per_tick = 128;
    options.core.curve[ref::CurveKind::kArc] = {1, 1};  // s
    const Machine machine;
    const Plan plan = make_plan(builder.program(), machine, options);
    const double step = std::ldexp(1e-6, plan.segments[0].step_exponent);
    const double speed = step / 1.0;  // mm per second of latency
    EXPECT_GT(step, 100);
    EXPECT_GE(plan.duration_s, 900 / speed - 1);  // the first step is there
}

/// Processor time of planning `moves` moves, seconds.
double planning_time(int moves) {
    const Program program = random_program(99, moves, 0.05);
    const std::clock_t begin = std::clock();
    const Plan plan = make_plan(program, Machine(), PlanOptions());
    const std::clock_t end = std::clock();
    EXPECT_EQ(path(plan), length(plan));
    return static_cast<double>(end - begin) / CLOCKS_PER_SEC;
}

TEST(FeedProfile, PlansManyMovesInLinearTime) {
    const int moves = cases(20'000, 100'000);
    const double tenth = planning_time(moves / 10);
    const double whole = planning_time(moves);
    RecordProperty("seconds", std::to_string(whole));
    EXPECT_LT(whole, 25 * tenth);  // quadratic: 100
}

// Holds within a line: the kernel's path under the kernel's time scaler, second difference.
TEST(FeedProfile, HoldsStayWithinTheAccelerationLimit) {
    const Machine machine;
    const Plan plan = make_plan(line(60, 0), machine, PlanOptions());
    const double quantum = plan.unit_mm / 65536;
    double worst = 0;
    const auto total = static_cast<int>(plan.duration_s / plan.tick_s);
    for (int hold_at = 0; hold_at < total; hold_at += 37) {
        hls::PathKernel kernel;
        hls::TimeScaler scaler(plan.hold_acceleration,
                               std::int64_t{plan.hold_acceleration} * plan.hold_slope_steps);
        std::size_t next = 0;
        const auto feed = [&](hls::ProfileWords& words) {
            if (next == plan.pieces.size()) return false;
            words = hls::to_words(plan.pieces[next++]);
            return true;
        };
        double before = 0;
        std::int64_t s = 0;
        for (int tick = 0; next == 0 || kernel.active(); ++tick) {
            const bool hold = tick >= hold_at && tick < hold_at + 4000;
            const std::int32_t rate = scaler.tick(hold ? 0 : 1 << 16);
            const std::int64_t ds = hls::to_int(kernel.tick(rate, feed, hold));
            s += ds;
            const double v = static_cast<double>(ds) * quantum / plan.tick_s;
            worst = std::max(worst, std::abs(v - before) / plan.tick_s);
            before = v;
        }
        ASSERT_EQ(static_cast<std::uint64_t>(s), length(plan));
    }
    // r has 16 fraction bits: v 2^-16 per tick on top of the limit.
    const double rounding = machine.velocity / 65536 / plan.tick_s;
    EXPECT_LE(worst, machine.acceleration + 2 * rounding);
    EXPECT_GE(worst, 0.85 * machine.acceleration);
}

}  // namespace curvecore::tb::feed_profile_test
