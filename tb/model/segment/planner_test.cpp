// SPDX-License-Identifier: Apache-2.0
// Segments of a plan: they join, stay within their bounds and words, and invalid moves are refused.
#include "ref/feed/planner.hpp"

#include <gtest/gtest.h>

#include "hls/quantise.hpp"
#include "ref/bound/error_bound.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/limits/travel.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::planner_test {

using ref::Machine;
using ref::Move;
using ref::Plan;
using ref::PlanOptions;
using ref::Segment;
using ref::Vec3;

Machine wide() {
    Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.min = -1e6;
        axis.max = 1e6;
    }
    return machine;
}

double units(const Segment& segment) {
    return std::ldexp(static_cast<double>(segment.length), -16);
}

std::string refusal(const ref::Program& program, const Machine& machine,
                    const PlanOptions& options) {
    try {
        make_plan(program, machine, options);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Planner, SegmentsJoinAndFollowTheirMoves) {
    for (int seed = 1; seed <= cases(2, 6); ++seed) {
        const ref::Program program = random_program(seed, 300);
        const PlanOptions options;
        const Plan plan = make_plan(program, Machine(), options);
        std::uint64_t s = 0;
        for (std::size_t i = 0; i < plan.segments.size(); ++i) {
            const Segment& segment = plan.segments[i];
            const Move& move = program.moves[segment.move];
            EXPECT_EQ(segment.s_start, s);
            s += segment.length;
            const bool first = i == 0 || plan.segments[i - 1].move != segment.move;
            const bool last =
                i + 1 == plan.segments.size() || plan.segments[i + 1].move != segment.move;
            const Vec3 begins =
                first ? Vec3(move.start / options.unit_mm) : plan.segments[i - 1].end;
            EXPECT_LT((segment.start - begins).norm(), 1e-6);
            if (last) {
                EXPECT_EQ(segment.end, Vec3(move.end / options.unit_mm));
            }
            EXPECT_LT((ref::exact_position(segment, units(segment)) - segment.end).norm(), 1e-4);
            const double twist = segment.arc().twist();
            EXPECT_LE(units(segment) * twist, M_PI_2 * (1 + 1e-4));
            EXPECT_LE(std::ldexp(twist, segment.step_exponent), 0.5);
            EXPECT_LE(segment.bound, options.error_limit);
            EXPECT_NO_THROW(hls::to_words<hls::DefaultConfiguration>(segment));
        }
    }
}

// The sum of a hundred thousand rounded lengths is the rounded sum.
TEST(Planner, PathLengthsDoNotDrift) {
    ProgramBuilder builder;
    const double step = 0.1 / 3;
    for (int i = 1; i <= 30000; ++i) builder.line({step * i / 100, 0, 0}, 10);
    const Plan plan = make_plan(builder.program(), wide(), PlanOptions());
    std::uint64_t sum = 0;
    for (const Segment& segment : plan.segments) sum += segment.length;
    EXPECT_NEAR(static_cast<double>(sum), step * 300 * 1e6 * 65536, 2);
}

TEST(Planner, TurnsAreCutIntoQuartersOrLess) {
    ProgramBuilder builder;
    builder.arc({1, 0, 0}, {0, 0, 1}, 4 * M_PI, 0, 10);
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_EQ(plan.segments.size(), 8u);
}

TEST(Planner, LongMovesAreCutUntilTheBoundHolds) {
    PlanOptions narrow;
    narrow.format.coef_bits = 30;
    ProgramBuilder builder;
    builder.line({300, 40, 5}, 10);
    builder.arc({300, 140, 5}, {0, 0, 1}, 1.5, 0, 10);
    const Plan coarse = make_plan(builder.program(), Machine(), narrow);
    const Plan fine = make_plan(builder.program(), Machine(), PlanOptions());
    EXPECT_GT(coarse.segments.size(), 4 * fine.segments.size());
    for (const Segment& segment : coarse.segments) {
        EXPECT_LE(ref::segment_bound(narrow.format, segment), narrow.error_limit);
    }
    EXPECT_NE(coarse.segments[0].bound, fine.segments[0].bound);
}

TEST(Planner, FastAuxiliaryAxisStretchesThePath) {
    ProgramBuilder builder;
    Move& move = builder.line({10, 0, 0}, 60);
    move.aux_end[0] = 190;
    builder.program().aux_axes = 1;
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    const Segment& segment = plan.segments[0];
    EXPECT_NEAR(segment.aux_advance[0], ref::kMostAxisRate, 1e-12);
    EXPECT_NEAR(segment.arc().advance[0], 0.1, 1e-12);
    std::uint64_t sum = 0;
    for (const Segment& part : plan.segments) sum += part.length;
    EXPECT_NEAR(static_cast<double>(sum), 100e6 * 65536, 1);
    EXPECT_NEAR(plan.segments.back().aux_end[0], 190e6, 1e-6);
    // A cannot be faster than 500 a second.
    EXPECT_GT(plan.duration_s, 190 / 500.0);
}

TEST(Planner, RotaryAxisLeavesWholeTurnsOut) {
    ProgramBuilder builder;
    builder.line({10, 0, 0}, 60).aux_end[0] = 36000 + 17;
    builder.line({20, 0, 0}, 60).aux_end[0] = -720.5;
    builder.program().aux_axes = 1;
    const double turn = 360e6;
    for (const int bits : {32, 31}) {
        PlanOptions options;
        options.format.position_bits = bits;
        const Plan plan = make_plan(builder.program(), Machine(), options);
        double last = 0;
        for (const Segment& segment : plan.segments) {
            EXPECT_LT(std::abs(segment.aux_start[0]), turn);
            EXPECT_LT(std::abs(segment.aux_end[0]), std::ldexp(1, bits - 1));
            EXPECT_EQ(std::remainder(segment.aux_turned[0], turn), 0);
            EXPECT_NEAR(segment.aux_start[0] + segment.aux_turned[0], last, 1e-3);
            last = segment.aux_end[0] + segment.aux_turned[0];
        }
        EXPECT_NEAR(last, -720.5e6, 1e-3);
    }
    // B is no rotary axis: its words hold all of its travel.
    Machine machine;
    machine.axis[3].rotary = false;
    EXPECT_THROW(make_plan(builder.program(), machine, PlanOptions()), ref::InputError);
    // A turn alone is too long for the words.
    PlanOptions narrow;
    narrow.format.position_bits = 29;
    EXPECT_THROW(make_plan(builder.program(), Machine(), narrow), ref::InputError);
}

TEST(Planner, StretchedHelixStaysOnItsCurve) {
    ProgramBuilder builder;
    Move& move = builder.arc({5, 0, 0}, {0.6, 0, 0.8}, 3, 2, 60);
    move.aux_end[1] = -90;
    builder.program().aux_axes = 2;
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    for (const Segment& segment : plan.segments) {
        EXPECT_LT((ref::exact_position(segment, units(segment)) - segment.end).norm(), 1e-4);
        EXPECT_NEAR(ref::exact_aux(segment, 1, units(segment)), segment.aux_end[1], 1e-4);
        EXPECT_LE(std::abs(segment.aux_advance[1]), ref::kMostAxisRate * (1 + 1e-12));
    }
}

TEST(Planner, MovesWithoutXyzFollowUvwOrAbc) {
    ProgramBuilder builder;
    builder.line({0, 0, 0}, 60).aux_end[3] = 7;
    builder.line({0, 0, 0}, 60).aux_end[1] = 30;
    builder.program().aux_axes = 4;
    const Plan plan = make_plan(builder.program(), Machine(), PlanOptions());
    ASSERT_EQ(plan.segments.size(), 2u);
    EXPECT_NEAR(units(plan.segments[0]), 7e6, 1e-3);
    EXPECT_NEAR(units(plan.segments[1]), 30e6, 1e-3);
    EXPECT_EQ(plan.segments[1].aux_start[3], 7e6);
}

TEST(Planner, TravelOfAnArcIncludesItsTurningPoints) {
    std::mt19937 random(5);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    for (int i = 0; i < 300; ++i) {
        ProgramBuilder builder;
        const Vec3 normal(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        const Vec3 centre(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9));
        const Move& move = builder.arc(centre, normal, uniform(0.1, 15), uniform(-3, 3), 1);
        const ref::AxisRange range = ref::travel(move);
        Vec3 low = move.start;
        Vec3 high = move.start;
        const Vec3 n = move.start - move.centre;
        const Vec3 t = move.normal.cross(n);
        for (int k = 0; k <= 5000; ++k) {
            const double angle = move.angle * k / 5000;
            const Vec3 p =
                move.centre + n * std::cos(angle) + t * std::sin(angle) + move.advance * k / 5000;
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            EXPECT_NEAR(range.low[a], low[axis], 1e-4);
            EXPECT_NEAR(range.high[a], high[axis], 1e-4);
        }
    }
}

TEST(Planner, RefusesWhatItCannotCarry) {
    const PlanOptions options;
    {
        ProgramBuilder builder;
        builder.line({10, 0, 0}, 10);
        builder.line({1500, 0, 0}, 10).line = 7;
        EXPECT_EQ(refusal(builder.program(), Machine(), options),
                  "test.ngc:7: error: X = 1500 mm is beyond the machine's travel -1000 .. 1000 mm");
    }
    {
        ProgramBuilder builder;
        builder.arc({0, 999, 0}, {0, 0, 1}, 3, 0, 10).line = 3;
        EXPECT_EQ(refusal(builder.program(), Machine(), options),
                  "test.ngc:3: error: Y = 1988 mm is beyond the machine's travel -1000 .. 1000 mm");
    }
    {
        ProgramBuilder builder;
        builder.line({0, 0, -3000}, 10).line = 4;
        EXPECT_EQ(refusal(builder.program(), wide(), options),
                  "test.ngc:4: error: Z = 3000 mm needs PositionBits 33 (now 32) or a larger unit");
    }
    {
        ProgramBuilder builder;
        builder.line({7, 3, 0}, 10);
        PlanOptions coarse;
        coarse.format.guard_bits = 2;
        EXPECT_EQ(refusal(builder.program(), Machine(), coarse),
                  "test.ngc:1: error: this line needs GuardBits 4 to stay within 0.1 units of the "
                  "exact curve");
    }
    {
        ProgramBuilder builder;
        builder.arc({0.0001, 0, 0}, {0, 0, 1}, 3, 0, 10);
        PlanOptions coarse;
        coarse.unit_mm = 1e-3;
        EXPECT_EQ(
            refusal(builder.program(), Machine(), coarse),
            "test.ngc:1: error: this arc needs a unit of 1e-05 mm to stay within 0.1 units of "
            "the exact curve");
    }
    {
        ProgramBuilder builder;
        builder.line({1, 0, 0}, 10);
        builder.program().aux_axes = 3;
        PlanOptions few;
        few.aux_axes = 2;
        EXPECT_EQ(refusal(builder.program(), Machine(), few),
                  "test.ngc: error: the program needs AuxAxes 3 (now 2)");
    }
    {
        ProgramBuilder builder;
        builder.line({0, 0, 0}, 10);
        EXPECT_EQ(refusal(builder.program(), Machine(), options),
                  "test.ngc: error: the program moves nothing");
    }
    {
        ProgramBuilder builder;
        Move& move = builder.arc({10, 0, 0}, {0, 0, 1}, 1, 0, 10);
        move.end += Vec3(1e-6, 0, 0);
        EXPECT_EQ(refusal(builder.program(), Machine(), options),
                  "test.ngc:1: error: this arc misses its end point by 1e-06 mm");
    }
}

}  // namespace curvecore::tb::planner_test
