// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator.sv equals hls::MotionKernel, bit for bit, on segments of both kinds;
// throughput over changes of kind, and latency.
#include "tb/support/bench/curve_core_bench.hpp"
#include "tb/support/segments/mixed_segments.hpp"

namespace curvecore::tb {
namespace {

class CurveInterpolator : public CurveCoreBench<MixedSegments, 6> {
  protected:
    const hls::TimedCore timed_ = timed(Build::kParallel, true, true);
    const int step_clocks_ = hls::spline_clocks(timed_).segment;  // arcs take fewer
};

TEST_F(CurveInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(CurveInterpolator, EqualsKernelOverManySamples) { Campaign(100'000, 7).run(); }

TEST_F(CurveInterpolator, GivesOneSamplePerIntervalOverChangesOfKind) {
    MixedSegments shapes(core_, 5);
    Segments segments;
    for (int n = 0; n < 30; ++n) segments.push_back(shapes.whole(10, 1 + n % 3));
    gives_one_sample_per_interval(segments, step_clocks_);
}

TEST_F(CurveInterpolator, HasTheStatedLatencyForBothKinds) {
    MixedSegments shapes(core_, 5);
    add(shapes.whole(10, 2));
    has_latency(hls::sample_latency(timed_), step_clocks_);
    start_afresh();
    add(shapes.whole(10, 2));
    has_latency(hls::sample_latency(timed_), step_clocks_);
}

TEST_F(CurveInterpolator, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(CurveInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
