// SPDX-License-Identifier: Apache-2.0
// rtl/spherical_interpolator_serial.sv equals hls::InterpolatorKernel, bit for bit; clocks per
// sample, and of the pauses between steps and segments.
#include <algorithm>

#include "Vspherical_interpolator_serial.h"
#include "tb/support/arc_core_bench.hpp"

namespace curvecore::tb {
namespace {

// As stated in the header of the RTL.
constexpr int kAuxFrames = (Config::kAuxAxes + 2) / 3;
constexpr int kFrames = (CFG_Mode == 0 ? Config::kOrder : 4 + Config::kOrder / 2) + kAuxFrames;
constexpr int kSampleClocks = std::max({9 * (1 + kAuxFrames), 3 * (kFrames + 5), 24});
constexpr int kStepGap = 15 * Config::kOrder + 9 * kFrames + 84;
constexpr int kSegmentGap = 27 * Config::kOrder + 9 * kFrames + 3 * Config::kAuxAxes + 66 +
                            (CFG_Mode == 0 ? 0 : 11 * Config::kOrder + 24);

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

/// Segments of two steps: clocks from the last sample before a change to the first one after it.
TEST_F(SphericalInterpolatorSerial, PausesBetweenStepsAndSegmentsAsStated) {
    uint64_t step_gap = 0;
    uint64_t segment_gap = 0;
    for (int exponent = 0; exponent <= std::min(hls::kMaxStepExponent, Config::kPositionBits - 7);
         ++exponent) {
        const int samples_log2 = 1 + exponent % 4;
        const int64_t per_step = 1 << samples_log2;
        const int64_t ds = int64_t{1} << (exponent + hls::kPathFrac - samples_log2);
        LegalSegments<Config> shapes(5);
        for (int n = 0; n < 8; ++n) add(shapes.whole(exponent, 2));
        for (int64_t n = 0; n < 16 * per_step; ++n) {
            requests_.push_back(ds);
            expected_.push_back(predict(ds, [] { FAIL(); }));
        }
        // A sample at the end of a step is the next step's first, but at a segment's end its last.
        uint64_t before = 0;
        for (int64_t n = 1; n <= 16 * per_step; ++n) {
            const size_t left = expected_.size();
            while (expected_.size() == left) clock(true, true, true);
            const uint64_t gap = last_sample_ - before;
            before = last_sample_;
            if (n > 1 && n % (2 * per_step) == 1) {
                segment_gap = std::max(segment_gap, gap);
            } else if (n % (2 * per_step) == per_step) {
                step_gap = std::max(step_gap, gap);
            }
        }
        start_afresh();
    }
    EXPECT_LE(step_gap, static_cast<uint64_t>(kStepGap));
    EXPECT_LE(segment_gap, static_cast<uint64_t>(kSegmentGap));
    EXPECT_GE(step_gap, static_cast<uint64_t>(kStepGap) * 8 / 10);
    EXPECT_GE(segment_gap, static_cast<uint64_t>(kSegmentGap) * 8 / 10);
}

TEST_F(SphericalInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
