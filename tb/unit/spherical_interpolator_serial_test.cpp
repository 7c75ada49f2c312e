// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator_serial.sv equals hls::InterpolatorKernel, bit for bit; clocks per
// sample, and of the pauses between steps and segments.
#include <algorithm>

#include "Vcurve_interpolator_serial.h"
#include "tb/support/curve_core_bench.hpp"

namespace curvecore::tb {
namespace {

// As stated in the header of the RTL.
constexpr int kAuxFrames = (Config::kAuxAxes + 2) / 3;
constexpr int kFrames = (CFG_Mode == 0 ? Config::kOrder : 4 + Config::kOrder / 2) + kAuxFrames;
constexpr int kSampleClocks = std::max({9 * (1 + kAuxFrames), 3 * (kFrames + 5), 24});
constexpr int kStepGap = 15 * Config::kOrder + 9 * kFrames + 84;
constexpr int kSegmentGap = 27 * Config::kOrder + 9 * kFrames + 3 * Config::kAuxAxes + 66 +
                            (CFG_Mode == 0 ? 0 : 11 * Config::kOrder + 24);

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
                  kSamples * kSampleClocks)
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
    EXPECT_LE(pauses.step, static_cast<uint64_t>(kStepGap));
    EXPECT_LE(pauses.segment, static_cast<uint64_t>(kSegmentGap));
    EXPECT_GE(pauses.step, static_cast<uint64_t>(kStepGap) * 8 / 10);
    EXPECT_GE(pauses.segment, static_cast<uint64_t>(kSegmentGap) * 8 / 10);
}

TEST_F(SphericalInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
