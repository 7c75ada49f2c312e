// SPDX-License-Identifier: Apache-2.0
// rtl/spherical_interpolator.sv equals hls::InterpolatorKernel, bit for bit; throughput and
// latency.
#include "Vspherical_interpolator.h"
#include "tb/support/curve_core_bench.hpp"

namespace curvecore::tb {
namespace {

constexpr hls::TimedCore kCore = timed_core(false, true, false);
constexpr hls::Clocks kClocks = hls::arc_clocks(kCore);

using SphericalInterpolator = CurveCoreBench<Vspherical_interpolator>;

TEST_F(SphericalInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SphericalInterpolator, EqualsKernelOverManySamples) { Campaign(500'000, 6).run(); }

TEST_F(SphericalInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    LegalSegments<Config> shapes(5);
    std::vector<hls::SegmentWords<Config>> segments;
    for (int n = 0; n < 60; ++n) segments.push_back(shapes.whole(4, 1 + n % 2));
    gives_one_sample_per_interval(segments, std::max(kClocks.step, kClocks.segment));
}

TEST_F(SphericalInterpolator, TakesTheStatedClocksAStepAndASegment) {
    LegalSegments<Config> shapes(5);
    takes_the_stated_clocks_a_step({shapes.whole(4, 40)}, kClocks.step);
    std::vector<hls::SegmentWords<Config>> segments;
    for (int n = 0; n < 40; ++n) segments.push_back(shapes.whole(4, 1));
    takes_the_stated_clocks_a_step(segments, kClocks.segment);
}

TEST_F(SphericalInterpolator, HasTheStatedLatencies) {
    LegalSegments<Config> shapes(5);
    add(shapes.whole(6, 2));
    const size_t words = bus_.size();
    while (!bus_.empty()) clock(true, false, true);
    EXPECT_EQ(dut_.cycle(), words + 3);  // three of reset: a word a clock
    has_latency(hls::sample_latency(kCore), kClocks.step);
}

#if CFG_Order == 2  // one is enough
TEST_F(SphericalInterpolator, Counts65535EmptySegments) { counts_65535_empty_segments(); }
#endif

TEST_F(SphericalInterpolator, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(SphericalInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
