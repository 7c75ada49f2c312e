// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv against the kernels, under stalls, holds, overrides and gaps in the
// feed.
#include "tb/support/bench/motion_bench.hpp"

namespace curvecore::tb {
namespace {

TEST_F(MotionInterpolator, EqualsKernels) {
    program(pieces(1, 100, 20, 100, 3 << 16));
    fill();
    run();
    EXPECT_FALSE(dut_->underrun_o);
}

TEST_F(MotionInterpolator, EqualsKernelsWithRandomStalls) {
    for (const int stall : {20, 60, 90}) {
        program(pieces(stall, 60, 20, 60, 5 << 16));
        stall_ = stall;
        profile_stall_ = 0;
        fill();
        run();
        if (HasFatalFailure()) FAIL() << "stall " << stall << " %";
    }
}

// With and without stalls; CURVECORE_SAMPLES sets their number (scripts/campaign.sh).
TEST_F(MotionInterpolator, EqualsKernelsOverManySamples) {
    const char* const wanted = std::getenv("CURVECORE_SAMPLES");
    const std::int64_t samples = wanted != nullptr ? std::atoll(wanted) : 500;
    dut_.limit_cycles(~std::uint64_t{0});
    std::int64_t compared = 0;
    for (std::uint32_t seed = 1; compared < samples && !HasFatalFailure(); ++seed) {
        start_afresh();
        program(pieces(seed, 40, 5, 60, static_cast<std::int64_t>(seed % 8 + 1) << 16));
        stall_ = seed % 3 == 0 ? 40 : 0;
        run();
        compared += samples_;
    }
    std::printf("%lld samples, 0 words differ\n", static_cast<long long>(compared));
}

TEST_F(MotionInterpolator, SharesTicksAmongSamples) {
    samples_per_tick_log2(3);
    program(pieces(2, 30, 20, 60, 9 << 16));
    fill();
    run();
}

TEST_F(MotionInterpolator, TakesARequestEveryInterval) {
    if (core_.build != Build::kParallel)
        GTEST_SKIP() << "the engine's samples take as long as their steps";
    // Segments of one step each, of 256 samples: more clocks than a step or a segment's words need.
    LegalSegments shapes(core_, 3);
    std::vector<RunSegment> steps;
    std::vector<hls::ProfileWords> pieces;
    for (int n = 0; n < 20; ++n) {
        steps.push_back(shapes.whole(6, 1));
        pieces.push_back(piece_of(steps.back().length, 256, 1, n == 19));
    }
    program(pieces, steps);
    fill();
    requesting_ = true;
    while (samples_ < 500) clock();
    const uint64_t begin = dut_.cycle();
    while (samples_ < 2500) clock();
    EXPECT_EQ(dut_.cycle() - begin, 2000U * static_cast<unsigned>(core_.sample_interval));
}

TEST_F(MotionInterpolator, HoldAtEverySampleKeepsTheGeometry) {
    program(pieces(4, 12, 20, 40, 3 << 16));
    fill();
    int64_t held = 0;
    run([&] {
        const int64_t phase = static_cast<int64_t>(dut_.cycle()) % 900;
        dut_->hold_i = phase < 400 + requested_ % 64 ? 1 : 0;
        held += rate_ == 0 ? 1 : 0;
    });
    EXPECT_GT(held, 0);
}

TEST_F(MotionInterpolator, OverrideAtRandomKeepsTheGeometry) {
    program(pieces(5, 100, 20, 100, 3 << 16));
    fill();
    run([&] {
        if (random_() % 300 != 0) return;
        const uint32_t kind = random_() % 3;
        dut_->override_i = kind == 0 ? 65536 : kind == 1 ? 6554 : random_() % 65537;
    });
}

TEST_F(MotionInterpolator, StopsInTimeWhenTheProfileRunsLowAndGoesOnWhenFed) {
    program(pieces(7, 600, 5, 20, 3 << 16));
    profile_stall_ = 50;
    fill();
    int64_t stood = 0;
    run([&] {
        // The host feeds, slowly, only while the motion stands.
        profile_stall_ = rate_ == 0 ? 97 : 100;
        stood += rate_ == 0 ? 1 : 0;
    });
    EXPECT_TRUE(dut_->underrun_o);
    EXPECT_GT(stood, 0);
}

TEST_F(MotionInterpolator, StartsAfreshAfterAReset) {
    for (int round = 0; round < 24; ++round) {
        program(pieces(100 + round, 20, 5, 40, 3 << 16));
        stall_ = 30 * (round % 3);
        requesting_ = true;
        const auto clocks = static_cast<int>(random_() % 3000);
        for (int n = 0; n < clocks && !HasFatalFailure(); ++n) {
            dut_->hold_i = round % 4 == 1 && n > clocks / 2;
            dut_->kill_i = round % 4 == 2 && n == clocks / 2;
            clock();
        }
        start_afresh();
        program(pieces(200 + round, 10, 10, 20, 3 << 16));
        fill();
        run();
        if (HasFailure()) FAIL() << "round " << round;
    }
}

TEST_F(MotionInterpolator, CountsEmptySegments) {
    program(pieces(8, 40, 20, 40, 50 << 16));
    const auto empty = static_cast<int>(
        std::count_if(segments_.begin(), segments_.end(),
                      [](const RunSegment& segment) { return segment.length == 0; }));
    fill();
    run();
    EXPECT_GT(empty, 0);
    EXPECT_EQ(dut_->empty_segments_o, empty);
}

}  // namespace
}  // namespace curvecore::tb
