// SPDX-License-Identifier: Apache-2.0
// Cubic moves through the planner: segments, lengths, joints, stops, refusals.
#include <gtest/gtest.h>

#include "hls/quantise.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/feed/planner.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/limits/travel.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/segments/cubics.hpp"
#include "tb/support/segments/random_splines.hpp"

namespace curvecore::tb::spline_planner_test {

using ref::Machine;
using ref::Plan;
using ref::PlanOptions;
using ref::Program;
using ref::Segment;
using ref::Vec3;

double units(const Segment& segment) {
    return std::ldexp(static_cast<double>(segment.length), -16);
}

/// Planned speed at the end of the last segment that ends at this point, mm/s; -1 if none does.
double feed_at(const Plan& plan, const Vec3& point) {
    double feed = -1;
    for (const Segment& segment : plan.segments) {
        if ((segment.end * plan.unit_mm - point).norm() < 1e-7) feed = segment.feed_end;
    }
    return feed;
}

std::string refusal(const Program& program, const PlanOptions& options = {}) {
    try {
        make_plan(program, Machine(), options);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SplinePlanner, SegmentsJoinAndFollowTheirMoves) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Program program = random_splines(seed, 60);
        const PlanOptions options;
        const Plan plan = make_plan(program, Machine(), options);
        std::uint64_t s = 0;
        int splines = 0;
        for (std::size_t i = 0; i < plan.segments.size(); ++i) {
            const Segment& segment = plan.segments[i];
            const ref::Move& move = program.moves[segment.move];
            EXPECT_EQ(segment.s_start, s);
            s += segment.length;
            const bool first = i == 0 || plan.segments[i - 1].move != segment.move;
            const bool last =
                i + 1 == plan.segments.size() || plan.segments[i + 1].move != segment.move;
            const Vec3 begins =
                first ? Vec3(move.start / options.unit_mm) : plan.segments[i - 1].end;
            EXPECT_LT((segment.start - begins).norm(), 1e-5);
            if (last) {
                EXPECT_EQ(segment.end, Vec3(move.end / options.unit_mm));
            }
            EXPECT_LT((ref::exact_position(segment, units(segment)) - segment.end).norm(), 1e-4);
            EXPECT_LE(segment.bound, options.error_limit);
            EXPECT_NO_THROW(hls::to_words<hls::DefaultSplineConfiguration>(segment));
            splines += segment.kind() == ref::CurveKind::kSpline;
        }
        EXPECT_GT(splines, 20);
    }
}

// The path of n moves is the rounded sum of their lengths, however they are cut.
TEST(SplinePlanner, PathLengthsDoNotDrift) {
    const Program program = random_splines(7, 150);
    const PlanOptions options;
    const Plan plan = make_plan(program, Machine(), options);
    long double sum = 0;
    for (const ref::Move& move : program.moves) sum += move.length();
    const Segment& last = plan.segments.back();
    EXPECT_NEAR(static_cast<double>(last.s_start + last.length),
                static_cast<double>(sum / options.unit_mm * 65536), 3);
}

TEST(SplinePlanner, AuxiliaryAxesAreLinearInPathLength) {
    ProgramBuilder builder;
    ref::Move& move = builder.cubic({3, 0, 0}, {9, 1, 0}, {10, 8, 2}, 50);
    move.aux_end[1] = 12;
    builder.program().aux_axes = 2;
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    const double rate = 12 / move.length();
    for (const Segment& segment : plan.segments) {
        EXPECT_NEAR(segment.aux_advance[1], rate, 1e-12);
        EXPECT_NEAR(segment.aux_start[1] * 1e-6,
                    rate * std::ldexp(static_cast<double>(segment.s_start), -16) * 1e-6, 1e-9);
        EXPECT_NEAR(ref::exact_aux(segment, 1, units(segment)), segment.aux_end[1], 1e-4);
    }
    EXPECT_EQ(plan.segments.back().aux_end[1], 12e6);
    move.aux_end[1] = 2 * move.length();
    EXPECT_EQ(refusal(builder.program()),
              "test.ngc:1: error: B goes 2 times as far as this spline is long; 1.9 times is the "
              "most");
}

TEST(SplinePlanner, TravelIncludesTheTurningPoints) {
    RandomCubics random(5);
    for (int i = 0; i < 500; ++i) {
        ref::Move move;
        move.kind = ref::Move::Kind::kCubic;
        move.cubic = random.any(i);
        move.start = move.cubic.d;
        move.end = move.cubic.position(1);
        const ref::AxisRange range = ref::travel(move);
        Vec3 low = move.start;
        Vec3 high = move.start;
        for (int k = 0; k <= 2000; ++k) {
            low = low.cwiseMin(move.cubic.position(k / 2000.0));
            high = high.cwiseMax(move.cubic.position(k / 2000.0));
        }
        const double size = (high - low).norm();
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            EXPECT_NEAR(range.low[a], low[axis], 1e-4 * size);
            EXPECT_NEAR(range.high[a], high[axis], 1e-4 * size);
        }
    }
    ProgramBuilder builder;
    builder.line({0, 995, 0}, 10);
    builder.cubic({0, 1005, 0}, {10, 1005, 0}, {10, 995, 0}, 10);
    EXPECT_EQ(refusal(builder.program()),
              "test.ngc:2: error: Y = 1002.5 mm is beyond the machine's travel -1000 .. 1000 mm");
}

TEST(SplinePlanner, SaysWhichWidthsWouldDo) {
    ProgramBuilder builder;
    builder.cubic({3, 0, 0}, {9, 1, 0}, {10, 8, 2}, 50);
    PlanOptions coarse;
    coarse.format.guard_bits = 2;
    const std::string reason = refusal(builder.program(), coarse);
    EXPECT_NE(reason.find("this spline needs GuardBits"), std::string::npos) << reason;
    EXPECT_NE(reason.find("to stay within 0.1 units"), std::string::npos) << reason;
}

TEST(SplinePlanner, TangentJointsArePassedAtSpeed) {
    // A line, a half turn of 20 mm, and a line: curvature is small at the joints.
    ProgramBuilder builder;
    builder.line({60, 0, 0}, 40);
    builder.cubic({90, 0, 0}, {90, 40, 0}, {60, 40, 0}, 40);
    builder.line({0, 40, 0}, 40);
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_NEAR(feed_at(plan, {60, 0, 0}), 40, 0.1);
    EXPECT_NEAR(feed_at(plan, {60, 40, 0}), 40, 0.1);
    for (const Segment& segment : plan.segments) {
        if (segment.move == 1) {
            EXPECT_GT(segment.feed_end, 39.9);
        }
    }
    // Control: a corner stops the motion.
    builder.line({0, 0, 0}, 40);
    const Plan cornered = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_LT(feed_at(cornered, {0, 40, 0}), 1e-6);
}

TEST(SplinePlanner, StopsWhereTheCurveStandsStill) {
    const Vec3 zero = Vec3::Zero();
    ProgramBuilder builder;
    builder.line({-10, 0, 0}, 50);
    builder.line(zero, 50);
    builder.cubic(zero, {10, 10, 0}, {20, 10, 0}, 50);         // doubled start
    builder.cubic({30, 10, 0}, {40, 20, 0}, {40, 20, 0}, 50);  // doubled end
    builder.line({50, 30, 0}, 50);
    builder.cubic({70, 50, 0}, {50, 50, 0}, {70, 30, 0}, 50);  // a cusp at (60, 45)
    builder.cubic({90, 10, 0}, {60, 40, 0}, {80, 20, 0}, 50);  // there and back, straight
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_LT(feed_at(plan, zero), 1e-6);
    EXPECT_NEAR(feed_at(plan, {20, 10, 0}), 50, 30);
    EXPECT_LT(feed_at(plan, {40, 20, 0}), 1e-6);
    EXPECT_GT(feed_at(plan, {20, 10, 0}), 1);
    EXPECT_GE(feed_at(plan, {60, 45, 0}), 0) << "a segment ends at the cusp";
    EXPECT_LT(feed_at(plan, {60, 45, 0}), 1e-6);
    int stops = 0;
    for (const Segment& segment : plan.segments)
        stops += segment.move == 6 && segment.feed_end < 1e-6;
    EXPECT_EQ(stops, 3) << "both turning points, and the end";
    // Control: a tip of 10 um is passed.
    ProgramBuilder blunt;
    blunt.cubic({20, 20, 0}, {0.2, 20, 0}, {20, 0, 0}, 50);
    const Plan passed = make_plan(blunt.program(), Machine(), PlanOptions());
    for (std::size_t i = 0; i + 1 < passed.segments.size(); ++i) {
        EXPECT_GT(passed.segments[i].feed_end, 1e-3);
    }
}

TEST(SplinePlanner, LatencyOfTheSplineNetworkBoundsTheSpeed) {
    ProgramBuilder builder;
    builder.cubic({30, 0, 0}, {60, 10, 0}, {90, 30, 0}, 0);
    PlanOptions options;
    options.sample_period_s = 1e-6;  // shorter than the latency: one step at a time
    options.samples_per_tick = 128;
    options.core.curve[ref::CurveKind::kSpline] = {1, 1};  // s
    const ref::Geometry geometry = make_geometry(builder.program(), Machine(), options);
    const Plan plan = make_plan(builder.program(), Machine(), options);
    double steps = 0;
    for (const Segment& segment : plan.segments) {
        steps += std::ceil(std::ldexp(units(segment), -segment.step_exponent));
    }
    EXPECT_GE(plan.duration_s, steps - 1);  // the first step is made before the start
    EXPECT_LE(plan.duration_s, 1.2 * steps);
    double counted = 0;
    for (const ref::PlannedMove& move : geometry.moves) counted += move.steps;
    EXPECT_NEAR(counted, steps, 1e-6 * steps);
    // Control: the latency of the other network does not slow it.
    std::swap(options.core.curve[ref::CurveKind::kSpline],
              options.core.curve[ref::CurveKind::kArc]);
    EXPECT_LT(make_plan(builder.program(), Machine(), options).duration_s, 5);
}

/// Sharpest place of a hairpin: its vertex, wherever the planner cuts it.
TEST(SegmentShape, FindsTheSharpestPlaceAndTheEnds) {
    for (const double radius : {3.0, 0.3, 0.03}) {
        ProgramBuilder builder;
        const double c = std::sqrt(160 * radius);
        builder.cubic({c / 3, -80. / 3, 0}, {2 * c / 3, -80. / 3, 0}, {c, 0, 0}, 20);
        const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
        double least = 1e9;
        std::unique_ptr<ref::PathCurve> before;
        double end = 0;  // of it
        for (const Segment& segment : plan.segments) {
            auto curve = ref::exact_curve(segment);
            const double most = curve->sharpest().curvature;
            EXPECT_NEAR(curve->direction(0).norm(), 1, 1e-9);
            EXPECT_GE(most, curve->curvature(0) * (1 - 1e-9));
            EXPECT_GE(most, curve->curvature(units(segment)) * (1 - 1e-9));
            least = std::min(least, 1e-6 / most);
            if (before) {
                EXPECT_LT((before->direction(end) - curve->direction(0)).norm(), 1e-5);
                EXPECT_NEAR(before->curvature(end) / curve->curvature(0), 1, 1e-3);
            }
            before = std::move(curve);
            end = units(segment);
        }
        EXPECT_NEAR(least, radius, 1e-5 * radius);
    }
}

}  // namespace curvecore::tb::spline_planner_test
