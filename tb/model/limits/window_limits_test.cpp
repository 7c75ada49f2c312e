// SPDX-License-Identifier: Apache-2.0
// Machine limits over windows of time of the drawn motion: a curve in chords is no faster than the
// limits allow, and hardly slower than the curve.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <climits>
#include <cmath>

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/planner.hpp"
#include "ref/feed/windows/velocity_course.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/limits/limits.hpp"
#include "ref/path/smooth_path.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/random_joints.hpp"
#include "tb/support/programs/random_lines.hpp"

namespace curvecore::tb::window_limits_test {

using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;

/// The rule is tested alone: without the cover of queues, a faster smooth path, or the planner's
/// horizon.
PlanOptions endless_queues() {
    PlanOptions options;
    options.effort = ref::Effort::kRules;
    options.segment_queue_words = INT_MAX;
    options.profile_queue_words = INT_MAX;
    options.window = 1000000;
    return options;
}

/// Limits of each joint alone, not added up: lines, without a stop.
Plan joint_by_joint(const Program& program, const Machine& machine) {
    Plan plan = make_plan(program, machine, endless_queues());
    std::vector<ref::Zone> zones;
    for (const ref::Move& move : program.moves) {
        const ref::PathShape shape = path_shape(move);
        if (!zones.empty()) {
            const ref::PathShape before = path_shape(*(&move - 1));
            zones.push_back({0, joint_velocity(before, shape, machine), 1e300, 1e300});
        }
        const double v = std::min(top_speed(shape, machine), move.feed);
        const ref::PathLimits limits = along_path(shape, machine, v);
        zones.push_back({shape.length, v, ref::kAccelerationShare * limits.acceleration,
                         ref::kJerkShare * limits.jerk});
    }
    const ref::Segment& last = plan.segments.back();
    plan.pieces.clear();
    append_run(ramps_over(zones), last.s_start + last.length,
               ref::PieceGrid(machine, plan.unit_mm, plan.tick_s), plan.pieces);
    plan.pieces.back().final = true;
    return plan;
}

struct Curve {
    const char* name;
    ChoppedCurve chopped;
};
const Curve kCurves[] = {
    {"turn", chopped_turn}, {"wave", chopped_wave}, {"circle", chopped_circle}};

class ChordSize : public testing::TestWithParam<double> {};

TEST_P(ChordSize, KeepsTheLimits) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        for (const double feed : {25.0, 100.0, 1000.0 / 3}) {
            const Plan smooth = make_plan(curve.chopped(0, feed), machine, endless_queues());
            const Plan plan = make_plan(curve.chopped(GetParam(), feed), machine, endless_queues());
            const sysc::LimitLoads loads = drawn_limits(plan, machine);
            EXPECT_LE(loads.most(), 1) << curve.name << " at " << feed << ": " << text(loads);
            const double time = plan.duration_s / smooth.duration_s;
            RecordProperty(fmt::format("{}_{:g}_{:.0f}", curve.name, GetParam(), feed),
                           fmt::format("{:.3f}", time));
            if (GetParam() <= 0.1) {
                EXPECT_LE(time, 1.1) << curve.name << " at " << feed;
            }
            EXPECT_GE(time, 0.7) << curve.name << " at " << feed;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, ChordSize, testing::Values(2, 1, 0.5, 0.1, 0.02, 0.005),
                         [](const auto& chord) {
                             return std::to_string(std::lround(chord.param * 1e3)) + "um";
                         });

TEST(WindowLimits, CurvesThemselvesKeepThem) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        const Plan plan = make_plan(curve.chopped(0, 1000.0 / 3), machine, PlanOptions());
        const sysc::LimitLoads loads = drawn_limits(plan, machine);
        EXPECT_LE(loads.most(), 1) << curve.name << ": " << text(loads);
    }
}

// Control: every joint within its own limit, and the chain many times beyond.
TEST(WindowLimits, JointsThatDoNotAddUpBreakThem) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        const Program program = curve.chopped(0.02, 1000.0 / 3);
        const sysc::LimitLoads loads = drawn_limits(joint_by_joint(program, machine), machine);
        EXPECT_GT(loads.worst[sysc::kAcceleration].ratio, 2) << curve.name;
        EXPECT_GT(loads.worst[sysc::kJerk].ratio, 3) << curve.name;
    }
}

/// Number of joints that the rule has to check, in a motion at 10 mm/s.
std::size_t joints(const Program& program) {
    const Machine machine;
    const ref::Geometry geometry = make_geometry(program, machine, PlanOptions());
    double length = 0;
    for (const ref::Move& move : program.moves) length += move.length();
    ref::VelocityCourse course(geometry.segments, PlanOptions().unit_mm, 3, machine);
    const std::vector<ref::Phase> steady{{length / 10, 0, 10, 0, 0}};
    course.run(steady, 0, geometry.segments.size() - 1);
    return course.all_joints().size();
}

TEST(WindowLimits, AreLookedAtWhereVelocityOrItsSlopeJumps) {
    const Program chords = with_tolerance(chopped_wave(0.1, 100), 0.005);
    Program smooth = chords;
    smooth_path(smooth, Machine());
    EXPECT_GT(smooth.moves.size(), 10U);
    EXPECT_EQ(joints(smooth), 0U);
    EXPECT_EQ(joints(chords), chords.moves.size() - 1);
    ProgramBuilder stadium;  // a tangent arc: the slope alone jumps, twice
    stadium.line({20, 0, 0}, 100);
    stadium.arc({20, 10, 0}, {0, 0, 1}, M_PI, 0, 100);
    stadium.line({0, 20, 0}, 100);
    EXPECT_EQ(joints(stadium.program()), 2U);
}

TEST(WindowLimits, RandomJointsKeepThem) {
    double acceleration = 0;
    double jerk = 0;
    for (int seed = 0; seed < cases(50, 150); ++seed) {
        const JointCase random = RandomJoints(seed).make();
        const Plan plan = make_plan(random.program, random.machine, random.options);
        const sysc::LimitLoads loads = drawn_limits(plan, random.machine, random.options);
        EXPECT_LE(loads.most(), 1) << seed << ": " << text(loads);
        acceleration = std::max(acceleration, loads.worst[sysc::kAcceleration].ratio);
        jerk = std::max(jerk, loads.worst[sysc::kJerk].ratio);
    }
    EXPECT_GT(acceleration, 0.75) << "the limits are idle";
    EXPECT_GT(jerk, 0.9) << "the limits are idle";
}

TEST(WindowLimits, OverridesKeepThem) {
    const Machine machine;
    for (const Curve& curve : kCurves) {
        const Plan plan = make_plan(curve.chopped(0.1, 1000.0 / 3), machine, PlanOptions());
        for (const double rate : {0.1, 0.37, 0.8}) {
            const auto word = static_cast<std::int32_t>(std::lround(rate * 65536));
            const sysc::LimitLoads loads = drawn_limits(plan, machine, PlanOptions(), word);
            EXPECT_LE(loads.most(), 1) << curve.name << " at " << rate << ": " << text(loads);
        }
    }
}

}  // namespace curvecore::tb::window_limits_test
