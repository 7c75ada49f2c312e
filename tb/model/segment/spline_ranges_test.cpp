// SPDX-License-Identifier: Apache-2.0
// Ranges of a planned spline's words and of the sums that are handed on: cubics that reach their
// limits, drawn by the kernel whose words throw on overflow.
#define CURVECORE_CHECKED
#include <gtest/gtest.h>

#include "ref/segment/spline_segment.hpp"
#include "tb/support/judge/checked_drawing.hpp"
#include "tb/support/segments/extreme_cubics.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace curvecore::tb::spline_ranges_test {

using hls::SamplerMode;

TEST(CheckedWord, HoldsItsRangeAndThrowsBeyond) {
    EXPECT_EQ(hls::to_int(hls::Word<4>(7)), 7);
    EXPECT_EQ(hls::to_int(hls::Word<4>(-8)), -8);
    EXPECT_THROW(hls::Word<4>(8), std::range_error);
    EXPECT_THROW(hls::Word<4>(-9), std::range_error);
    const hls::Word<36> largest = (std::int64_t{1} << 35) - 1;
    EXPECT_THROW(hls::Word<36>(largest + 1), std::range_error);
    EXPECT_NO_THROW(hls::Word<72>(hls::Word<72>(largest) * hls::Word<72>(largest)));
}

/// A cubic in units of 1 nm. The speed has its minimum, half its maximum, where a step ends: the
/// phi handed on is above 2 if all is one segment.
ref::Cubic slow_at_a_joint() {
    const auto x = [](double mm) { return ref::Vec3(1e6 * mm, 0, 0); };
    return ref::from_bezier(
        {x(0), x(0.625151909490), x(1.202284592285 - 0.324508738369), x(1.202284592285)});
}

TEST(SplineRanges, HandsOnAPhiBelowTwo) {
    using C = hls::DefaultSplineConfiguration;
    for (const ref::Segment& segment :
         ref::split_spline(slow_at_a_joint(), parameters_of<C>(), 0.1)) {
        EXPECT_NO_THROW(draw_checked<C>(segment));
    }
    // Most step lengths of the whole put that minimum at the end of a step.
    ref::Segment whole = ref::spline_segment(slow_at_a_joint(), parameters_of<C>());
    whole.step_exponent = whole.spline().lambda - 5;
    EXPECT_THROW(draw_checked<C>(whole), std::range_error);
}

template <class C>
void expect_in_range(Extreme extreme, int cubics, double limit, double size) {
    ExtremeCubics random(3, 1.0 / 1024, std::ldexp(1.0, 6 - C::kCoefBits));
    int drawn = 0;
    for (int n = 0; n < cubics; ++n) {
        const ref::Cubic cubic = random.next(extreme, size * random.uniform(0.3, 1));
        for (const ref::Segment& segment : ref::split_spline(cubic, parameters_of<C>(), limit)) {
            if (segment.kind() != ref::CurveKind::kSpline) continue;
            ++drawn;
            EXPECT_NO_THROW(draw_checked<C>(segment)) << "cubic " << n << " of " << C::kOrder;
        }
    }
    EXPECT_GE(drawn, cubics);
}

template <int P, int W, SamplerMode Mode>
using Core = hls::Configuration<P, W, 32, 10, 0, Mode>;

TEST(SplineRanges, KeepTheirWordsWhereTheSpeedIsLeast) {
    expect_in_range<hls::DefaultSplineConfiguration>(Extreme::kSlowest, 60, 0.1, 2e6);
    expect_in_range<Core<3, 24, SamplerMode::kSeries>>(Extreme::kSlowest, 60, 0.3, 2e4);
    expect_in_range<Core<12, 36, SamplerMode::kPolynomial>>(Extreme::kSlowest, 60, 0.3, 2e6);
}

TEST(SplineRanges, KeepTheirWordsWhereTheCurveBendsMost) {
    expect_in_range<Core<2, 28, SamplerMode::kPolynomial>>(Extreme::kBend, 60, 0.45, 1e4);
    expect_in_range<Core<2, 36, SamplerMode::kPolynomial>>(Extreme::kBend, 60, 0.45, 1e4);
    expect_in_range<hls::DefaultSplineConfiguration>(Extreme::kCubicTerm, 60, 0.1, 2e6);
}

}  // namespace curvecore::tb::spline_ranges_test
