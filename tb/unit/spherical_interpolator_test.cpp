// SPDX-License-Identifier: Apache-2.0
// rtl/spherical_interpolator.sv equals hls::InterpolatorKernel, bit for bit; throughput and
// latency.
#include "Vspherical_interpolator.h"
#include "tb/support/arc_core_bench.hpp"

namespace curvecore::tb {
namespace {

constexpr int kInterval = CFG_SampleInterval;

// As stated in the headers of the RTL.
constexpr int kDigits = (Config::kCoefBits + 1) / 2;
constexpr int kStepClocks = Config::kOrder * (kDigits + 3) + 7;
constexpr int kLoadClocks = 18 + 3 * Config::kAuxAxes;
constexpr int kStepSamples =
    (std::max(kStepClocks, kLoadClocks) + kInterval - 1) / kInterval;  // for full rate
constexpr int kLoop = kInterval == 1 ? 6 : kInterval == 2 ? 7 : 9;
constexpr int horner_clocks(int passes) { return passes * kLoop + (kInterval == 1 ? 1 : 0); }
constexpr int kSamplerClocks = CFG_Mode == 0
                                   ? horner_clocks(Config::kOrder)
                                   : horner_clocks(Config::kOrder / 2) + (kInterval == 2 ? 19 : 18);
constexpr int kLatency = 12 + 3 * kInterval + kSamplerClocks;

using SphericalInterpolator = ArcCoreBench<Vspherical_interpolator>;

TEST_F(SphericalInterpolator, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SphericalInterpolator, GivesOneSamplePerIntervalWhileStepsHoldTheNetworksLatency) {
    constexpr int kSteps = 60;
    LegalSegments<Config> shapes(5);
    for (int n = 0; n < kSteps; ++n) add(shapes.whole(4, 1 + n % 2));
    const int64_t ds = (int64_t{1} << (4 + hls::kPathFrac)) / kStepSamples;
    const auto count = static_cast<int64_t>(kSteps) * kStepSamples;
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

TEST_F(SphericalInterpolator, HasTheStatedLatencies) {
    LegalSegments<Config> shapes(5);
    add(shapes.whole(6, 2));
    const size_t words = bus_.size();
    while (!bus_.empty()) clock(true, false, true);
    EXPECT_EQ(dut_.cycle(), words + 2);  // two of reset: a word a clock
    for (int n = 0; n < 2 * kStepClocks; ++n) clock(true, false, true);
    for (int n = 0; n < 20; ++n) {
        requests_.push_back(1000);
        expected_.push_back(predict(1000, [] { FAIL(); }));
        while (!expected_.empty()) clock(true, true, true);
        const auto latency = static_cast<int>(last_sample_ - last_request_);
        EXPECT_GE(latency, kLatency);
        EXPECT_LT(latency, kLatency + kInterval);
    }
}

TEST_F(SphericalInterpolator, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(SphericalInterpolator, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
