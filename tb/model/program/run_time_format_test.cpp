// SPDX-License-Identifier: Apache-2.0
// Formats with widths at run time: a kernel gives the same words as with widths of its type. Bus
// words of segments, and positions of seeded streams of arcs, helices, lines and splines, at the
// edges of every parameter.
#include <gtest/gtest.h>

#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/segments/mixed_segments.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace curvecore::tb::run_time_format_test {
using namespace sysc;

using hls::SamplerMode;

template <class C>
using BusWords = std::array<std::uint64_t, ref::segment_bus_words(C::kAuxAxes)>;

template <class C, class Format>
BusWords<C> packed(const hls::SegmentWords<Format>& segment, const Format& format) {
    BusWords<C> bus;
    hls::pack(segment, 7, bus.data(), format);
    return bus;
}

/// A segment in words of the type's widths.
template <class C>
hls::SegmentWords<C> typed(const RunSegment& segment, const RunTimeFormat& format) {
    const BusWords<C> bus = packed<C>(segment, format);
    return hls::unpack_segment<C>([next = bus.begin()]() mutable { return *next++; });
}

template <class C>
void draws_the_same_samples() {
    MixedSegments random(parameters_of<C>(), 5);
    std::vector<hls::SegmentWords<C>> words;
    std::vector<RunSegment> segments;
    const RunTimeFormat format(parameters_of<C>(), C::kAxes);
    std::int64_t length = 0;
    while (words.size() < 400) {
        segments.push_back(random.next());
        words.push_back(typed<C>(segments.back(), format));
        length += words.back().length;
    }
    RunTimeKernel run(format);
    std::size_t run_next = 0;
    hls::MotionKernel<C> kernel;
    std::size_t next = 0;
    std::mt19937_64 engine(1);
    std::int64_t walked = 0;
    int samples = 0;
    while (walked < length) {
        // Increments from a quantum to many steps, and exactly onto segments' ends.
        std::int64_t ds = std::int64_t(engine() >> (engine() % 40 + 24)) % (length / 300);
        if (engine() % 8 == 0 && next > 0) {
            std::int64_t end = 0;
            for (std::size_t i = 0; i < next; ++i) end += words[i].length;
            ds = end - walked;
        }
        ds = std::min(ds, length - walked);
        walked += ds;
        hls::Word<C::kFineBits> expected[C::kAxes];
        std::int64_t got[kMostAxes];
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

/// Pieces of a plan: the same words from the same real numbers.
template <class C>
void loads_the_same_words() {
    const RunTimeFormat format(parameters_of<C>(), C::kAxes);
    SplineMaker maker(2);
    std::vector<ref::Segment> segments =
        ref::split_spline(maker.next({"", SplineShape::kRandom, 20e3}), parameters_of<C>(), 400);
    ref::Segment arc;
    ref::ArcPiece& piece = arc.arc();
    arc.length = 1000 * 65536 + 3;
    arc.start = ref::Vec3(1.25, -7.1, 100.3);
    arc.end = ref::Vec3(-1.7, 1000.5, 0);
    piece.normal = ref::Vec3(1, 2, -2) / 3;
    piece.tangent = ref::Vec3(2, 1, 2) / 3;
    piece.cos_pitch = 0.8;
    piece.radius = 1234.5;
    piece.advance = 0.6 * piece.normal.cross(piece.tangent);
    arc.aux_start.fill(-3.3);
    arc.aux_advance.fill(0.7);
    arc.step_exponent = 8;
    segments.push_back(arc);
    for (ref::Segment& segment : segments) {
        for (ref::Vec3* point : {&segment.start, &segment.end}) {
            *point *= std::ldexp(1.0, C::kPositionBits - 33);  // a quarter of the range
        }
        EXPECT_EQ(packed<C>(hls::to_words(segment, format), format),
                  packed<C>(hls::to_words<C>(segment), C()));
    }
    EXPECT_GT(segments.size(), 1U);
}

/// The tests of one configuration.
struct Typed {
    int order;
    int coef_bits;
    void (*draws)();
    void (*loads)();
};

template <int P, int W, int G, SamplerMode Mode, bool Anchor, int Position = 32, int Aux = 0,
          int Guard = 0>
constexpr Typed core() {
    using C = hls::Configuration<P, W, Position, G, Aux, Mode, Anchor, Guard>;
    return {P, W, draws_the_same_samples<C>, loads_the_same_words<C>};
}
constexpr SamplerMode kSer = SamplerMode::kSeries;
constexpr SamplerMode kPol = SamplerMode::kPolynomial;

class RunTimeFormatOf : public testing::TestWithParam<Typed> {};

INSTANTIATE_TEST_SUITE_P(
    Cores, RunTimeFormatOf,
    testing::Values(core<2, 18, 2, kSer, true>(), core<2, 36, 12, kPol, true>(),
                    core<3, 27, 4, kSer, false>(), core<4, 20, 8, kPol, true, 24, 0, 8>(),
                    core<6, 36, 10, kPol, false>(), core<8, 30, 10, kSer, true, 32, 6>(),
                    core<12, 31, 9, kSer, true, 32, 1>(), core<12, 36, 12, kPol, true>()),
    [](const auto& tested) {
        return "order_" + std::to_string(tested.param.order) + "_coef_" +
               std::to_string(tested.param.coef_bits);
    });

TEST_P(RunTimeFormatOf, DrawsTheSameSamples) { GetParam().draws(); }

TEST_P(RunTimeFormatOf, LoadsTheSameWords) { GetParam().loads(); }

}  // namespace curvecore::tb::run_time_format_test
