// SPDX-License-Identifier: Apache-2.0
// rtl/spherical_interpolator_serial.sv equals hls::InterpolatorKernel, bit for bit; clocks per
// sample.
#include <algorithm>

#include "Vspherical_interpolator_serial.h"
#include "tb/support/arc_core_bench.hpp"

namespace curvecore::tb {
namespace {

// As stated in the header of the RTL.
constexpr int kAuxFrames = (Config::kAuxAxes + 2) / 3;
constexpr int kFrames = (CFG_Mode == 0 ? Config::kOrder : 4 + Config::kOrder / 2) + kAuxFrames;
constexpr int kSampleClocks = std::max({9 * (1 + kAuxFrames), 3 * (kFrames + 5), 24});

using SphericalInterpolatorSerial = ArcCoreBench<Vspherical_interpolator_serial>;

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
        add(shapes.whole(exponent, 1));
        for (uint64_t n = 0; n <= kSamples; ++n) {
            requests_.push_back(10);
            expected_.push_back(predict(10, [] { FAIL(); }));
        }
        while (expected_.size() > kSamples) clock(true, true, true);
        const uint64_t first = last_sample_;
        while (!expected_.empty()) clock(true, true, true);
        EXPECT_LE(last_sample_ - first, kSamples * kSampleClocks) << exponent;
        start_afresh();
    }
}

TEST_F(SphericalInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
