// SPDX-License-Identifier: Apache-2.0
// rtl/spline_interpolator.sv equals hls::InterpolatorKernel with hls::SplineKernel, bit for bit;
// throughput and latency.
#include "Vspline_interpolator.h"
#include "hls/spline_kernel.hpp"
#include "tb/support/core_timing.hpp"
#include "tb/support/curve_core_bench.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {
namespace {

using SplineInterpolator =
    CurveCoreBench<Vspline_interpolator, hls::SplineKernel<Config>, SplineSegments<Config>, 6>;

TEST_F(SplineInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SplineInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    SplineSegments<Config> shapes(5);
    gives_one_sample_per_interval({shapes.whole(10, 40)}, samples_of(kSplineStepClocks),
                                  kSplineStepClocks);
}

TEST_F(SplineInterpolator, HasTheStatedLatency) {
    SplineSegments<Config> shapes(5);
    add(shapes.whole(10, 2));
    has_latency(sample_latency(kSplines), kSplineStepClocks);
}

TEST_F(SplineInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
