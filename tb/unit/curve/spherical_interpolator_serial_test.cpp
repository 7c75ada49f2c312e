// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator_serial.sv equals hls::InterpolatorKernel, bit for bit; clocks per
// sample, and of the pauses between steps and segments.
#include <algorithm>

#include "tb/support/bench/curve_core_bench.hpp"

namespace curvecore::tb {
namespace {

class SphericalInterpolatorSerial : public CurveCoreBench<LegalSegments, 20> {
  protected:
    const hls::Clocks clocks_ = hls::arc_clocks(timed(Build::kSerial, true, core_.splines != 0));
};

TEST_F(SphericalInterpolatorSerial, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(SphericalInterpolatorSerial, EqualsKernelOverManySamples) { Campaign(50'000, 6).run(); }

TEST_F(SphericalInterpolatorSerial, HoldsItsSampleWhileStalled) {
    holds_its_sample_while_stalled();
}

TEST_F(SphericalInterpolatorSerial, GivesSamplesOfAStepInTheStatedClocks) {
    uint64_t most = 0;
    for (int exponent = 0; exponent <= hls::kMaxStepExponent; ++exponent) {
        LegalSegments shapes(core_, 5);
        most = std::max(most, clocks_within_a_step(shapes.whole(exponent, 1), kSamples));
    }
    reaches(most, kSamples * clocks_.sample, kSamples * 3);
}

TEST_F(SphericalInterpolatorSerial, PausesBetweenStepsAndSegmentsAsStated) {
    Pauses pauses;
    for (int exponent = 0; exponent <= std::min(hls::kMaxStepExponent, core_.position_bits - 7);
         ++exponent) {
        for (int samples_log2 = 1; samples_log2 <= 4; ++samples_log2) {
            LegalSegments shapes(core_, 5);
            Segments segments;
            for (int n = 0; n < 8; ++n) segments.push_back(shapes.whole(exponent, 2));
            measure(segments, samples_log2, pauses);
        }
    }
    const auto late =
        static_cast<uint64_t>(hls::late_clocks(timed(Build::kSerial, true, core_.splines != 0)));
    reaches(pauses.step, clocks_.step, late);
    reaches(pauses.segment, clocks_.segment, 2 * hls::kRotation + late);
}

TEST_F(SphericalInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
