// SPDX-License-Identifier: Apache-2.0
// Speeds of cubics: bounds of their curvature, the machine's limits along the exact curve.
#include <gtest/gtest.h>

#include "ref/feed/pieces/limit_report.hpp"
#include "ref/feed/planner.hpp"
#include "ref/limits/spline_shape.hpp"
#include "tb/support/segments/cubics.hpp"
#include "tb/support/segments/random_splines.hpp"
#include "tb/support/segments/spline_loads.hpp"

namespace curvecore::tb::spline_limits_test {

using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;
using ref::Vec3;

/// The bounds of every stretch against the curve at many of its points.
TEST(SplineLimits, StretchesBoundTheirCurves) {
    RandomCubics random(6);
    double tightest = 1e9;
    for (int i = 0; i < 300; ++i) {
        ref::Move move;
        move.kind = ref::Move::Kind::kCubic;
        move.cubic = random.any(i % 5 == 2 ? i + 1 : i);  // straight ones have but roundings
        for (Vec3* v : {&move.cubic.a, &move.cubic.b, &move.cubic.c}) *v *= 10;
        move.feed = 200;
        const ref::ArcLength arc(move.cubic);
        double from = 0;
        for (const auto& [u0, u1, shape] : ref::spline_stretches(move, arc, Machine(), 0, 1)) {
            EXPECT_EQ(u0, from);
            from = u1;
            if (shape.length <= 1e-5) continue;  // tips have their own model
            for (int k = 0; k <= 20; ++k) {
                const double u = u0 + (u1 - u0) * k / 20;
                const Vec3 t = ref::tangent(move.cubic, u);
                const Vec3 bend = ref::curvature_vector(move.cubic, u);
                const Vec3 rate = ref::curvature_rate(move.cubic, u);
                const Vec3 across = rate - t * t.dot(rate);
                const double room = 1e-9 + 1e-6 * rate.norm();
                EXPECT_LE(bend.norm(), shape.curvature * (1 + 1e-6) + 2e-9);
                EXPECT_LE(across.norm(), shape.swerve * (1 + 1e-6) + room);
                EXPECT_LE(-t.dot(rate), shape.curvature * shape.twist * (1 + 1e-6) + room);
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_LE(std::abs(t[axis]),
                              shape.swing[static_cast<std::size_t>(axis)] * (1 + 1e-9));
                }
                if (bend.norm() > 1e-3)
                    tightest = std::min(tightest, shape.curvature / bend.norm());
            }
        }
        EXPECT_EQ(from, 1);
    }
    EXPECT_LT(tightest, 1.01) << "the bounds are idle";
}

TEST(SplineLimits, LimitsHoldAlongTheExactCurve) {
    double jerk = 0;
    double acceleration = 0;
    for (unsigned seed = 20; seed < 25; ++seed) {
        const Machine machine = unequal_machine(seed);
        PlanOptions options;
        options.effort = ref::Effort::kRules;
        options.unit_mm = seed % 2 ? 1e-6 : 1e-5;
        options.sample_period_s = seed % 3 ? 1e-4 : 2e-5;
        const Program program = random_splines(seed, 30);
        const Plan plan = make_plan(program, machine, options);
        const SplineLoads loads = SplineLoadMeter(program, machine, plan).measure();
        EXPECT_LE(loads.worst.velocity, 1) << seed;
        EXPECT_LE(loads.worst.acceleration, 1) << seed;
        EXPECT_LE(loads.worst.jerk, 1) << seed << " at " << loads.at_jerk;
        EXPECT_GT(loads.ticks, 1000U);
        jerk = std::max(jerk, loads.worst.jerk);
        acceleration = std::max(acceleration, loads.worst.acceleration);
        const ref::LimitReport report = limit_report(program, machine, plan);
        EXPECT_LE(report.inside.velocity, 1) << seed;
        EXPECT_LE(report.inside.acceleration, 1) << seed;
        EXPECT_LE(report.inside.jerk, 1) << seed;
        EXPECT_LE(report.joints.acceleration, 1) << seed;
        EXPECT_LE(report.joints.jerk, 1) << seed;
        EXPECT_GT(report.passed, 20) << seed;
    }
    EXPECT_GT(jerk, 0.6) << "the limits are idle";
    EXPECT_GT(acceleration, 0.3) << "the limits are idle";
}

// Against a motion that has at every point the speed allowed there, without ramps.
TEST(SplineLimits, HairpinsLoseLittleTime) {
    for (const double radius : {0.003, 0.1, 1.0}) {
        ProgramBuilder builder;
        const ref::Cubic hairpin = RandomCubics::hairpin(radius);
        const ref::Bezier points = to_bezier(hairpin);
        const Vec3& shift = points[0];
        builder.cubic(points[1] - shift, points[2] - shift, points[3] - shift, 100);
        const Machine machine;
        const Plan plan = make_plan(builder.program(), machine, PlanOptions());
        double least = 0;
        const ref::ArcLength arc(hairpin);
        constexpr int kParts = 20000;
        for (int i = 0; i < kParts; ++i) {
            const double u = (i + 0.5) / kParts;
            const double k = ref::curvature(hairpin, u);
            const double rate = ref::curvature_rate(hairpin, u).norm();
            const double v = std::min(
                {100.0, std::sqrt(machine.acceleration / k), std::cbrt(machine.jerk / rate)});
            least += hairpin.speed(u) / kParts / v;
        }
        EXPECT_GT(plan.duration_s, least);
        EXPECT_LT(plan.duration_s, 2.2 * least) << radius;
        RecordProperty(std::to_string(radius), std::to_string(plan.duration_s / least));
    }
}

// Control: the meter sees a plan that was made for a stronger machine.
TEST(SplineLimits, LoadsSeeAWeakerMachine) {
    const Program program = random_splines(21, 40);
    Machine machine;
    const Plan plan = make_plan(program, machine, PlanOptions());
    machine.jerk /= 3;
    machine.acceleration /= 5;
    const SplineLoads loads = SplineLoadMeter(program, machine, plan).measure();
    EXPECT_GT(loads.worst.jerk, 1);
    EXPECT_GT(loads.worst.acceleration, 1);
}

}  // namespace curvecore::tb::spline_limits_test
