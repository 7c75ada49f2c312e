// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator_serial.sv with Splines equals hls::MotionKernel, bit for bit, over
// chains of lines, arcs and splines; clocks of a spline's samples, steps and segments.
#include <algorithm>

#include "tb/support/bench/curve_core_bench.hpp"
#include "tb/support/segments/mixed_segments.hpp"

namespace curvecore::tb {
namespace {

class CurveInterpolatorSerial : public CurveCoreBench<MixedSegments, 6> {
  protected:
    const hls::Clocks clocks_ = hls::spline_clocks(timed(Build::kSerial, true, true));
};

TEST_F(CurveInterpolatorSerial, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

TEST_F(CurveInterpolatorSerial, EqualsKernelOverManySamples) { Campaign(50'000, 6).run(); }

/// Splines whose steps are shorter than the planner would make them, 2^0 to 2^k units: the scales
/// 2^-(lambda - k) of every size.
TEST_F(CurveInterpolatorSerial, DrawsStepsOfAnyLength) {
    SplineSegments shapes(core_, 5);
    for (int n = 0; n < 200; ++n) {
        RunSegment words = shapes.next();
        words.step_exponent %= 1 + n % 20;
        words.length = std::min<int64_t>(words.length,
                                         int64_t{5} << (words.step_exponent + hls::kPathFrac - 1));
        add(words);
        for (int64_t left = words.length, part = 5; part > 0; --part) {
            requests_.push_back(left / part);
            expected_.push_back(predict(left / part, [&] { add(shapes.next()); }));
            left -= left / part;
        }
        ASSERT_NO_FATAL_FAILURE(drain([] { return true; })) << n;
    }
}

TEST_F(CurveInterpolatorSerial, GivesSamplesOfAStepInTheStatedClocks) {
    uint64_t most = 0;
    for (int exponent = 0; exponent <= hls::kMaxStepExponent; ++exponent) {
        SplineSegments shapes(core_, 5);
        RunSegment words = shapes.whole(0, 1);
        words.step_exponent = exponent;
        words.length = int64_t{1} << (exponent + hls::kPathFrac);
        most = std::max(most, clocks_within_a_step(words, kSamples));
    }
    reaches(most, kSamples * clocks_.sample, kSamples * 3);
}

TEST_F(CurveInterpolatorSerial, PausesBetweenStepsAndSegmentsAsStated) {
    Pauses pauses;
    SplineSegments shapes(core_, 5);
    for (int exponent = 0; exponent <= 10; ++exponent) {
        for (int samples_log2 = 1; samples_log2 <= 4; ++samples_log2) {
            RunSegment words = shapes.whole(exponent, 2);
            words.step_exponent = exponent;
            words.length = int64_t{2} << (exponent + hls::kPathFrac);
            measure(Segments(8, words), samples_log2, pauses);
        }
    }
    reaches(pauses.step, clocks_.step, 13);
    reaches(pauses.segment, clocks_.segment, 15);
}

TEST_F(CurveInterpolatorSerial, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(CurveInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
