// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator.sv equals hls::MotionKernel, bit for bit, on segments of both kinds;
// throughput over changes of kind, and latency.
#include "Vcurve_interpolator.h"
#include "hls/curve_kernel.hpp"
#include "tb/support/curve_core_bench.hpp"
#include "tb/support/mixed_segments.hpp"

namespace curvecore::tb {
namespace {

constexpr hls::TimedCore kCore = timed_core(false, true, true);
constexpr int kStepClocks = hls::spline_clocks(kCore).segment;  // an arc's take fewer

using CurveInterpolator =
    CurveCoreBench<Vcurve_interpolator, hls::CurveKernel<Config>, MixedSegments<Config>, 6>;

TEST_F(CurveInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(CurveInterpolator, EqualsKernelOverManySamples) { Campaign(450'000, 7).run(); }

TEST_F(CurveInterpolator, GivesOneSamplePerIntervalOverChangesOfKind) {
    MixedSegments<Config> shapes(5);
    std::vector<hls::SegmentWords<Config>> segments;
    for (int n = 0; n < 30; ++n) segments.push_back(shapes.whole(10, 1 + n % 3));
    gives_one_sample_per_interval(segments, kStepClocks);
}

TEST_F(CurveInterpolator, HasTheStatedLatencyForBothKinds) {
    MixedSegments<Config> shapes(5);
    add(shapes.whole(10, 2));
    has_latency(hls::sample_latency(kCore), kStepClocks);
    start_afresh();
    add(shapes.whole(10, 2));
    has_latency(hls::sample_latency(kCore), kStepClocks);
}

TEST_F(CurveInterpolator, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(CurveInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
