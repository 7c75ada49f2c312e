// SPDX-License-Identifier: Apache-2.0
// Speed of the spline kernel on one core, in a stream of both kinds of segments. Rates are samples
// per second.
#include <benchmark/benchmark.h>

#include <vector>

#include "hls/curve_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/segment/spline_segment.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace {

using namespace curvecore;

/// Pieces of a cubic of some 50 mm with an S bend, repeated; steps of about 1 mm.
template <class C>
std::vector<hls::SegmentWords<C>> pieces() {
    const double mm = 1e6;
    const ref::Cubic cubic =
        ref::from_bezier({ref::Vec3(0, 0, 0), ref::Vec3(30, 0, 5) * mm, ref::Vec3(0, 30, 5) * mm,
                          ref::Vec3(30, 30, 0) * mm});
    const ref::CoreParameters format = tb::parameters_of<C>();
    std::vector<hls::SegmentWords<C>> words;
    for (const ref::Segment& segment : ref::split_spline(cubic, format, 0.1)) {
        words.push_back(hls::to_words<C>(segment));
    }
    return words;
}

template <class C>
void samples(benchmark::State& state) {
    const std::vector<hls::SegmentWords<C>> words = pieces<C>();
    std::int64_t path = 0;
    double steps = 0;
    for (const auto& segment : words) {
        path += segment.length;
        steps += std::ceil(std::ldexp(static_cast<double>(segment.length),
                                      -segment.step_exponent - hls::kPathFrac));
    }
    const auto ds = static_cast<std::int64_t>(static_cast<double>(path) / steps /
                                              static_cast<double>(state.range(0)));
    hls::MotionKernel<C> kernel;
    std::size_t next = 0;
    for (auto _ : state) {
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            ds, [&]() -> const hls::SegmentWords<C>& { return words[next++ % words.size()]; },
            fine);
        benchmark::DoNotOptimize(fine);
    }
    state.SetItemsProcessed(state.iterations());
}

template <hls::SamplerMode Mode>
using Core = hls::Configuration<6, 36, 32, 10, 0, Mode>;

BENCHMARK(samples<Core<hls::SamplerMode::kPolynomial>>)
    ->Name("spline_polynomial/samples_per_step")
    ->Arg(1024)
    ->Arg(64)
    ->Arg(1);
BENCHMARK(samples<Core<hls::SamplerMode::kSeries>>)
    ->Name("spline_series/samples_per_step")
    ->Arg(1024)
    ->Arg(64)
    ->Arg(1);

}  // namespace

BENCHMARK_MAIN();
