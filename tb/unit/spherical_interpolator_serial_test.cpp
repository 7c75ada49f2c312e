// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator_serial.sv equals hls::InterpolatorKernel, bit for bit; clocks per
// sample, and of the pauses between steps and segments.
#include <algorithm>

#include "Vcurve_interpolator_serial.h"
#include "tb/support/curve_core_bench.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr hls::Clocks kClocks = hls::arc_clocks(timed_core(true, true, CFG_Splines != 0));

using SphericalInterpolatorSerial = CurveCoreBench<Vcurve_interpolator_serial>;

TEST_F(SphericalInterpolatorSerial, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SphericalInterpolatorSerial, EqualsKernelOverManySamples) { Campaign(200'000, 6).run(); }

TEST_F(SphericalInterpolatorSerial, HoldsItsSampleWhileStalled) {
    holds_its_sample_while_stalled();
}

TEST_F(SphericalInterpolatorSerial, GivesSamplesOfAStepInTheStatedClocks) {
    uint64_t most = 0;
    for (int exponent = 0; exponent <= hls::kMaxStepExponent; ++exponent) {
        LegalSegments<Config> shapes(5);
        most = std::max(most, clocks_within_a_step(shapes.whole(exponent, 1), kSamples));
    }
    reaches(most, kSamples * kClocks.sample, kSamples * 3);
}

TEST_F(SphericalInterpolatorSerial, PausesBetweenStepsAndSegmentsAsStated) {
    Pauses pauses;
    for (int exponent = 0; exponent <= std::min(hls::kMaxStepExponent, Config::kPositionBits - 7);
         ++exponent) {
        for (int samples_log2 = 1; samples_log2 <= 4; ++samples_log2) {
            LegalSegments<Config> shapes(5);
            std::vector<hls::SegmentWords<Config>> segments;
            for (int n = 0; n < 8; ++n) segments.push_back(shapes.whole(exponent, 2));
            measure(segments, samples_log2, pauses);
        }
    }
    EXPECT_EQ(pauses.step, static_cast<uint64_t>(kClocks.step));
    reaches(pauses.segment, kClocks.segment, 2 * hls::kRotation);
}

TEST_F(SphericalInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
