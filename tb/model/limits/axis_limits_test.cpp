// SPDX-License-Identifier: Apache-2.0
// Machines whose axes differ from each other and from the path: each axis keeps its own limits, and
// costs time only where it reaches them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ref/feed/places/path_places.hpp"
#include "ref/feed/planner.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/segments/random_splines.hpp"
#include "tb/support/segments/spline_loads.hpp"

namespace curvecore::tb::axis_limits_test {

using ref::Effort;
using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;

constexpr double kFeed = 500;  // mm/s

PlanOptions options_of(Effort effort) {
    PlanOptions options;
    options.effort = effort;
    return options;
}

Machine with_velocity(int axis, double velocity) {
    Machine machine;
    machine.axis[static_cast<std::size_t>(axis)].velocity = velocity;
    return machine;
}

/// The wave z = 2 sin(x / 10) over 80 mm.
Program gentle_wave(double feed) {
    ProgramBuilder builder;
    const auto point = [](double x) { return ref::Vec3(x, 0, 2 * std::sin(x / 10)); };
    const auto slope = [](double x) { return ref::Vec3(1, 0, 0.2 * std::cos(x / 10)); };
    for (double x = 0; x < 79; x += 4) {
        builder.cubic(point(x) + slope(x) * 4 / 3, point(x + 4) - slope(x + 4) * 4 / 3,
                      point(x + 4), feed);
    }
    return builder.program();
}

Program helix(double feed) {
    ProgramBuilder builder;
    builder.arc({-10, 0, 0}, {0, 0, 1}, 6 * M_PI, 12, feed);
    return builder.program();
}

struct Curve {
    const char* name;
    Program program;
    int axis;          // the slow axis
    double rules = 0;  // greatest factor on least_time()
    double optimum = 0;
};
std::vector<Curve> curves() {
    return {{"wave", chopped_wave(0, kFeed), 1, 2.1, 1.32},
            {"circle", chopped_circle(0, kFeed), 1, 1.4, 1.13},
            {"turn", chopped_turn(0, kFeed), 0, 1.2, 1.1},
            {"helix", helix(kFeed), 0, 1.4, 1.1}};
}

/// Seconds of a motion without ramps at the speed that velocities and the acceleration across the
/// path allow at every place: no motion is faster.
double least_time(const Program& program, const Machine& machine) {
    const ref::Geometry geometry = make_geometry(program, machine, PlanOptions());
    ref::PathPlaces places(program, geometry, PlanOptions().unit_mm);
    constexpr int kParts = 2000;
    double time = 0;
    for (std::size_t i = 0; i < geometry.moves.size(); ++i) {
        const double length = static_cast<double>(geometry.moves[i].length) / 65536 * 1e-6;
        for (int k = 0; k < kParts; ++k) {
            const ref::PathPlace at = places.at(i, length * (k + 0.5) / kParts);
            double v = kFeed;
            double bend = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double rate = std::abs(at.d1[axis]);
                bend = std::hypot(bend, at.d2[axis]);
                if (rate > 0) v = std::min(v, machine.axis[axis].velocity / rate);
            }
            if (bend > 0) v = std::min(v, std::sqrt(machine.acceleration / bend));
            time += length / kParts / v;
        }
    }
    return time;
}

TEST(AxisVelocity, CostsNothingWhereItIsNotReached) {
    const Program program = gentle_wave(100);  // 20 mm/s of Z
    for (const Effort effort : {Effort::kRules, Effort::kOptimum}) {
        const double free = make_plan(program, Machine(), options_of(effort)).duration_s;
        const double slow = make_plan(program, with_velocity(2, 50), options_of(effort)).duration_s;
        EXPECT_LE(slow, 1.0001 * free);
    }
}

TEST(AxisVelocity, BoundsTheSpeedByPlaces) {
    for (const Curve& curve : curves()) {
        const Machine machine = with_velocity(curve.axis, 50);
        const double least = least_time(curve.program, machine);
        for (const Effort effort : {Effort::kRules, Effort::kOptimum}) {
            const Plan plan = make_plan(curve.program, machine, options_of(effort));
            const sysc::LimitLoads loads = drawn_limits(plan, machine);
            EXPECT_LE(loads.most(), 1) << curve.name << ": " << text(loads);
            EXPECT_GE(loads.worst[sysc::kVelocity].ratio, 0.95) << curve.name;
            const double most = effort == Effort::kRules ? curve.rules : curve.optimum;
            EXPECT_LE(plan.duration_s, most * least) << curve.name;
        }
    }
}

/// Every tick is checked by the exact curve.
TEST(AxisVelocity, IsKeptOnRandomSplines) {
    double velocity = 0;
    for (unsigned seed = 1; seed < 4; ++seed) {
        Machine machine = unequal_machine(seed);
        machine.axis[seed % 3].velocity = 20;
        const Program program = random_splines(seed, 15);
        const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
        const SplineLoads loads = SplineLoadMeter(program, machine, plan).measure();
        EXPECT_LE(loads.worst.velocity, 1) << seed;
        velocity = std::max(velocity, loads.worst.velocity);
    }
    EXPECT_GT(velocity, 0.99) << "the limits are idle";
}

TEST(AxisLimits, HoldWhereThePathsAreManyTimesLarger) {
    for (const double larger : {30., 100., 1000.}) {
        Machine machine;
        machine.velocity *= 2;
        machine.acceleration *= 2;
        machine.jerk *= larger;
        for (const Program& program : {chopped_wave(0, kFeed), chopped_circle(0, kFeed),
                                       chopped_turn(0, kFeed), gentle_wave(kFeed), helix(kFeed)}) {
            const Plan plan = make_plan(program, machine, options_of(Effort::kOptimum));
            const sysc::LimitLoads loads = drawn_limits(plan, machine);
            EXPECT_LE(loads.most(), 1) << program.moves.size() << " moves: " << text(loads);
        }
    }
}

}  // namespace curvecore::tb::axis_limits_test
