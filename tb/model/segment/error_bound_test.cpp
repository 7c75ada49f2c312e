// SPDX-License-Identifier: Apache-2.0
// The derived bounds against the kernel: never exceeded, and never idle.
#include "ref/bound/error_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hls/curves/arc.hpp"
#include "hls/quantise.hpp"
#include "ref/feed/planner.hpp"
#include "ref/plan/segment_curve.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/program_builder.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace curvecore::tb::error_bound_test {

using hls::SamplerMode;

/// Worst error of the kernel in a segment, before the final rounding, over random samples of every
/// step; in units.
template <class C, class Spoil>
double worst_error(const ref::Segment& segment, std::mt19937_64& random, Spoil spoil) {
    hls::SegmentWords<C> words = hls::to_words<C>(segment);
    spoil(words);
    hls::ArcCurve<C> kernel;
    kernel.load(words);
    const std::uint64_t step = std::uint64_t{1} << (segment.step_exponent + 16);
    double worst = 0;
    for (std::uint64_t begin = 0; begin < segment.length; begin += step) {
        if (begin > 0) kernel.step();
        const std::uint64_t span = std::min(step, segment.length - begin);
        for (int i = 0; i < 24; ++i) {
            const std::uint64_t sigma = i == 0 ? span - 1 : random() % span;
            hls::Word<C::kFineBits> out[C::kAxes];
            kernel.sample(static_cast<std::int64_t>(sigma), out);
            const double s = static_cast<double>(begin + sigma) / 65536;
            const ref::Vec3 exact = ref::exact_position(segment, s);
            for (std::size_t axis = 0; axis < C::kAxes; ++axis) {
                const double truth =
                    axis < 3 ? exact[static_cast<int>(axis)] : ref::exact_aux(segment, axis - 3, s);
                const double got =
                    std::ldexp(static_cast<double>(hls::to_int(out[axis])), -C::kGuardBits);
                worst = std::max(worst, std::abs(got - truth));
            }
        }
    }
    return worst;
}

ref::Machine wide_machine() {
    ref::Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.min = -1e5;
        axis.max = 1e5;
    }
    return machine;
}

struct Sizes {
    double low, high;
};

struct Worst {
    double error = 0;
    double bound = 0;
    int beyond = 0;  // segments whose error is beyond their bound
};

/// Programs of one move each: kind 0 lines, 1 arcs, 2 helices; lengths or radii within `size`, mm.
template <class C, class Spoil>
Worst measure(int kind, int programs, Sizes sizes, double limit, Spoil spoil) {
    std::mt19937_64 random(2024 + static_cast<unsigned>(kind));
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const auto direction = [&] {
        return ref::Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
    };
    ref::PlanOptions options;
    options.format = parameters_of<C>();
    options.error_limit = limit;
    Worst worst;
    for (int i = 0; i < programs; ++i) {
        ProgramBuilder builder;
        const double part = i % 7 == 0 ? 1 : uniform(0, 1);
        const double size = sizes.low * std::pow(sizes.high / sizes.low, part);
        // Curves about the origin keep positions within their words.
        const ref::Vec3 normal = i % 3 == 0 ? ref::Vec3::UnitZ() : direction();
        const ref::Vec3 arm = normal.cross(direction()).normalized() * size;
        ref::Program& program = builder.program();
        if (kind == 0) {
            builder.line(direction() * size, 100);
        } else {
            builder.line(arm, 100);
            builder.arc({0, 0, 0}, normal, uniform(0.01, 6), kind == 2 ? uniform(-1, 1) * size : 0,
                        100);
            program.moves.erase(program.moves.begin());
        }
        const ref::Plan plan = make_plan(program, wide_machine(), options);
        for (std::size_t k = 0; k < plan.segments.size(); k += 1 + plan.segments.size() / 40) {
            const ref::Segment& segment = plan.segments[k];
            const double error = worst_error<C>(segment, random, spoil);
            worst.error = std::max(worst.error, error);
            worst.bound = std::max(worst.bound, segment.bound);
            if (error > segment.bound) ++worst.beyond;
            EXPECT_LE(segment.bound, limit);
            EXPECT_LE(ref::segment_bound(options.format, segment), segment.bound * (1 + 1e-9));
        }
    }
    return worst;
}

/// Each decade is checked alone: an idle bound in one would be hidden by the others.
template <class C>
void expect_tight(double largest, double limit, int programs, double factor = 8) {
    const auto honest = [](hls::SegmentWords<C>&) {};
    double loosest = 0;
    for (double low = 0.01; low < largest * 0.999; low *= 10) {
        const Sizes sizes{low, std::min(10 * low, largest)};
        for (int kind = 0; kind < 3; ++kind) {
            const Worst worst = measure<C>(kind, programs, sizes, limit, honest);
            EXPECT_EQ(worst.beyond, 0) << "kind " << kind << " from " << low << " mm";
            EXPECT_LE(worst.bound, factor * worst.error)
                << "kind " << kind << " from " << low << " mm";
            loosest = std::max(loosest, worst.bound / worst.error);
        }
    }
    testing::Test::RecordProperty("bound_over_worst", std::to_string(loosest));
}

template <int P, int W, int G, SamplerMode Mode = SamplerMode::kSeries>
using Core = hls::Configuration<P, W, 32, G, 0, Mode>;

TEST(ErrorBound, CoversAndIsTightAtTheDefault) {
    expect_tight<hls::DefaultConfiguration>(1000, 0.1, cases(40, 100));
}
TEST(ErrorBound, CoversAndIsTightInPolynomialMode) {
    expect_tight<Core<6, 36, 10, SamplerMode::kPolynomial>>(1000, 0.1, cases(30, 50));
}
TEST(ErrorBound, CoversAndIsTightAtOrder2) { expect_tight<Core<2, 36, 10>>(100, 0.1, 30); }
TEST(ErrorBound, CoversAndIsTightAtOrder3Polynomial) {
    expect_tight<Core<3, 36, 10, SamplerMode::kPolynomial>>(100, 0.1, 30);
}
TEST(ErrorBound, CoversAndIsTightAtOrder8) {
    expect_tight<Core<8, 36, 10>>(1000, 0.1, cases(30, 60));
}
// A segment has some hundred independent roundings: their worst case is far from the usual sum.
TEST(ErrorBound, CoversAtOrder12) { expect_tight<Core<12, 36, 12>>(1000, 0.1, cases(30, 60), 16); }
TEST(ErrorBound, CoversAndIsTightAt28Bits) { expect_tight<Core<6, 28, 10>>(100, 0.1, 30); }
TEST(ErrorBound, CoversAndIsTightAt18Bits) { expect_tight<Core<4, 18, 4>>(0.3, 0.2, 40); }

// Controls: a core that is worse than its words must leave the bound.
TEST(ErrorBound, IsLeftByACoreOfALowerOrder) {
    std::mt19937_64 random(1);
    ProgramBuilder builder;
    builder.arc({25, 0, 0}, {0, 0, 1}, 6, 0, 100);
    const ref::Plan plan = make_plan(builder.program(), wide_machine(), {});
    const auto honest = [](auto&) {};
    EXPECT_LE(worst_error<hls::DefaultConfiguration>(plan.segments[0], random, honest),
              plan.segments[0].bound);
    using Lower = Core<5, 36, 10>;
    EXPECT_GT(worst_error<Lower>(plan.segments[0], random, honest), plan.segments[0].bound);
}
TEST(ErrorBound, IsLeftByWrongLastBits) {
    const auto spoil = [](hls::SegmentWords<hls::DefaultConfiguration>& words) {
        words.theta += 16;
        words.advance[0] += 16;
    };
    for (int kind = 0; kind < 3; ++kind) {
        EXPECT_GT(measure<hls::DefaultConfiguration>(kind, 40, {0.01, 1000}, 0.1, spoil).beyond, 0);
    }
}

TEST(ErrorBound, GrowsWithLengthAndShrinksWithWidth) {
    ref::Segment segment;
    segment.curve = ref::ArcPiece{{0, 1, 0}, {1, 0, 0}, 1, 25e6};
    segment.step_exponent = 23;
    segment.length = std::uint64_t{20} << 39;
    const ref::CoreParameters format;
    const double bound = ref::segment_bound(format, segment);
    ref::Segment longer = segment;
    longer.length *= 2;
    EXPECT_GT(ref::segment_bound(format, longer), bound);
    ref::CoreParameters narrow = format;
    narrow.coef_bits = 32;
    EXPECT_GT(ref::rounding_bound(narrow, segment), 8 * ref::rounding_bound(format, segment));
    ref::CoreParameters low = format;
    low.order = 5;
    EXPECT_GT(ref::truncation_bound(low, segment), 10 * ref::truncation_bound(format, segment));
}

}  // namespace curvecore::tb::error_bound_test
