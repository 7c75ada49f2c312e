// SPDX-License-Identifier: Apache-2.0
// The spline kernel's words: the network's series, landing, both kinds in one stream, auxiliary
// axes, and the effect of the paper's propagation of all sixteen variables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hls/curve_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/bound/spline_words.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/curves/spline_families.hpp"
#include "tb/support/judge/open_spline.hpp"

namespace curvecore::tb::spline_kernel_test {
using namespace sysc;

using hls::SamplerMode;
using Default = hls::DefaultSplineConfiguration;
template <int P, int W, SamplerMode Mode, bool Anchor = true, int Aux = 0>
using Core = hls::Configuration<P, W, 32, 10, Aux, Mode, Anchor>;

/// Checks every coefficient of one step, from random words of order 0 taken as exact, against the
/// series of numbers; errors by ref/bound/spline_words.hpp.
template <class C>
void expect_series(int steps) {
    constexpr int kBits = C::kCoefBits;
    std::mt19937_64 random(9);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const auto word = [](double value, int frac) { return std::floor(std::ldexp(value, frac)); };
    ref::CoreParameters format;
    format.order = C::kOrder;
    format.coef_bits = kBits;
    double worst = 0;  // of error / derived error
    for (int n = 0; n < steps; ++n) {
        ref::Segment segment;  // a step from v = 0 with g = 1: 2b and 6a are the network's words
        segment.curve = ref::SplinePiece();
        ref::SplinePiece& spline = segment.spline();
        OpenSpline<C> network;
        const ref::Vec3 direction = ref::Vec3(uniform(-1, 1), uniform(-1, 1), 1).normalized();
        for (int k = 0; k < 3; ++k) {
            const double velocity = word(direction[k] * uniform(0.6, 0.9), kBits - 1);
            const double bend = word(uniform(-0.06, 0.06), kBits + 1);
            const double six_a = word(uniform(-0.03, 0.03), kBits + 1);
            network.V_[k][0] = static_cast<std::int64_t>(velocity);
            network.W_[k][0] = static_cast<std::int64_t>(bend);
            network.six_a_[k] = static_cast<std::int64_t>(six_a);
            spline.c[k] = std::ldexp(velocity, 1 - kBits);
            spline.b[k] = std::ldexp(bend, -1 - kBits) / 2;
            spline.a[k] = std::ldexp(six_a, -1 - kBits) / 6;
        }
        ref::SplineWords words(format, segment);
        std::array<ref::Enclosed, 3> V, W;
        for (int k = 0; k < 3; ++k) {
            V[k] = spline.c[k];
            W[k] = 2 * spline.b[k];
        }
        const double phi = 1 / spline.c.norm();
        words.open(V, W, {phi, ref::half_bit(kBits - 2), 0});
        words.expand();
        network.phi_[0] = std::llround(std::ldexp(phi, kBits - 2));
        network.derivatives_of_phi();
        network.orders();
        const auto check = [&](std::int64_t got, int frac, const ref::Enclosed& wanted) {
            const double wrong =
                std::abs(std::ldexp(static_cast<double>(got), -frac) - wanted.value);
            EXPECT_LE(wrong, wanted.rounding * (1 + 1e-6) + 1e-15);
            worst = std::max(worst, wrong / wanted.rounding);
        };
        for (int i = 1; i <= C::kOrder; ++i) {
            check(network.q_[i], kBits - 2, words.q(i));
            if (i <= C::kTop) check(network.phi_[i], kBits - 2, words.phi(i));
            for (int k = 0; k < 3; ++k) {
                if (i < C::kTop) {
                    check(network.W_[k][i], kBits + 1, words.W(k, i));
                }
                if (C::kSeries) check(network.x_[k][i], kBits - 2, words.x(k, i));
            }
        }
    }
    EXPECT_GT(worst, 0.5) << "the derived errors are idle";
}

TEST(SplineKernel, WordsAreTheSeriesWithinTheirRoundings) {
    expect_series<Core<6, 36, SamplerMode::kSeries>>(300);
    expect_series<Core<12, 36, SamplerMode::kSeries, false>>(100);
    expect_series<Core<6, 36, SamplerMode::kPolynomial>>(300);
    expect_series<Core<2, 28, SamplerMode::kSeries>>(300);
    expect_series<Core<5, 18, SamplerMode::kSeries>>(300);
}

/// Largest m = |V|^2 phi of any step, with phi as the step before left it: its word ends at 1.
template <class C>
double largest_newton_product(double limit,
                              const std::vector<SplineFamily>& families = spline_families(),
                              int skipped = 0, int curves = 4) {
    ref::CoreParameters format;
    format.order = C::kOrder;
    format.coef_bits = C::kCoefBits;
    double largest = 0;
    SplineMaker random(11);
    for (const SplineFamily& family : families) {
        for (int n = 0; n < skipped + curves; ++n) {
            const ref::Cubic cubic = random.next(family);
            if (n < skipped) continue;
            for (const ref::Segment& piece : ref::split_spline(cubic, format, limit)) {
                if (piece.kind() != ref::CurveKind::kSpline) continue;
                OpenSpline<C> kernel;
                kernel.load(hls::to_words<C>(piece));
                const auto steps = piece.length >> (piece.step_exponent + 16);
                for (std::uint64_t step = 0; step < steps; ++step) {
                    const std::int64_t phi = OpenSpline<C>::sum(kernel.phi_, 0, C::kTop);
                    kernel.step();
                    double norm = 0;
                    for (const auto& V : kernel.V_) {
                        norm +=
                            std::pow(std::ldexp(static_cast<double>(V[0]), 1 - C::kCoefBits), 2);
                    }
                    largest = std::max(
                        largest, norm * std::ldexp(static_cast<double>(phi), 2 - C::kCoefBits));
                }
            }
        }
    }
    return largest;
}

TEST(SplineKernel, NewtonsProductIsAWord) {
    for (const double largest :
         {largest_newton_product<Core<3, 30, SamplerMode::kPolynomial>>(6500),
          largest_newton_product<Core<4, 24, SamplerMode::kPolynomial>>(400),
          largest_newton_product<Core<6, 36, SamplerMode::kPolynomial>>(0.1),
          // By the time |V| is largest, v has drifted to where it is larger still.
          largest_newton_product<Core<2, 24, SamplerMode::kPolynomial>>(200, {spline_families()[2]},
                                                                        360, 10),
          largest_newton_product<Core<12, 36, SamplerMode::kSeries>>(0.1)}) {
        EXPECT_LT(largest, 1);
        EXPECT_GT(largest, 0.99) << "no step comes near";
    }
}

/// Pieces of a few cubics and the lines between them, as one path.
std::vector<ref::Segment> mixed_segments(const ref::CoreParameters& format) {
    SplineMaker random(3);
    std::vector<ref::Segment> segments;
    for (const SplineFamily& family : {spline_families()[2], spline_families()[6]}) {
        for (const ref::Segment& piece : ref::split_spline(random.next(family), format, 0.1)) {
            segments.push_back(piece);
            ref::Segment line;
            line.start = piece.end;
            line.arc().advance = ref::Vec3(1, 2, -2) / 3;
            line.length = 3000 * 65536 + 77;
            line.end = line.start + line.arc().advance * (3000 + 77.0 / 65536);
            line.step_exponent = 9;
            segments.push_back(line);
        }
    }
    return segments;
}

template <class C>
void expect_one_stream() {
    const std::vector<ref::Segment> segments = mixed_segments({});
    hls::MotionKernel<C> stream;
    std::size_t next = 0;
    std::int64_t rest = 0;  // from the last sample to the end of its segment
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const hls::SegmentWords<C> words = hls::to_words<C>(segments[i]);
        const bool spline = segments[i].kind() == ref::CurveKind::kSpline;
        hls::InterpolatorKernel<C, hls::SplineCurve<C>> splines;
        hls::InterpolatorKernel<C> arcs;
        const auto length = static_cast<std::int64_t>(segments[i].length);
        std::int64_t at = 0;
        for (const std::int64_t ds : {length / 3, length / 7, length / 1000 + 1, std::int64_t{1}}) {
            at += ds;
            hls::Word<C::kFineBits> alone[C::kAxes], together[C::kAxes];
            const auto same = [&] { return words; };
            spline ? splines.sample(ds, same, alone) : arcs.sample(ds, same, alone);
            stream.sample(
                ds + rest, [&] { return hls::to_words<C>(segments.at(next++)); }, together);
            rest = 0;
            for (int axis = 0; axis < C::kAxes; ++axis) ASSERT_EQ(alone[axis], together[axis]);
        }
        rest = length - at;
    }
    hls::Word<C::kFineBits> end[C::kAxes];
    stream.sample(
        rest, [] { return hls::SegmentWords<C>{}; }, end);
    for (int axis = 0; axis < C::kAxes; ++axis) {
        EXPECT_EQ(end[axis], hls::to_words<C>(segments.back()).end[axis]);
    }
}

TEST(MotionKernel, DrawsBothKindsFromOneStreamAndLandsOnTheEndWord) {
    expect_one_stream<Default>();
    expect_one_stream<Core<6, 36, SamplerMode::kSeries>>();
}

TEST(SplineKernel, DrawsAStraightLineAtConstantSpeedWithoutError) {
    hls::SegmentWords<Default> words;
    words.kind = hls::SegmentKind::kSpline;
    words.length = std::int64_t{1} << 36;
    words.step_exponent = 16;
    words.lambda = 20;
    words.theta = std::int64_t{3} << 33;   // phi = 3/2
    const std::int64_t c[3] = {2, -1, 2};  // in 2/9: |c| = 2/3
    for (int axis = 0; axis < 3; ++axis) {
        words.advance[axis] = std::llround(std::ldexp(c[axis] * 2 / 9.0, 34));
    }
    hls::InterpolatorKernel<Default, hls::SplineCurve<Default>> kernel;
    for (int n = 1; n < 64; ++n) {
        hls::Word<Default::kFineBits> out[3];
        kernel.sample(
            std::int64_t{1} << 30, [&] { return words; }, out);
        for (int axis = 0; axis < 3; ++axis) {
            const double exact = c[axis] / 3.0 * n * 16384;
            EXPECT_NEAR(std::ldexp(static_cast<double>(out[axis]), -10), exact, 0.002);
        }
    }
}

TEST(SplineKernel, AuxiliaryAxesAreLinearInThePath) {
    using C = Core<6, 36, SamplerMode::kPolynomial, true, 2>;
    SplineMaker random(8);
    const ref::Cubic cubic = random.next(spline_families()[2]);
    ref::Segment piece = ref::split_spline(cubic, {}, 0.1)[0];
    piece.aux_advance[0] = 0.75;
    piece.aux_advance[1] = -1.6;
    piece.aux_start[1] = 5000;
    hls::InterpolatorKernel<C, hls::SplineCurve<C>> kernel;
    const std::int64_t ds = static_cast<std::int64_t>(piece.length) / 37;
    for (int n = 1; n < 37; ++n) {
        hls::Word<C::kFineBits> out[C::kAxes];
        kernel.sample(
            ds, [&] { return hls::to_words<C>(piece); }, out);
        const double s = static_cast<double>(n * ds) / 65536;
        EXPECT_NEAR(std::ldexp(static_cast<double>(out[3]), -10), 0.75 * s, 0.02);
        EXPECT_NEAR(std::ldexp(static_cast<double>(out[4]), -10), 5000 - 1.6 * s, 0.02);
    }
}

/// Worst error per axis of a piece at steps of 2^k units.
template <class C>
double worst_error(ref::Segment piece, int k) {
    piece.step_exponent = k;
    const ref::Cubic cubic = piece.spline().cubic(piece.start);
    const ref::ArcLength truth(cubic);
    hls::InterpolatorKernel<C, hls::SplineCurve<C>> kernel;
    const std::int64_t ds = static_cast<std::int64_t>(piece.length) / 1001;
    double worst = 0;
    for (int n = 1; n <= 1000; ++n) {
        hls::Word<C::kFineBits> out[C::kAxes];
        kernel.sample(
            ds, [&] { return hls::to_words<C>(piece); }, out);
        const ref::Vec3 exact =
            cubic.position(truth.parameter(static_cast<double>(n * ds) / 65536));
        for (int axis = 0; axis < 3; ++axis) {
            worst = std::max(
                worst, std::abs(std::ldexp(static_cast<double>(out[axis]), -10) - exact[axis]));
        }
    }
    return worst;
}

TEST(SplineKernel, WithoutTheAnchorErrorsStayAndGrow) {
    SplineMaker random(4);
    double anchored = 0, propagated = 0, series = 0;
    for (int n = 0; n < 10; ++n) {
        const ref::Cubic cubic = random.next(spline_families()[7]);
        for (const ref::Segment& piece : ref::split_spline(cubic, {}, 0.1)) {
            const int k = piece.step_exponent - 3;
            anchored = std::max(anchored, worst_error<Default>(piece, k));
            propagated = std::max(
                propagated, worst_error<Core<6, 36, SamplerMode::kPolynomial, false>>(piece, k));
            series =
                std::max(series, worst_error<Core<6, 36, SamplerMode::kSeries, false>>(piece, k));
        }
    }
    RecordProperty("anchored", std::to_string(anchored));
    RecordProperty("propagated", std::to_string(propagated));
    EXPECT_LT(anchored, 0.1);
    EXPECT_GT(propagated, 2 * anchored);
    EXPECT_GT(series, 2 * anchored);
    EXPECT_LT(series, 100 * anchored);  // it is the same curve
}

}  // namespace curvecore::tb::spline_kernel_test
