// SPDX-License-Identifier: Apache-2.0
// rtl/curve_interpolator_serial.sv with Splines equals hls::MotionKernel, bit for bit, over
// chains of lines, arcs and splines; clocks of a spline's samples, steps and segments.
#include <algorithm>

#include "Vcurve_interpolator_serial.h"
#include "hls/curve_kernel.hpp"
#include "tb/support/curve_core_bench.hpp"
#include "tb/support/mixed_segments.hpp"
#include "tb/support/serial_clocks.hpp"

namespace curvecore::tb {
namespace {

constexpr SerialClocks kClocks =
    serial_clocks(Config::kOrder, Config::kAuxAxes, CFG_Mode == 0, true);

using CurveInterpolatorSerial =
    CurveCoreBench<Vcurve_interpolator_serial, hls::CurveKernel<Config>, MixedSegments<Config>, 6>;

TEST_F(CurveInterpolatorSerial, EqualsKernelAtFullSpeedAndWithRandomStalls) {
    equals_kernel_with_random_stalls();
}

/// Splines whose steps are shorter than the planner would take them, 2^0 to 2^k units: the scales
/// 2^-(lambda - k) of every size.
TEST_F(CurveInterpolatorSerial, DrawsStepsOfAnyLength) {
    SplineSegments<Config> shapes(5);
    for (int n = 0; n < 200; ++n) {
        hls::SegmentWords<Config> words = shapes.next();
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
    constexpr uint64_t kSamples = 60;
    SplineSegments<Config> shapes(5);
    EXPECT_LE(clocks_within_a_step(shapes.whole(0, 1), kSamples), kSamples * kClocks.sample);
}

TEST_F(CurveInterpolatorSerial, PausesBetweenStepsAndSegmentsAsStated) {
    Pauses pauses;
    SplineSegments<Config> shapes(5);
    for (int exponent = 0; exponent <= 10; ++exponent) {
        hls::SegmentWords<Config> words = shapes.whole(exponent, 2);
        words.step_exponent = exponent;
        words.length = int64_t{2} << (exponent + hls::kPathFrac);
        measure(std::vector<hls::SegmentWords<Config>>(8, words), 1 + exponent % 4, pauses);
    }
    EXPECT_LE(pauses.step, static_cast<uint64_t>(kClocks.step));
    EXPECT_LE(pauses.segment, static_cast<uint64_t>(kClocks.segment));
    EXPECT_GE(pauses.step, static_cast<uint64_t>(kClocks.step) * 9 / 10);
    EXPECT_GE(pauses.segment, static_cast<uint64_t>(kClocks.segment) * 9 / 10);
}

TEST_F(CurveInterpolatorSerial, HoldsItsSampleWhileStalled) { holds_its_sample_while_stalled(); }

TEST_F(CurveInterpolatorSerial, StartsAfreshAfterAReset) { starts_afresh_after_a_reset(); }

}  // namespace
}  // namespace curvecore::tb
