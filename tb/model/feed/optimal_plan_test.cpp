// SPDX-License-Identifier: Apache-2.0
// Plans of the effort `optimum`: faster than the rules, and within the same limits over windows of
// the drawn motion, in holds as well.
#include <gtest/gtest.h>

#include <random>

#include "ref/feed/pieces/limit_report.hpp"
#include "ref/feed/pieces/piece_walk.hpp"
#include "ref/feed/planner.hpp"
#include "ref/limits/limits.hpp"
#include "ref/numeric/newton_work.hpp"
#include "ref/path/smooth_path.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/judge/tick_run.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/random_joints.hpp"
#include "tb/support/programs/random_lines.hpp"
#include "tb/support/segments/random_splines.hpp"

namespace curvecore::tb::optimal_plan_test {

using ref::Effort;
using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;

PlanOptions options_of(Effort effort) {
    PlanOptions options;
    options.effort = effort;
    return options;
}

struct Curve {
    const char* name;
    ChoppedCurve chopped;
    double gain;  // least gain of the time
};
const Curve kCurves[] = {
    {"turn", chopped_turn, 1.08}, {"wave", chopped_wave, 1.7}, {"circle", chopped_circle, 1.2}};

/// Limits of a plan with a hold of `ticks` ticks from tick `at` on.
sysc::LimitLoads held_limits(const Plan& plan, const Machine& machine, int at, int ticks) {
    hls::TimeScaler scaler(plan.hold_acceleration,
                           std::int64_t{plan.hold_acceleration} * plan.hold_slope_steps);
    TickRun run(plan, machine);
    for (int tick = 0; run.active(); ++tick) {
        const bool hold = tick >= at && tick < at + ticks;
        run.tick(scaler.tick(hold ? 0 : 1 << 16), hold);
    }
    return run.finish();
}

/// Lines with alternating corners.
Program corners(double turn, double chord, double feed) {
    ProgramBuilder builder;
    for (int i = 0; i < 12; ++i) {
        const double angle = i % 2 == 0 ? turn / 2 : -turn / 2;
        builder.line(builder.at() + chord * ref::Vec3(std::cos(angle), std::sin(angle), 0), feed);
    }
    return with_tolerance(builder.program(), 0.01);
}
Program dull_corners() { return corners(0.03, 12, 300); }

Machine machine_of(double velocity, double acceleration, double jerk, const ref::AxisLimits& axis) {
    Machine machine;
    machine.velocity = velocity;
    machine.acceleration = acceleration;
    machine.jerk = jerk;
    for (std::size_t i = 0; i < 3; ++i) machine.axis[i] = axis;
    return machine;
}

/// Cost of a plan: Newton steps times knots, and seconds of motion.
struct Cost {
    double work, seconds;
};

Cost cost(Program program, const Machine& machine) {
    const std::uint64_t before = ref::newton_work();
    ref::smooth_path(program, machine);
    const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
    return {static_cast<double>(ref::newton_work() - before), plan.duration_s};
}

/// A window ends at the speed of the rules. With these limits braking to it takes longer than
/// braking to full acceleration; the whole window is then solved again.
TEST(OptimalPlan, BrakesForNoWindow) {
    Machine machine = machine_of(94, 258, 4035, {65, 130, 8222});
    const double tight = cost(dull_corners(), machine).seconds;
    machine.axis[0].velocity *= 8;
    EXPECT_LT(cost(dull_corners(), machine).seconds, tight);
}

/// A window that ended near a corner braked for it to half the speed, and kept that.
TEST(OptimalPlan, BrakesForNoWindowBeforeACorner) {
    Machine machine = machine_of(287, 524, 49369, {583, 589, 4322});
    const double tight = cost(dull_corners(), machine).seconds;
    machine.acceleration *= 2;
    EXPECT_LE(cost(dull_corners(), machine).seconds, tight);
}

/// The old limit of 30 Newton steps for a stage of the barrier ended it too early.
TEST(OptimalPlan, TakesTheStepsThatItNeeds) {
    Machine machine = machine_of(66, 3849, 600276, {70, 5778, 61457});
    machine.axis[1] = {23, 2669, 341282};
    const double tight = cost(dull_corners(), machine).seconds;
    machine.acceleration *= 2;
    EXPECT_LT(cost(dull_corners(), machine).seconds, 1.01 * tight);
}

/// The jerk changes with the acceleration where the path bends evenly. Checked in the middle of
/// intervals alone it was too large at their ends, and easing did not help.
TEST(OptimalPlan, CostsNoMoreWhereThePathBends) {
    const Program program = with_tolerance(chopped_wave(0.1, 200), 0.01);
    const Cost built_in = cost(program, Machine());
    const Cost own = cost(program, machine_of(760, 4161, 80348, {465, 11322, 375784}));
    EXPECT_LT(own.work / own.seconds, 2 * built_in.work / built_in.seconds);
}

/// Words that take too much are mended near them, and many by another tick alone.
TEST(OptimalPlan, CostsNoMoreWhereLimitsOfJerkDiffer) {
    const Program program = corners(1.2, 6, 150);
    const Cost built_in = cost(program, Machine());
    Machine machine = machine_of(36, 3091, 197266, {39, 1131, 28814});
    machine.axis[1] = {57, 4343, 124241};
    machine.axis[2] = {88, 1181, 11247};
    const Cost own = cost(program, machine);
    EXPECT_LT(own.work / own.seconds, 4 * built_in.work / built_in.seconds);
}

TEST(OptimalPlan, CurvesKeepTheLimitsAndAreFaster) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        const Program program = curve.chopped(0, 1000.0 / 3);
        const Plan rules = make_plan(program, machine, options_of(Effort::kRules));
        const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
        const sysc::LimitLoads loads = drawn_limits(plan, machine);
        EXPECT_LE(loads.most(), 1) << curve.name << ": " << text(loads);
        EXPECT_GE(rules.duration_s, curve.gain * plan.duration_s) << curve.name;
        const double cut = plan.duration_s / 7e-3;  // for stop branches
        EXPECT_LE(plan.pieces.size(), 4. * rules.pieces.size() + cut) << curve.name;
    }
}

/// Corners of 90 degrees between lines of 10 mm, each a cubic that leaves and enters them `size`
/// before and after, without curvature.
Program rounded_corners(int corners, double size) {
    ProgramBuilder builder;
    const ref::Vec3 along[] = {ref::Vec3::UnitX(), ref::Vec3::UnitY()};
    ref::Vec3 corner = ref::Vec3::Zero();
    for (int i = 0; i < corners; ++i) {
        const ref::Vec3& out = along[(i + 1) % 2];
        corner += 10 * along[i % 2];
        builder.line(corner - size * along[i % 2], 500);
        builder.cubic(corner, corner, corner + size * out, 500);
    }
    builder.line(corner + 10 * along[corners % 2], 500);
    return builder.program();
}

/// Speed at a place of the path, mm/s; the place in mm.
double speed_at(const Plan& plan, double mm) {
    double left = mm / plan.unit_mm * 65536;
    for (const ref::ProfilePiece& piece : plan.pieces) {
        if (left > static_cast<double>(piece.ds)) {
            left -= static_cast<double>(piece.ds);
            continue;
        }
        return piece_state(piece, ticks_at(piece, left)).v * plan.unit_mm / 65536 / plan.tick_s;
    }
    return 0;
}

TEST(OptimalPlan, DipsWithinARoundedCorner) {
    const Machine machine;
    for (const double size : {0.1, 0.5}) {
        const Program program = rounded_corners(6, size);
        const Plan rules = make_plan(program, machine, options_of(Effort::kRules));
        const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
        const sysc::LimitLoads loads = drawn_limits(plan, machine);
        EXPECT_LE(loads.most(), 1) << size << ": " << text(loads);
        EXPECT_GE(rules.duration_s, 1.3 * plan.duration_s) << size;
        const double begin = 10 - size;
        const double length = ref::ArcLength(program.moves[1].cubic).length();
        const double middle = speed_at(plan, begin + length / 2);
        EXPECT_GE(speed_at(plan, begin), 1.2 * middle) << size;
        EXPECT_GE(speed_at(plan, begin + length), 1.2 * middle) << size;
    }
}

/// A looser limit of the path lets the rounded corners be shorter. They are passed at the speed
/// that X allows with either, and not in a dip to a twentieth of it.
TEST(OptimalPlan, DipsInNoDullCorner) {
    Machine machine = machine_of(42, 12460, 63009, {});
    const std::array<std::array<double, 3>, 3> axes{
        {{32, 6179, 33783}, {70, 11283, 301047}, {14, 18331, 105169}}};
    for (std::size_t i = 0; i < 3; ++i) {
        machine.axis[i].velocity = axes[i][0];
        machine.axis[i].acceleration = axes[i][1];
        machine.axis[i].jerk = axes[i][2];
    }
    const Cost tight = cost(dull_corners(), machine);
    machine.jerk *= 16;
    const Cost loose = cost(dull_corners(), machine);
    EXPECT_LE(loose.seconds, tight.seconds);
    EXPECT_LE(loose.seconds, 1.03 * 144 / 32);
}

/// Words of hundreds of corners are corrected one by one: none falls back to the rules as a whole.
TEST(OptimalPlan, IsFasterThroughHundredsOfCorners) {
    const Machine machine;
    ProgramBuilder builder;
    for (int i = 1; i <= 300; ++i) builder.line({i % 2 * 10.0, i * 3.0, 0}, 400);
    Program program = with_tolerance(builder.program(), 0.01);
    ref::smooth_path(program, machine);
    const Plan rules = make_plan(program, machine, options_of(Effort::kRules));
    const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
    const sysc::LimitLoads loads = drawn_limits(plan, machine);
    EXPECT_LE(loads.most(), 1) << text(loads);
    EXPECT_GE(rules.duration_s, 1.7 * plan.duration_s);
}

TEST(OptimalPlan, HoldsKeepTheLimits) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        const Plan plan =
            make_plan(curve.chopped(0, 1000.0 / 3), machine, options_of(Effort::kOptimum));
        const auto total = static_cast<int>(plan.duration_s / plan.tick_s);
        for (int at = 30; at < total; at += total / 12) {
            const sysc::LimitLoads loads = held_limits(plan, machine, at, 15000);
            // The scaler's rate has 16 bits: its steps show in the jerk.
            EXPECT_LE(loads.worst[sysc::kVelocity].ratio, 1) << curve.name << " at " << at;
            EXPECT_LE(loads.worst[sysc::kAcceleration].ratio, 1) << curve.name << " at " << at;
            EXPECT_LE(loads.worst[sysc::kJerk].ratio, 1) << curve.name << ": " << text(loads);
        }
        // Control: time that stops several times too fast.
        Plan rash = plan;
        rash.hold_acceleration *= 30;
        double worst = 0;
        for (int at = 30; at < total; at += total / 12) {
            worst = std::max(worst, held_limits(rash, machine, at, 15000).most());
        }
        EXPECT_GT(worst, 1) << curve.name;
    }
}

TEST(OptimalPlan, HoldsOfRandomProgramsKeepTheLimits) {
    int looked_at = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const JointCase random = RandomJoints(seed).make();
        PlanOptions options = random.options;
        options.samples_per_tick = 1;
        options.effort = Effort::kOptimum;
        const Plan plan = make_plan(random.program, random.machine, options);
        const auto total = static_cast<int>(plan.duration_s / plan.tick_s);
        if (total > 40000) continue;
        for (int at = 20; at < total; at += total / 4 + 1) {
            const sysc::LimitLoads loads = held_limits(plan, random.machine, at, 12000);
            EXPECT_LE(loads.most(), 1) << seed << " at " << at << ": " << text(loads);
            ++looked_at;
        }
    }
    EXPECT_GT(looked_at, 60);
}

TEST(OptimalPlan, ChordsKeepTheLimits) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        for (const double size : {2., 0.5, 0.1, 0.02}) {
            const Program program = curve.chopped(size, 1000.0 / 3);
            const Plan rules = make_plan(program, machine, options_of(Effort::kRules));
            const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
            const sysc::LimitLoads loads = drawn_limits(plan, machine);
            EXPECT_LE(loads.most(), 1) << curve.name << " " << size << ": " << text(loads);
            // Chords of 60 us are more than a queue holds for a stop: two windows join slowly
            // there.
            if (size < 0.1) continue;
            EXPECT_LE(plan.duration_s, rules.duration_s) << curve.name << " " << size;
        }
    }
}

TEST(OptimalPlan, RandomJointsKeepTheLimits) {
    double gained = 1;
    double jerk = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const JointCase random = RandomJoints(seed).make();
        PlanOptions options = random.options;
        options.effort = Effort::kRules;
        const Plan rules = make_plan(random.program, random.machine, options);
        options.effort = Effort::kOptimum;
        const Plan plan = make_plan(random.program, random.machine, options);
        const sysc::LimitLoads loads = drawn_limits(plan, random.machine, options);
        EXPECT_LE(loads.most(), 1) << seed << ": " << text(loads);
        EXPECT_LE(plan.duration_s, rules.duration_s) << seed;
        gained = std::max(gained, rules.duration_s / plan.duration_s);
        jerk = std::max(jerk, loads.worst[sysc::kJerk].ratio);
    }
    EXPECT_GT(gained, 1.2);
    EXPECT_GT(jerk, 0.6) << "the limits are idle";
}

/// Shares of the pieces on the true path, as the words have it. Some exceeded the limit before
/// pieces that ticks round too coarsely were corrected.
TEST(OptimalPlan, PiecesKeepTheirSharesExactly) {
    for (const unsigned seed : {7U, 8U}) {
        const Machine machine = unequal_machine(seed);
        PlanOptions options = options_of(Effort::kOptimum);
        options.unit_mm = seed % 2 ? 1e-6 : 1e-5;
        options.sample_period_s = seed % 3 ? 1e-4 : 2e-5;
        const Program program = random_splines(seed, 30);
        const Plan plan = make_plan(program, machine, options);
        const ref::LimitReport report = limit_report(program, machine, plan);
        EXPECT_LE(report.inside.velocity, 1) << seed;
        // Rounding to ticks adds up to 9 %, at a few uncorrectable places 20 %.
        EXPECT_LE(report.inside.acceleration, 1.2 * ref::kAccelerationShare) << seed;
        EXPECT_LE(report.inside.jerk, 1.2 * ref::kJerkShare) << seed;
        EXPECT_GE(report.inside.jerk, 0.9 * ref::kJerkShare) << seed;
        EXPECT_LE(report.joints.acceleration, 1) << seed;
        EXPECT_LE(report.joints.jerk, 1) << seed;
        for (const ref::ProfilePiece& piece : plan.pieces) {
            for (std::uint32_t tick = 0; tick <= piece.ticks; ++tick) {
                EXPECT_GE(piece_state(piece, tick).v, -1) << "quanta a tick: " << seed;
            }
        }
    }
}

TEST(OptimalPlan, PiecesSumToThePath) {
    const Plan plan =
        make_plan(chopped_wave(0, 1000.0 / 3), Machine(), options_of(Effort::kOptimum));
    std::uint64_t path = 0;
    for (const ref::ProfilePiece& piece : plan.pieces) path += piece.ds;
    const ref::Segment& last = plan.segments.back();
    EXPECT_EQ(path, last.s_start + last.length);
}

}  // namespace curvecore::tb::optimal_plan_test
