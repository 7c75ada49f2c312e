// SPDX-License-Identifier: Apache-2.0
// The kernel with widths at run time gives the words of the compile-time form: positions of seeded
// streams of arcs, helices, lines and splines, and the series of every step, at the edges of every
// parameter.
#include "sysc/widths/run_time_kernel.hpp"

#include <gtest/gtest.h>

#include "hls/curve_kernel.hpp"
#include "tb/support/mixed_segments.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

using hls::SamplerMode;

template <class C>
CoreParameters setting_of() {
    CoreParameters setting{C::kOrder,
                           C::kCoefBits,
                           C::kPositionBits,
                           C::kGuardBits,
                           C::kMode == SamplerMode::kPolynomial,
                           C::kTurnBits,
                           C::kParameterGuard};
    setting.anchor = C::kAnchor ? 1 : 0;
    return setting;
}

template <class C>
RunSegment run_segment(const hls::SegmentWords<C>& words) {
    RunSegment run;
    run.spline = words.kind == hls::SegmentKind::kSpline;
    run.length = words.length;
    run.theta = words.theta;
    run.step_exponent = words.step_exponent;
    run.lambda = words.lambda;
    for (int axis = 0; axis < C::kAxes; ++axis) {
        run.start[axis] = words.start[axis];
        run.end[axis] = words.end[axis];
        run.advance[axis] = words.advance[axis];
    }
    for (int axis = 0; axis < 3; ++axis) {
        run.tangent[axis] = words.tangent[axis];
        run.normal[axis] = words.normal[axis];
    }
    return run;
}

template <class C>
class RunTimeKernelOf : public testing::Test {};

template <int P, int W, int G, SamplerMode Mode, bool Anchor, int Position = 32, int Aux = 0,
          int Turn = 0, int Guard = 0>
using Core = hls::Configuration<P, W, Position, G, Aux, Mode, Anchor, Turn, Guard>;
constexpr SamplerMode kSer = SamplerMode::kSeries;
constexpr SamplerMode kPol = SamplerMode::kPolynomial;

using Cores = testing::Types<
    Core<2, 18, 2, kSer, true>, Core<2, 36, 12, kPol, true>, Core<3, 27, 4, kSer, false>,
    Core<3, 19, 10, kPol, false, 24>, Core<4, 32, 8, kPol, true>, Core<4, 33, 10, kSer, true>,
    Core<5, 24, 6, kPol, true, 32, 2>, Core<6, 36, 10, kSer, true>, Core<6, 36, 10, kPol, true>,
    Core<6, 36, 10, kSer, false>, Core<6, 36, 10, kPol, false>, Core<6, 28, 10, kPol, true, 20>,
    Core<7, 35, 11, kPol, false>, Core<8, 30, 10, kSer, true, 32, 6>, Core<8, 31, 9, kPol, true>,
    Core<2, 23, 3, kSer, true, 32, 0, 10>, Core<6, 36, 10, kSer, true, 32, 0, 2>,
    Core<12, 31, 9, kSer, true, 32, 1, 1>, Core<4, 20, 8, kPol, true, 32, 0, 0, 8>,
    Core<6, 36, 10, kSer, true, 32, 0, 0, 1>, Core<5, 28, 9, kPol, false, 32, 1, 0, 4>,
    Core<11, 34, 12, kSer, false>, Core<12, 36, 12, kSer, true>, Core<12, 18, 2, kPol, true>>;
TYPED_TEST_SUITE(RunTimeKernelOf, Cores);

TYPED_TEST(RunTimeKernelOf, DrawsTheSameSamples) {
    using C = TypeParam;
    MixedSegments<C> random(5);
    std::vector<hls::SegmentWords<C>> words;
    std::vector<RunSegment> segments;
    std::int64_t length = 0;
    while (words.size() < 400) {
        words.push_back(random.next());
        segments.push_back(run_segment<C>(words.back()));
        length += words.back().length;
    }
    ValueRanges ranges(C::kCoefBits);
    RunTimeKernel run(setting_of<C>(), C::kAxes, ranges);
    std::size_t run_next = 0;
    hls::MotionKernel<C> kernel;
    std::size_t next = 0;
    std::mt19937_64 engine(1);
    std::int64_t walked = 0;
    int samples = 0;
    while (walked < length) {
        // From a quantum to many steps, and exactly onto segments' ends.
        std::int64_t ds = std::int64_t(engine() >> (engine() % 40 + 24)) % (length / 300);
        if (engine() % 8 == 0 && next > 0) {
            std::int64_t end = 0;
            for (std::size_t i = 0; i < next; ++i) end += words[i].length;
            ds = end - walked;
        }
        ds = std::min(ds, length - walked);
        walked += ds;
        hls::Word<C::kFineBits> expected[C::kAxes];
        RunWord got[kMostAxes];
        kernel.sample(
            ds, [&]() -> const hls::SegmentWords<C>& { return words.at(next++); }, expected);
        run.sample(
            ds, [&]() -> const RunSegment& { return segments.at(run_next++); }, got);
        for (int axis = 0; axis < C::kAxes; ++axis) {
            ASSERT_EQ(got[axis], expected[axis])
                << "axis " << axis << " sample " << samples << " segment " << next - 1;
        }
        ASSERT_EQ(run_next, next);
        ++samples;
    }
    EXPECT_GT(samples, 300);
}

/// Pieces of a plan as words: the same fields from the same real numbers.
TYPED_TEST(RunTimeKernelOf, LoadsTheSameWords) {
    using C = TypeParam;
    const CoreParameters format = setting_of<C>();
    SplineMaker maker(2);
    std::vector<ref::Segment> segments =
        ref::split_spline(maker.next({"", SplineShape::kRandom, 20e3}), format, 400);
    ref::Segment arc;
    arc.length = 1000 * 65536 + 3;
    arc.start = ref::Vec3(1.25, -7.1, 100.3);
    arc.end = ref::Vec3(-1.7, 1000.5, 0);
    arc.normal = ref::Vec3(1, 2, -2) / 3;
    arc.tangent = ref::Vec3(2, 1, 2) / 3;
    arc.cos_pitch = 0.8;
    arc.radius = 1234.5;
    arc.advance = 0.6 * arc.normal.cross(arc.tangent);
    arc.aux_start.fill(-3.3);
    arc.aux_advance.fill(0.7);
    arc.step_exponent = 8;
    segments.push_back(arc);
    for (ref::Segment& segment : segments) {
        for (ref::Vec3* point : {&segment.start, &segment.end}) {
            *point *= std::ldexp(1.0, format.position_bits - 33);  // a quarter of the range
        }
        const RunSegment expected = run_segment<C>(hls::to_words<C>(segment));
        const RunSegment got = to_run_words(segment, format, C::kAxes);
        EXPECT_EQ(got.spline, expected.spline);
        EXPECT_EQ(got.length, expected.length);
        EXPECT_EQ(got.theta, expected.theta);
        EXPECT_EQ(got.step_exponent, expected.step_exponent);
        EXPECT_EQ(got.lambda, expected.lambda);
        for (int axis = 0; axis < C::kAxes; ++axis) {
            EXPECT_EQ(got.start[axis], expected.start[axis]);
            EXPECT_EQ(got.end[axis], expected.end[axis]);
            EXPECT_EQ(got.advance[axis], expected.advance[axis]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(got.tangent[axis], expected.tangent[axis]);
            EXPECT_EQ(got.normal[axis], expected.normal[axis]);
        }
    }
    EXPECT_GT(segments.size(), 1U);
}

}  // namespace
}  // namespace curvecore::tb
