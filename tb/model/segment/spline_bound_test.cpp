// SPDX-License-Identifier: Apache-2.0
// The spline kernel against the exact curve: within the derived bound, and the bound is not idle.
#include "ref/bound/spline_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hls/curves/spline.hpp"
#include "hls/quantise.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/curves/spline_families.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace curvecore::tb::spline_bound_test {
using namespace sysc;

using hls::SamplerMode;

/// Worst error per axis in a segment, before the final rounding, in units.
template <class C>
double worst_error(const ref::Segment& segment, const hls::SegmentWords<C>& words,
                   SplineMaker& random) {
    hls::SplineCurve<C> kernel;
    kernel.load(words);
    const ref::Cubic cubic = segment.spline().cubic(segment.start);
    const ref::ArcLength truth(cubic);
    const std::uint64_t step = std::uint64_t{1} << (segment.step_exponent + hls::kPathFrac);
    double worst = 0;
    for (std::uint64_t begin = 0; begin < segment.length; begin += step) {
        if (begin > 0) kernel.step();
        const std::uint64_t span = std::min(step, segment.length - begin);
        for (int i = 0; i < 6; ++i) {
            const double place = i == 0 ? 1 : random.uniform(0, 1);
            const auto sigma = static_cast<std::uint64_t>(place * static_cast<double>(span - 1));
            hls::Word<C::kFineBits> out[C::kAxes];
            kernel.sample(static_cast<std::int64_t>(sigma), out);
            const double s = std::ldexp(static_cast<double>(begin + sigma), -hls::kPathFrac);
            const ref::Vec3 exact = cubic.position(truth.parameter(s));
            for (int axis = 0; axis < 3; ++axis) {
                const double got = std::ldexp(static_cast<double>(out[axis]), -C::kGuardBits);
                worst = std::max(worst, std::abs(got - exact[axis]));
            }
        }
    }
    return worst;
}

struct Worst {
    double error = 0;
    double bound = 0;
    int beyond = 0;
};

/// Cubics of a family that the words of the configuration can hold.
template <class C, class Spoil>
Worst measure(const SplineFamily& family, int curves, double limit, Spoil spoil) {
    SplineMaker random(5);
    Worst worst;
    for (int n = 0; n < curves; ++n) {
        const ref::Cubic cubic = random.next(family);
        for (const ref::Segment& segment : ref::split_spline(cubic, parameters_of<C>(), limit)) {
            if (segment.kind() == ref::CurveKind::kArc) continue;
            hls::SegmentWords<C> words = hls::to_words<C>(segment);
            spoil(words);
            const double error = worst_error<C>(segment, words, random);
            EXPECT_LE(segment.bound, limit);
            worst.error = std::max(worst.error, error);
            worst.bound = std::max(worst.bound, segment.bound);
            if (error > segment.bound) ++worst.beyond;
        }
    }
    return worst;
}

template <class C>
void expect_tight(double limit, int curves, double largest = 1e9, double factor = 8) {
    for (const SplineFamily& family : spline_families()) {
        if (family.size > largest || (family.size == 0 && largest < 1e9)) continue;
        const Worst worst = measure<C>(family, curves, limit, [](auto&) {});
        EXPECT_EQ(worst.beyond, 0) << family.name;
        EXPECT_LE(worst.bound, factor * worst.error) << family.name;
    }
}

template <int P, int W, int G, SamplerMode Mode, int ParameterGuard = 0>
using Core = hls::Configuration<P, W, 32, G, 0, Mode, true, ParameterGuard>;
constexpr SamplerMode kSeries = SamplerMode::kSeries;
constexpr SamplerMode kPolynomial = SamplerMode::kPolynomial;

TEST(SplineBound, CoversAndIsTightAtTheDefault) {
    expect_tight<hls::DefaultSplineConfiguration>(0.1, 20);
}
TEST(SplineBound, CoversAndIsTightInSeriesMode) { expect_tight<Core<6, 36, 10, kSeries>>(0.1, 10); }
TEST(SplineBound, CoversAndIsTightAtOrder2) {
    expect_tight<Core<2, 36, 10, kPolynomial>>(0.1, 1, 300e3);
}
TEST(SplineBound, CoversAndIsTightAtOrder3Series) {
    expect_tight<Core<3, 36, 10, kSeries>>(0.1, 3, 3e6);
}
TEST(SplineBound, CoversAndIsTightAtOrder4) { expect_tight<Core<4, 36, 10, kPolynomial>>(0.1, 6); }
TEST(SplineBound, CoversAndIsTightAtOrder8) { expect_tight<Core<8, 36, 10, kPolynomial>>(0.1, 6); }
// Some hundred independent roundings: their worst case is far from the usual sum.
TEST(SplineBound, CoversAtOrder12) { expect_tight<Core<12, 36, 12, kSeries>>(0.1, 6, 1e9, 16); }
TEST(SplineBound, CoversAndIsTightAt28Bits) {
    expect_tight<Core<6, 28, 10, kPolynomial>>(0.1, 6, 3e6);
}
TEST(SplineBound, CoversAndIsTightAt18Bits) {
    expect_tight<Core<4, 18, 4, kPolynomial>>(0.5, 6, 50e3);
}
TEST(SplineBound, CoversAndIsTightWithAFineParameter) {
    expect_tight<Core<4, 32, 10, kPolynomial, 4>>(0.1, 6);
    expect_tight<Core<3, 24, 8, kSeries, 8>>(0.2, 3, 300e3);
    expect_tight<Core<4, 18, 4, kPolynomial, 1>>(0.5, 6, 50e3);
}
// Purpose of the finer sum: segments as few as the cubic's words allow, not the sum's roundings.
TEST(SplineBound, AFineParameterNeedsFewerSegments) {
    std::size_t segments[2] = {0, 0};
    for (const int guard : {0, 4}) {
        ref::CoreParameters format = parameters_of<Core<4, 32, 10, kPolynomial>>();
        format.parameter_guard = guard;
        for (const SplineFamily& family : spline_families()) {
            SplineMaker random(5);
            segments[guard > 0] += ref::split_spline(random.next(family), format, 0.1).size();
        }
    }
    EXPECT_LT(segments[1], 0.9 * static_cast<double>(segments[0]));
}

}  // namespace curvecore::tb::spline_bound_test
