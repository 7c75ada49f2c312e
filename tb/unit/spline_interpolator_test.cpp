// SPDX-License-Identifier: Apache-2.0
// rtl/spline_interpolator.sv equals hls::InterpolatorKernel with hls::SplineKernel, bit for bit;
// throughput and latency.
#include "Vspline_interpolator.h"
#include "hls/spline_kernel.hpp"
#include "tb/support/arc_core_bench.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {
namespace {

constexpr int kInterval = CFG_SampleInterval;
constexpr int kOrder = Config::kOrder;

// As stated in the headers of the RTL.
constexpr int kDigits = (Config::kCoefBits + 1) / 2;
constexpr int kTop = Config::kAnchor ? kOrder - 1 : kOrder;
constexpr int kStepClocks = 94 + 9 * kTop * (kTop + 1) / 2 + 27 * kTop + 12 * kOrder + 55 + kDigits;
constexpr int kLoop = kInterval == 1 ? 6 : kInterval == 2 ? 7 : 9;
constexpr int horner_clocks(int passes) { return passes * kLoop + (kInterval == 1 ? 1 : 0); }
constexpr int kSamplerClocks = horner_clocks(kOrder) + (CFG_Mode == 0 ? 0 : horner_clocks(3));
constexpr int kLatency = 12 + 3 * kInterval + kSamplerClocks;

using SplineInterpolator =
    ArcCoreBench<Vspline_interpolator, hls::SplineKernel<Config>, SplineSegments<Config>, 6>;

TEST_F(SplineInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SplineInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    constexpr int kStepSamples = (kStepClocks + kInterval - 1) / kInterval;
    SplineSegments<Config> shapes(5);
    const hls::SegmentWords<Config> segment = shapes.whole(10, 40);
    add(segment);
    const int64_t ds = (int64_t{1} << (segment.step_exponent + hls::kPathFrac)) / kStepSamples;
    const int64_t count = segment.length / ds;
    for (int64_t n = 0; n < count; ++n) {
        requests_.push_back(ds);
        expected_.push_back(predict(ds, [] { FAIL(); }));
    }
    for (int n = 0; n < 8 * kStepClocks; ++n) clock(true, false, true);  // steps ahead
    while (compared_ == 0) clock(true, true, true);
    const uint64_t first = dut_.cycle();
    while (!expected_.empty() && !HasFatalFailure()) clock(true, true, true);
    EXPECT_EQ(dut_.cycle() - first, static_cast<uint64_t>((count - 1) * kInterval));
}

TEST_F(SplineInterpolator, HasTheStatedLatency) {
    SplineSegments<Config> shapes(5);
    add(shapes.whole(10, 2));
    for (int n = 0; n < 8 * kStepClocks; ++n) clock(true, false, true);
    for (int n = 0; n < 20; ++n) {
        requests_.push_back(10);
        expected_.push_back(predict(10, [] { FAIL(); }));
        while (!expected_.empty()) clock(true, true, true);
        const auto latency = static_cast<int>(last_sample_ - last_request_);
        EXPECT_GE(latency, kLatency);
        EXPECT_LT(latency, kLatency + kInterval);
    }
}

TEST_F(SplineInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
