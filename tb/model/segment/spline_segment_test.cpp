// SPDX-License-Identifier: Apache-2.0
// A cubic cut into segments that the core can draw: ranges, joints, lengths, refusals; and the
// direction of the bound.
#include "ref/segment/spline_segment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hls/curves/spline.hpp"
#include "hls/quantise.hpp"
#include "ref/bound/spline_bound.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/plan/segment_curve.hpp"
#include "sysc/curves/spline_families.hpp"

namespace curvecore::tb::spline_segment_test {
using namespace sysc;

const ref::CoreParameters kFormat{6, 36, 32, 10, true};

TEST(SplineSegment, PiecesKeepTheWordsRangesAndJoin) {
    SplineMaker random(12);
    for (const SplineFamily& family : spline_families()) {
        const ref::Cubic cubic = random.next(family);
        const std::vector<ref::Segment> pieces = ref::split_spline(cubic, kFormat, 0.1, 1000);
        std::uint64_t s = 1000;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const ref::Segment& piece = pieces[i];
            EXPECT_EQ(piece.s_start, s);
            s += piece.length;
            EXPECT_LE(piece.bound, 0.1);
            const ref::Vec3 joint = i > 0 ? pieces[i - 1].end : cubic.d;
            EXPECT_LT((piece.start - joint).norm(), 1e-5);
            if (piece.kind() == ref::CurveKind::kArc) continue;
            EXPECT_LE(piece.step_exponent, piece.spline().lambda);
            EXPECT_LT(piece.spline().beta, 1);
            for (int n = 0; n <= 16; ++n) {
                const double v = piece.spline().beta * n / 16;
                const ref::Vec3 bend = piece.spline().b + 3 * v * piece.spline().a;
                const double speed = (piece.spline().c + v * (piece.spline().b + bend)).norm();
                EXPECT_LT(speed, 1);
                EXPECT_GT(speed, 0.5);
                EXPECT_LT(bend.cwiseAbs().maxCoeff(), 2);
            }
            EXPECT_LT(piece.spline().a.cwiseAbs().maxCoeff(), 2.0 / 3);
        }
        EXPECT_LT((pieces.back().end - cubic.position(1)).norm(), 1e-5);
        EXPECT_NEAR(static_cast<double>(s - 1000), 65536 * ref::arc_length(cubic, 0, 1), 8);
    }
}

TEST(SplineSegment, ExactPositionIsThatOfTheWholeCubic) {
    SplineMaker random(13);
    const ref::Cubic cubic = random.next(spline_families()[3]);
    for (const ref::Segment& piece : ref::split_spline(cubic, kFormat, 0.1)) {
        const double s = static_cast<double>(piece.length) / 65536 * 0.37;
        const double whole = s + static_cast<double>(piece.s_start) / 65536;
        const ref::Vec3 exact = cubic.position(ref::parameter_at(cubic, whole));
        EXPECT_LT((ref::exact_position(piece, s) - exact).norm(), 2e-5);  // two lengths are rounded
    }
}

TEST(SplineSegment, DrawsACuspByShortLines) {
    // r = (u - 1/2)^2 x + (u - 1/2)^3 y: stands still at 1/2.
    const double size = 1e6;
    ref::Cubic cubic;
    cubic.a = ref::Vec3(0, size, 0);
    cubic.b = ref::Vec3(size, -1.5 * size, 0);
    cubic.c = ref::Vec3(-size, 0.75 * size, 0);
    const std::vector<ref::Segment> pieces = ref::split_spline(cubic, kFormat, 0.1);
    int lines = 0;
    for (const ref::Segment& piece : pieces) {
        if (piece.kind() == ref::CurveKind::kSpline) continue;
        ++lines;
        EXPECT_LE(piece.length, 4U * 65536);
        EXPECT_LE(piece.arc().advance.norm(), 1 + 1e-9);
    }
    EXPECT_GT(lines, 0);
    EXPECT_LT(pieces.size(), 100U);
}

TEST(SplineSegment, RefusesALimitThatNoSplittingCanKeep) {
    SplineMaker random(14);
    const ref::Cubic cubic = random.next(spline_families()[1]);
    EXPECT_THROW(ref::split_spline(cubic, kFormat, 0.0015), std::domain_error);
    EXPECT_NO_THROW(ref::split_spline(cubic, kFormat, 0.01));
}

/// A piece of 20 mm with its step.
ref::Segment piece() {
    SplineMaker random(15);
    return ref::split_spline(random.next(spline_families()[3]), kFormat, 0.1)[0];
}

TEST(SplineError, GrowsAsWidthOrOrderShrink) {
    const ref::Segment segment = piece();
    const ref::SplineError here = ref::spline_error(kFormat, segment);
    ref::CoreParameters narrow = kFormat;
    narrow.coef_bits = 32;
    EXPECT_GT(ref::spline_error(narrow, segment).rounding, 8 * here.rounding);
    ref::CoreParameters low = kFormat;
    low.order = 5;
    EXPECT_GT(ref::spline_error(low, segment).truncation, 5 * here.truncation);
    EXPECT_EQ(ref::segment_bound(kFormat, segment), here.total());
}

TEST(SplineError, RefusesStepsBeyondTheWordsRanges) {
    ref::Segment segment = piece();
    EXPECT_EQ(ref::spline_error(kFormat, segment).shorten, ref::Shorten::kNothing);
    segment.step_exponent = segment.spline().lambda;
    EXPECT_EQ(ref::spline_error(kFormat, segment).shorten, ref::Shorten::kSteps);
}

template <class C>
double worst_error(const ref::Segment& segment, std::int64_t spoil) {
    hls::SegmentWords<C> words = hls::to_words<C>(segment);
    words.advance[0] += spoil;
    words.normal[1] += spoil;
    hls::SplineCurve<C> kernel;
    kernel.load(words);
    const std::uint64_t step = std::uint64_t{1} << (segment.step_exponent + hls::kPathFrac);
    double worst = 0;
    for (std::uint64_t s = step / 2; s < segment.length; s += step) {
        if (s > step) kernel.step();
        hls::Word<C::kFineBits> out[3];
        kernel.sample(static_cast<std::int64_t>(step / 2), out);
        const ref::Vec3 exact =
            ref::exact_position(segment, std::ldexp(static_cast<double>(s), -16));
        for (int axis = 0; axis < 3; ++axis) {
            const double got = std::ldexp(static_cast<double>(out[axis]), -C::kGuardBits);
            worst = std::max(worst, std::abs(got - exact[axis]));
        }
    }
    return worst;
}

TEST(SplineError, IsLeftByALowerOrderAndByWrongLastBits) {
    const ref::Segment segment = piece();
    using C = hls::DefaultSplineConfiguration;
    using Lower = hls::Configuration<4, 36, 32, 10, 0, hls::SamplerMode::kPolynomial>;
    EXPECT_LE(worst_error<C>(segment, 0), segment.bound);
    EXPECT_GT(worst_error<Lower>(segment, 0), segment.bound);
    EXPECT_GT(worst_error<C>(segment, 128), segment.bound);
}

}  // namespace curvecore::tb::spline_segment_test
