// SPDX-License-Identifier: Apache-2.0
// Error figures of `curvecore compare`, and the curve that it compares with.
#include "sysc/curves/error_figures.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "ref/geometry/geometry.hpp"
#include "ref/plan/curve_follower.hpp"
#include "sysc/curves/built_in_curves.hpp"
#include "sysc/curves/exact_samples.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::tb::error_figures_test {
using namespace sysc;

TEST(ErrorFigures, OfEvenlySpreadErrors) {
    const auto count = std::make_unique<ErrorCount>();
    for (int i = 1; i <= 100000; ++i) count->add(i % 2 == 0 ? i * 1e-5 : -i * 1e-5);
    const ErrorFigures figures = count->figures();
    EXPECT_NEAR(figures.worst, 1, 1e-6);
    EXPECT_NEAR(figures.rms, std::sqrt(1 / 3.0), 1e-4);
    EXPECT_GE(figures.most, 0.999);
    EXPECT_LE(figures.most, 1);
}

TEST(ErrorFigures, MostIsBelowRareErrors) {
    const auto count = std::make_unique<ErrorCount>();
    for (int i = 0; i < 9991; ++i) count->add(0.25);
    for (int i = 0; i < 9; ++i) count->add(100);
    EXPECT_GE(count->figures().most, 0.25);
    EXPECT_LE(count->figures().most, 0.25 * 1.017);
    for (int i = 0; i < 9; ++i) count->add(100);
    EXPECT_EQ(count->figures().most, 100);
}

TEST(ValueRange, BitsOfTheLeastWord) {
    const auto bits = [](std::int64_t low, std::int64_t high) {
        ValueRange range;
        range.add(low);
        range.add(high);
        return range.bits();
    };
    EXPECT_EQ(bits(0, 0), 1);
    EXPECT_EQ(bits(-1, 0), 1);
    EXPECT_EQ(bits(0, 1), 2);
    EXPECT_EQ(bits(-2, 1), 2);
    EXPECT_EQ(bits(-3, 1), 3);
    EXPECT_EQ(bits(-(std::int64_t{1} << 35), (std::int64_t{1} << 35) - 1), 36);
    EXPECT_EQ(bits(0, std::int64_t{1} << 35), 37);
}

TEST(ValueRanges, CountWhatAWordLacks) {
    ValueRanges ranges(18);
    constexpr hls::WordRow kRows[] = {{"phi", -2}, {"W", 1}, {nullptr, 0}};
    const int phi = ranges.first_row("spline", kRows);
    const int W = phi + 1;
    EXPECT_EQ(ranges.first_row("spline", kRows), phi);
    EXPECT_EQ(ranges.first_row("other", kRows), phi + 2);
    ranges.note(phi, 3, 131071);
    ranges.note(phi, 3, -131072);
    EXPECT_EQ(ranges.missing(), 0);
    ranges.note(W, 12, 131072);
    EXPECT_EQ(ranges.missing(), 1);
    ranges.note(W, 12, -(std::int64_t{1} << 20) - 5);
    EXPECT_EQ(ranges.missing(), 4);
    EXPECT_TRUE(ranges.rows()[1].orders[11].empty());
}

TEST(RunTimeFormat, KeepsWhatAWordHolds) {
    CoreParameters core;
    core.coef_bits = 18;
    const RunTimeFormat format(core, 3);
    EXPECT_EQ(format.keep(0, 3, 131071), 131071);
    EXPECT_EQ(format.keep(0, 3, -131072), -131072);
    EXPECT_EQ(format.keep(0, 12, 131072), -131072);
    EXPECT_EQ(format.keep(0, 12, -(std::int64_t{1} << 20) - 5), -5);
}

/// Compares with the planner's own segments, which tb/model and tb/campaign compare with closed
/// forms.
TEST(ExactSamples, AreOnTheSegmentsOfAPlan) {
    const ref::Program program = built_in_curves(CurveSet::kAll);
    const ref::Geometry geometry =
        ref::make_geometry(program, unlimited_machine(), ref::PlanOptions());
    int calls = 0;
    const ExactSamples exact =
        exact_samples(program, 1e-6, 20000, [&calls](std::int64_t) { ++calls; });
    EXPECT_NEAR(static_cast<double>(exact.samples.size()), 20000, 100);
    EXPECT_EQ(calls, 1);
    ref::CurveFollower curve;
    std::size_t index = 0;
    std::vector<int> of_move(program.moves.size());
    const ExactSample* before = nullptr;
    for (const ExactSample& sample : exact.samples) {
        const auto end = [&] {
            return static_cast<std::int64_t>(geometry.segments[index].s_start +
                                             geometry.segments[index].length);
        };
        const std::size_t move_before = geometry.segments[index].move;
        while (sample.s > end()) ++index;
        const ref::Segment& segment = geometry.segments.at(index);
        ++of_move[segment.move];
        const double s = std::ldexp(
            static_cast<double>(sample.s - static_cast<std::int64_t>(segment.s_start)), -16);
        const ref::Vec3 point = curve.on(segment).position(s);
        const ref::Vec3 got(sample.position[0], sample.position[1], sample.position[2]);
        const ref::Vec3 tangent(sample.tangent[0], sample.tangent[1], sample.tangent[2]);
        EXPECT_LE((got - point).norm(), 3e-3) << "move " << segment.move;
        EXPECT_NEAR(tangent.norm(), 1, 1e-9);
        if (s + 1 < std::ldexp(static_cast<double>(segment.length), -16)) {
            EXPECT_GE((curve.on(segment).position(s + 1) - point).dot(tangent), 0.99);
        }
        if (before != nullptr && segment.move == move_before) {
            const ref::Vec3 last(before->position[0], before->position[1], before->position[2]);
            EXPECT_NEAR(sample.chord, (got - last).norm(), 1e-6);
        } else {
            EXPECT_EQ(sample.chord, 0);
        }
        before = &sample;
    }
    for (const int count : of_move) EXPECT_GE(count, 200);
}

}  // namespace curvecore::tb::error_figures_test
