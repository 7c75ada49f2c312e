// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator_serial.sv equals hls::InterpolatorKernel, bit for bit; clocks per
// sample, and of the pauses between steps and segments.
#include <algorithm>

#include "Vcurve_interpolator_serial.h"
#include "tb/support/curve_core_bench.hpp"
#include "tb/support/serial_clocks.hpp"

namespace curvecore::tb {
namespace {

constexpr SerialClocks kClocks =
    serial_clocks(Config::kOrder, Config::kAuxAxes, CFG_Mode == 0, false);

using SphericalInterpolatorSerial = CurveCoreBench<Vcurve_interpolator_serial>;

TEST_F(SphericalInterpolatorSerial, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SphericalInterpolatorSerial, HoldsItsSampleWhileStalled) {
    holds_its_sample_while_stalled();
}

TEST_F(SphericalInterpolatorSerial, GivesSamplesOfAStepInTheStatedClocks) {
    constexpr uint64_t kSamples = 60;
    for (int exponent = 0; exponent <= hls::kMaxStepExponent; ++exponent) {
        LegalSegments<Config> shapes(5);
        EXPECT_LE(clocks_within_a_step(shapes.whole(exponent, 1), kSamples),
                  kSamples * kClocks.sample)
            << exponent;
    }
}

TEST_F(SphericalInterpolatorSerial, PausesBetweenStepsAndSegmentsAsStated) {
    Pauses pauses;
    for (int exponent = 0; exponent <= std::min(hls::kMaxStepExponent, Config::kPositionBits - 7);
         ++exponent) {
        LegalSegments<Config> shapes(5);
        std::vector<hls::SegmentWords<Config>> segments;
        for (int n = 0; n < 8; ++n) segments.push_back(shapes.whole(exponent, 2));
        measure(segments, 1 + exponent % 4, pauses);
    }
    EXPECT_LE(pauses.step, static_cast<uint64_t>(kClocks.step));
    EXPECT_LE(pauses.segment, static_cast<uint64_t>(kClocks.segment));
    EXPECT_GE(pauses.step, static_cast<uint64_t>(kClocks.step) * 8 / 10);
    EXPECT_GE(pauses.segment, static_cast<uint64_t>(kClocks.segment) * 8 / 10);
}

TEST_F(SphericalInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
