// SPDX-License-Identifier: Apache-2.0
// No sample of the engine is late in the least period that planner and boards ask for
// (least_period_clocks), whatever pieces, branches, holds and overrides come, while its host offers
// words all the time, or too few. In a shorter period samples are late.
#include <gtest/gtest.h>

#include "tb/model/engine/timed_motion.hpp"
#include "tb/support/microcode/busy_program.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::engine_time_test {

struct Drawn {
    std::int64_t late = 0;
    std::int64_t moving = 0;    // samples with a program under way
    std::int64_t segments = 0;  // that were offered
    unsigned reported = 0;
};

/// Draws with a period that is a share of the least one.
Drawn draw(const TimeCase& of, double share, int samples) {
    sysc::CoreParameters core;
    core.build = ref::Build::kEngine;
    core.splines = 1;
    core.mode = of.mode;
    constexpr int kRateBits = 29;  // as in motion_system
    const assembler::Assembly made =
        assembler::motion_program(core, {1024, 1024}, RTL_DIR "/..", kRateBits);
    const double least = sysc::least_period_clocks(core, of.spline, 1 << of.samples_per_tick_log2);
    TimedMotion motion(core, made, static_cast<int>(std::ceil(share * least)));
    motion.inputs().samples_per_tick_log2 = of.samples_per_tick_log2;
    motion.inputs().stop_ticks = of.stop_ticks();
    if (of.moves && !of.slow_host) motion.inputs().hold_acceleration = 1 << 12;
    BusyProgram program(core, of, TimedMotion::kDigest, 1);
    std::mt19937_64 random(2);
    Drawn drawn;
    for (std::int64_t n = 0; n < samples; ++n) {
        for (const Stream stream : {kSegments, kPieces}) {
            std::deque<std::uint64_t>& words = motion.offered(stream);
            while (words.size() < (of.slow_host ? 1 : 128)) words.push_back(program.next(stream));
        }
        if (of.moves) {
            motion.inputs().hold = random() % 64 == 0;
            motion.inputs().override_rate = 65536 - static_cast<std::int64_t>(random() % 3000);
        }
        motion.work();
        drawn.moving += motion.active() ? 1 : 0;
    }
    drawn.late = motion.late();
    drawn.reported = motion.reported();
    drawn.segments = program.segments();
    return drawn;
}

TEST(EngineTime, NoSampleIsLateInTheLeastPeriod) {
    constexpr unsigned kUnderrun = 256;
    int starved = 0;
    each_case([&](const TimeCase& of) {
        const int samples = cases(600, 20000);
        const Drawn drawn = draw(of, 1, samples);
        EXPECT_EQ(drawn.late, 0) << text(of);
        EXPECT_EQ(drawn.reported & ~kUnderrun, 0U) << text(of);
        if (of.slow_host) {
            starved += drawn.reported != 0 ? 1 : 0;
        } else {
            EXPECT_GT(drawn.moving, samples / 2) << text(of);
            EXPECT_GT(drawn.segments, samples / 15 / of.segment_steps / 2) << text(of);
        }
    });
    EXPECT_GT(starved, 10);
}

/// The bound is the sum of the longest ways, which do not come together.
TEST(EngineTime, SamplesAreLateInAShorterPeriod) {
    each_case([&](const TimeCase& of) {
        if (of.piece_ticks == 80 && of.samples_per_tick_log2 == 0 && !of.slow_host) {
            EXPECT_GT(draw(of, of.spline ? 0.55 : 0.4, 600).late, 0) << text(of);
        }
    });
}

}  // namespace curvecore::tb::engine_time_test
