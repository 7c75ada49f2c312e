// SPDX-License-Identifier: Apache-2.0
// rtl/spherical_interpolator.sv equals hls::InterpolatorKernel, bit for bit; throughput and
// latency.
#include "tb/support/bench/curve_core_bench.hpp"

namespace curvecore::tb {
namespace {

class SphericalInterpolator : public CurveCoreBench<LegalSegments, 20> {
  protected:
    const hls::TimedCore timed_ = timed(Build::kParallel, true, false);
    const hls::Clocks clocks_ = hls::arc_clocks(timed_);
};

TEST_F(SphericalInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SphericalInterpolator, EqualsKernelOverManySamples) { Campaign(150'000, 6).run(); }

TEST_F(SphericalInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    LegalSegments shapes(core_, 5);
    Segments segments;
    for (int n = 0; n < 60; ++n) segments.push_back(shapes.whole(4, 1 + n % 2));
    gives_one_sample_per_interval(segments, std::max(clocks_.step, clocks_.segment));
}

TEST_F(SphericalInterpolator, TakesTheStatedClocksAStepAndASegment) {
    LegalSegments shapes(core_, 5);
    takes_the_stated_clocks_a_step({shapes.whole(4, 40)}, clocks_.step);
    Segments segments;
    for (int n = 0; n < 40; ++n) segments.push_back(shapes.whole(4, 1));
    takes_the_stated_clocks_a_step(segments, clocks_.segment);
}

TEST_F(SphericalInterpolator, HasTheStatedLatencies) {
    LegalSegments shapes(core_, 5);
    add(shapes.whole(6, 2));
    const size_t words = bus_.size();
    while (!bus_.empty()) clock(true, false, true);
    EXPECT_EQ(dut_.cycle(), words + 3);  // three of reset: a word a clock
    has_latency(hls::sample_latency(timed_), clocks_.step);
}

TEST_F(SphericalInterpolator, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(SphericalInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
