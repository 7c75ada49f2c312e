// SPDX-License-Identifier: Apache-2.0
// Stop branches: within the limits from anywhere, to rest exactly, in nearly the least time, with
// plans that use nearly all of the limits.
#include <gtest/gtest.h>

#include "ref/feed/planner.hpp"
#include "ref/limits/limits.hpp"
#include "tb/support/judge/shortest_stop.hpp"
#include "tb/support/judge/stop_run.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/even_paths.hpp"
#include "tb/support/programs/random_joints.hpp"
#include "tb/support/segments/random_splines.hpp"

namespace curvecore::tb::stop_branch_test {

using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;
using ref::StopSteps;

struct Stops {
    Program program;
    Machine machine;
    PlanOptions options;
    ref::Geometry geometry;
    Plan plan;
    ref::ProfileCourse course;

    explicit Stops(const Program& of, const Machine& on = Machine(), PlanOptions with = {},
                   double share = ref::kStopShare)
        : program(of),
          machine(on),
          options(optimum(with)),
          geometry(make_geometry(program, machine, options)),
          plan(make_plan(program, machine, options)),
          course(program, machine, geometry, plan, share) {
        const ref::PieceGrid grid(machine, plan.unit_mm, plan.tick_s);
        walk_pieces(plan, geometry, grid,
                    [this](const ref::PieceStretch& stretch) { course.add(stretch); });
    }
    Stops(const Stops&) = delete;

    static PlanOptions optimum(PlanOptions options) {
        options.effort = ref::Effort::kOptimum;
        return options;
    }
    std::uint64_t ticks() const {
        return static_cast<std::uint64_t>(std::llround(plan.duration_s / plan.tick_s));
    }
    /// Speed and acceleration of the plan.
    ref::PieceMotion motion(std::uint64_t tick) const {
        for (const ref::CourseCell& cell : course.cells()) {
            const auto t = static_cast<double>(tick);
            if (t >= cell.from && t < cell.to) return course.motion(cell, t);
        }
        return {0, 0, 0};
    }
};

TEST(StopBranch, OnLinesCirclesAndHelicesNearTheShortest) {
    for (const EvenPath& even : even_paths()) {
        const Stops stops(even.program);
        const ShortestStop shortest(stops.machine, even.bend, even.third);
        const double tick_s = stops.plan.tick_s;
        for (std::uint64_t tick = 20; tick < stops.ticks(); tick += 50) {
            const StopSteps steps = stop_steps(stops.course, tick);
            ASSERT_FALSE(steps.empty()) << even.name << " " << tick;
            const ref::PieceMotion m = stops.motion(tick);
            const double time = static_cast<double>(ticks_of(steps)) * tick_s;
            const double behind = time - shortest.time(m.v, m.a);
            EXPECT_LE(behind, 0.055) << even.name << " " << tick;
            EXPECT_GE(behind, -1e-3) << even.name << " " << tick;
            EXPECT_LE(time, 0.215) << even.name << " " << tick;
        }
    }
}

TEST(StopBranch, EndsAtRestExactly) {
    const Stops stops(fast_arc(10, 6 * M_PI, 12));
    for (std::uint64_t tick = 0; tick < stops.ticks(); tick += 97) {
        const StopSteps steps = stop_steps(stops.course, tick);
        ASSERT_FALSE(steps.empty()) << tick;
        EXPECT_LE(steps.front().change, 0) << tick;
        std::int64_t last = std::int64_t{1} << 32;
        const bool ends = each_rate(steps, [&](std::int64_t rate) {
            EXPECT_LE(rate, last) << tick;
            EXPECT_GE(rate, 0) << tick;
            last = rate;
        });
        EXPECT_TRUE(ends) << tick;
    }
}

struct Curve {
    const char* name;
    Program program;
};
std::vector<Curve> smooth_curves() {
    std::vector<Curve> all;
    for (const EvenPath& even : even_paths()) all.push_back({even.name, even.program});
    all.push_back({"wave", chopped_wave(0, 500)});
    return all;
}
std::vector<Curve> curves() {
    std::vector<Curve> all = smooth_curves();
    all.push_back({"turn", chopped_turn(0, 500)});
    return all;
}

/// Checks, every `every` ticks of a plan, the limits as measured from drawn positions.
void expect_within(const Stops& stops, std::uint64_t every, const std::string& name) {
    for (std::uint64_t tick = 0; tick < stops.ticks(); tick += every) {
        const StopSteps steps = stop_steps(stops.course, tick);
        ASSERT_FALSE(steps.empty()) << name << " " << tick;
        const sysc::LimitLoads loads = stopped_limits(stops.plan, stops.machine, tick, steps);
        EXPECT_LE(loads.most(), 1) << name << " " << tick << ": " << text(loads);
    }
}

TEST(StopBranch, KeepsTheLimitsOverWindows) {
    for (const Curve& curve : curves()) {
        const Stops stops(curve.program);
        expect_within(stops, stops.ticks() / 10 + 1, curve.name);
    }
}

/// Largest jump of the acceleration between pieces, mm/s^2.
double acceleration_jump(const Plan& plan) {
    double most = 0;
    double a = 0;
    for (const ref::ProfilePiece& piece : plan.pieces) {
        most = std::max(most, std::abs(piece_state(piece, 0).a - a));
        a = piece_state(piece, piece.ticks).a;
    }
    return most * plan.unit_mm / 65536 / (plan.tick_s * plan.tick_s);
}

// Differences are independent of plan and law, and allow no margin. The plan's own acceleration
// jumps slightly between pieces.
TEST(StopBranch, KeepsTheLimitsByDifferences) {
    for (const Curve& curve : smooth_curves()) {
        const Stops stops(curve.program);
        const Stops rash(curve.program, Machine(), {}, 1.2);
        Differences most;
        Differences control;
        for (std::uint64_t tick = 20; tick < stops.ticks(); tick += stops.ticks() / 40 + 1) {
            const auto worst = [tick](const Stops& of, Differences& all) {
                const Differences one =
                    stopped_differences(of.plan, of.machine, tick, stop_steps(of.course, tick), 8);
                all.acceleration = std::max(all.acceleration, one.acceleration);
                all.jerk = std::max(all.jerk, one.jerk);
            };
            worst(stops, most);
            worst(rash, control);
        }
        EXPECT_LE(most.acceleration, 1) << curve.name;
        const double jump = acceleration_jump(stops.plan) / (8 * stops.plan.tick_s);
        EXPECT_LE(most.jerk, 1.01 + jump / stops.machine.jerk) << curve.name;
        EXPECT_GT(most.jerk, 0.95) << curve.name;
        EXPECT_GT(control.jerk, most.jerk + 0.05) << curve.name;
    }
}

// A tick of the rate may begin within a tick of the profile: after a hold it usually does.
TEST(StopBranch, MayBeginAPartOfATickLate) {
    const Stops stops(fast_arc(10, 6 * M_PI, 12));
    for (std::uint64_t tick = 100; tick < stops.ticks(); tick += stops.ticks() / 9) {
        const StopSteps steps = stop_steps(stops.course, tick);
        for (const std::int32_t late : {1, 1 << 14, 1 << 15, (1 << 16) - 1}) {
            const sysc::LimitLoads loads =
                stopped_limits(stops.plan, stops.machine, tick, steps, late);
            EXPECT_LE(loads.most(), 1) << tick << " " << late << ": " << text(loads);
        }
    }
}

TEST(StopBranch, OfRandomProgramsKeepsTheLimits) {
    int looked_at = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        JointCase random = RandomJoints(seed).make();
        random.options.samples_per_tick = 1;
        const Stops stops(random.program, random.machine, random.options);
        if (stops.ticks() > 40000) continue;
        expect_within(stops, stops.ticks() / 6 + 1, "seed " + std::to_string(seed));
        looked_at += 6;
    }
    EXPECT_GT(looked_at, 120);
}

TEST(StopBranch, OfRandomSplinesWithLimitsOfAxesKeepsTheLimits) {
    for (const unsigned seed : {1U, 4U, 5U, 6U}) {
        const Machine machine = unequal_machine(seed);
        const Stops stops(random_splines(seed, 8), machine);
        expect_within(stops, stops.ticks() / 15 + 1, "seed " + std::to_string(seed));
    }
}

TEST(StopBranch, WithoutLimitsBreaksThem) {
    const Stops rash(fast_arc(10, 6 * M_PI, 12), Machine(), {}, 3);
    double worst = 0;
    for (std::uint64_t tick = 100; tick < rash.ticks(); tick += rash.ticks() / 9) {
        const StopSteps steps = stop_steps(rash.course, tick);
        worst = std::max(worst, stopped_limits(rash.plan, rash.machine, tick, steps).most());
    }
    EXPECT_GT(worst, 1);
}

}  // namespace curvecore::tb::stop_branch_test
