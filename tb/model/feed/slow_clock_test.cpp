// SPDX-License-Identifier: Apache-2.0
// A core with a slow clock: motion that its clocks slow is not slower than they require, and is
// reported.
//
// The core makes one change (a step, a segment) in the time in which samples are ahead of it where
// another makes two. Its steps are as long, and the last one of a segment has half of one or what
// the feed needs (ref/segment/last_step.hpp): so it may be four times as slow at a place, and as a
// motion that is slowed in time by four keeps every limit, in all. CURVECORE_CUBICS asks for more
// programs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "ref/feed/planner.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/segment/last_step.hpp"
#include "sysc/core/core_clocks.hpp"
#include "sysc/watch/predicted_pace.hpp"
#include "sysc/words/path_source.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::slow_clock_test {

constexpr double kFeed = 100;     // mm/s
constexpr double kFactor = 4;     // derived above
constexpr double kAsFast = 1.15;  // a greater ratio must be reported

int cubics() {
    const char* const asked = std::getenv("CURVECORE_CUBICS");
    return asked == nullptr ? 150 : std::atoi(asked);
}

sysc::CoreParameters core_of(sysc::Build build) {
    sysc::CoreParameters core;
    core.build = build;
    core.mode = 1;
    core.splines = 1;
    return core;
}

ref::PlanOptions options(double clock_hz, sysc::Build build = sysc::Build::kSerial) {
    const sysc::CoreParameters core = core_of(build);
    ref::PlanOptions options;
    options.format = core;
    options.core = sysc::core_time(core, clock_hz);
    options.segment_queue_words = 1 << 16;
    return options;
}

/// A line and a curve: a cubic, or one time in four an arc.
ref::Program curve(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const auto aside = [&](double size) {
        return ref::Vec3(uniform(-size, size), uniform(-size, size), 0);
    };
    const double size = std::pow(10.0, uniform(-1, 1.2));
    ProgramBuilder builder;
    builder.line(aside(size), 0);
    if (random() % 4 == 0) {
        const ref::Vec3 centre = builder.at() + aside(size);
        builder.arc(centre, ref::Vec3::UnitZ(), uniform(0.1, 6), 0, kFeed);
    } else {
        const ref::Vec3 start = builder.at();
        const ref::Vec3 end = start + aside(size);
        builder.cubic(start + aside(size), end + aside(size), end, kFeed);
    }
    return builder.program();
}

/// The cubic of which 10 um took 35 s: the last steps of two of its segments had 85 and 0.1 nm.
ref::Program crawler() {
    ProgramBuilder builder;
    const ref::Vec3 start(6.54947, -3.03272, 0);
    const ref::Vec3 end(1.43210, 3.27234, 0);
    builder.line(start, 0);
    builder.cubic(start + ref::Vec3(5.15421, 3.63568, 0), end + ref::Vec3(-6.41472, 1.16061, 0),
                  end, kFeed);
    return builder.program();
}

struct Compared {
    double ratio;   // of the times
    double warned;  // share of the time that a warning names
    bool optimum;   // true: times of the optimum; false: of the rules
};

Compared compared(const ref::Program& program, const ref::Machine& machine, double clock_hz) {
    const auto plan = [&](double hz, ref::Effort effort) {
        ref::PlanOptions how = options(hz);
        how.effort = effort;
        return ref::make_plan(program, machine, how);
    };
    const ref::Plan slow = plan(clock_hz, ref::Effort::kOptimum);
    const double warned = slow.core_slowed.lost_s / slow.duration_s;
    const double ratio = slow.duration_s / plan(100e6, ref::Effort::kOptimum).duration_s;
    if (ratio <= kAsFast || slow.duration_s < plan(clock_hz, ref::Effort::kRules).duration_s) {
        return {ratio, warned, true};
    }
    return {slow.duration_s / plan(100e6, ref::Effort::kRules).duration_s, warned, false};
}

TEST(SlowClock, NoCurveIsSlowerThanTheClocksAskWithoutAWarning) {
    ref::Machine machine;
    machine.acceleration = 3000;
    double worst = 0;
    int slower = 0;
    int without_optimum = 0;
    for (int n = 0; n < cubics(); ++n) {
        const ref::Program program = n == 0 ? crawler() : curve(static_cast<unsigned>(n));
        const double clock_hz = std::array{2.56e6, 2.3e6, 3e6, 4e6, 5e6}[n % 5];
        const Compared found = compared(program, machine, clock_hz);
        EXPECT_LE(found.ratio, kFactor) << n << " at " << clock_hz;
        if (found.ratio > kAsFast) {
            ++slower;
            EXPECT_GT(found.warned, 0.01) << n << " at " << clock_hz << ": " << found.ratio;
        }
        worst = std::max(worst, found.ratio);
        without_optimum += !found.optimum;
    }
    RecordProperty("worst ratio", std::to_string(worst));
    RecordProperty("slower", slower);
    std::printf(
        "%d curves: %.3f times as long at most, %d slower and named, %d without an optimum\n",
        cubics(), worst, slower, without_optimum);
}

/// Least sample period that a core keeps along a plan, relative to the planned one: its steps in
/// turn.
double share_used(const ref::Plan& plan, const sysc::CoreParameters& core, double clocks) {
    sysc::PathSource source(plan, 0, 1 << 16);
    sysc::PredictedPace pace(plan, core);
    std::uint64_t s = 0;
    do {
        source.next();
        s += static_cast<std::uint64_t>(source.ds());
        pace.sample(s);
    } while (source.active());
    return pace.period() / clocks;
}

/// A core that makes a step beside the samples of the one before. Its last steps, too, have at
/// least half a step or what the feed needs. Every sample comes in time.
TEST(SlowClock, CoresThatStepAheadKeepTimeAndDoNotCrawl) {
    ref::Machine machine;
    machine.acceleration = 3000;
    const sysc::CoreParameters core = core_of(sysc::Build::kParallel);
    double worst = 0;
    double most_used = 0;
    int slower = 0;
    const int number = std::max(1, cubics() / 3);
    for (int n = 0; n < number; ++n) {
        const ref::Program program = n == 0 ? crawler() : curve(static_cast<unsigned>(n));
        const double clock_hz = std::array{2.56e6, 2e6, 3e6, 4e6, 5e6}[n % 5];
        const ref::PlanOptions how = options(clock_hz, sysc::Build::kParallel);
        const ref::Plan slow = ref::make_plan(program, machine, how);
        const ref::Plan fast =
            ref::make_plan(program, machine, options(100e6, sysc::Build::kParallel));
        const double ratio = slow.duration_s / fast.duration_s;
        const double used = share_used(slow, core, clock_hz * how.sample_period_s);
        EXPECT_LE(ratio, kFactor) << n << " at " << clock_hz;
        EXPECT_LE(used, 1) << n << " at " << clock_hz;
        if (ratio > kAsFast) {
            ++slower;
            EXPECT_GT(slow.core_slowed.lost_s / slow.duration_s, 0.01) << n << " at " << clock_hz;
        }
        worst = std::max(worst, ratio);
        most_used = std::max(most_used, used);
    }
    std::printf("%d curves: %.3f times as long at most, %d slower, %.3f of the period used\n",
                number, worst, slower, most_used);
}

/// Neither a cut at a short last step nor one that rounding makes leaves a short one.
TEST(SlowClock, LastStepsAreCutToHalfAStepOrMore) {
    EXPECT_EQ(ref::cut_for_last_step(40.5, 3, 0), 0) << "any will do";
    EXPECT_EQ(ref::cut_for_last_step(41, 3, 0.5), 0) << "long enough";
    EXPECT_EQ(ref::cut_for_last_step(44, 3, 1e9), 0) << "half a step";
    EXPECT_EQ(ref::cut_for_last_step(7, 3, 1e9), 0) << "one step";
    EXPECT_EQ(ref::cut_for_last_step(41, 3, 2), 36.5) << "4.5625 and 0.5625 steps";
    EXPECT_EQ(ref::cut_for_last_step(40, 3, 1e-9), 36) << "a quantum may be added";
    EXPECT_NEAR(ref::cut_for_last_step(40 - 1.0 / 65536, 3, 1e-9), 36, 1e-4);
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        const double length = std::ldexp(static_cast<double>(random() % 1000000) + 1, -3);
        const int exponent = static_cast<int>(random() % 14);
        const double step = std::ldexp(1, exponent);
        const double cut = ref::cut_for_last_step(length, exponent, step);
        const auto last = [&](double part) {
            const double rest = std::fmod(part, step);
            return rest == 0 ? step : rest;
        };
        if (cut == 0) {
            EXPECT_TRUE(length <= step || last(length) >= step / 2) << length << " " << exponent;
            continue;
        }
        EXPECT_GE(last(cut), step / 2);
        EXPECT_GE(length - cut, step / 2);
        EXPECT_LE(length - cut, step);
    }
}

/// Segments of many curves, with lines longer than a step among them.
TEST(SlowClock, SegmentsEndWithStepsThatTheFeedBears) {
    const ref::PlanOptions slow = options(2.56e6);
    int several = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        ref::Program program = curve(seed);
        if (seed < 5) {
            ProgramBuilder builder;
            builder.line({std::ldexp(1e-6, 27) + seed * 1e-6, 0, 0},
                         kFeed);  // a step and this many nm
            program = builder.program();
        }
        const ref::Geometry geometry = ref::make_geometry(program, ref::Machine(), slow);
        for (const ref::Segment& segment : geometry.segments) {
            const double step = std::ldexp(1, segment.step_exponent);
            const double length = static_cast<double>(segment.length) / 65536;
            if (length <= step) continue;
            ++several;
            const double last = std::fmod(length, step);
            const double least = std::min(step / 2, ref::least_last_step(kFeed, slow));
            EXPECT_GE(last, least - 0.01) << seed << ", line " << segment.line;
        }
    }
    EXPECT_GT(several, 100);
}

}  // namespace curvecore::tb::slow_clock_test
