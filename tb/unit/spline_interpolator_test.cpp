// SPDX-License-Identifier: Apache-2.0
// rtl/spline_interpolator.sv equals hls::InterpolatorKernel with hls::SplineKernel, bit for bit;
// throughput and latency.
#include "Vspline_interpolator.h"
#include "hls/spline_kernel.hpp"
#include "tb/support/curve_core_bench.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {
namespace {

constexpr hls::TimedCore kCore = timed_core(false, false, true);
constexpr hls::Clocks kClocks = hls::spline_clocks(kCore);

using SplineInterpolator =
    CurveCoreBench<Vspline_interpolator, hls::SplineKernel<Config>, SplineSegments<Config>, 6>;

TEST_F(SplineInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SplineInterpolator, EqualsKernelOverManySamples) { Campaign(450'000, 7).run(); }

TEST_F(SplineInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    SplineSegments<Config> shapes(5);
    gives_one_sample_per_interval({shapes.whole(10, 40)}, kClocks.segment);
}

TEST_F(SplineInterpolator, TakesTheStatedClocksAStepAndASegment) {
    SplineSegments<Config> shapes(5);
    takes_the_stated_clocks_a_step({shapes.whole(10, 40)}, kClocks.step);
    std::vector<hls::SegmentWords<Config>> segments;
    for (int n = 0; n < 40; ++n) segments.push_back(shapes.whole(10, 1));
    takes_the_stated_clocks_a_step(segments, kClocks.segment);
}

TEST_F(SplineInterpolator, HasTheStatedLatency) {
    SplineSegments<Config> shapes(5);
    add(shapes.whole(10, 2));
    has_latency(hls::sample_latency(kCore), kClocks.segment);
}

TEST_F(SplineInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
