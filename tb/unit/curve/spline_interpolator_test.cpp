// SPDX-License-Identifier: Apache-2.0
// rtl/spline_interpolator.sv equals hls::InterpolatorKernel with hls::SplineCurve, bit for bit;
// throughput and latency.
#include "tb/support/bench/curve_core_bench.hpp"
#include "tb/support/segments/spline_segments.hpp"

namespace curvecore::tb {
namespace {

class SplineInterpolator : public CurveCoreBench<SplineSegments, 6> {
  protected:
    const hls::TimedCore timed_ = timed(Build::kParallel, false, true);
    const hls::Clocks clocks_ = hls::spline_clocks(timed_);
};

TEST_F(SplineInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SplineInterpolator, EqualsKernelOverManySamples) { Campaign(100'000, 7).run(); }

TEST_F(SplineInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    SplineSegments shapes(core_, 5);
    gives_one_sample_per_interval({shapes.whole(10, 40)}, clocks_.segment);
}

TEST_F(SplineInterpolator, TakesTheStatedClocksAStepAndASegment) {
    SplineSegments shapes(core_, 5);
    takes_the_stated_clocks_a_step({shapes.whole(10, 40)}, clocks_.step);
    Segments segments;
    for (int n = 0; n < 40; ++n) segments.push_back(shapes.whole(10, 1));
    takes_the_stated_clocks_a_step(segments, clocks_.segment);
}

TEST_F(SplineInterpolator, HasTheStatedLatency) {
    SplineSegments shapes(core_, 5);
    add(shapes.whole(10, 2));
    has_latency(hls::sample_latency(timed_), clocks_.segment);
}

TEST_F(SplineInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
