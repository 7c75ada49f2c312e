// SPDX-License-Identifier: Apache-2.0
// Time is kept: the samples of a plan, by the core's clocks, stay within the planned sample period,
// in every build and close to the least clock.
#include "sysc/watch/sample_pace.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <random>

#include "ref/feed/planner.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/report/report.hpp"
#include "sysc/watch/predicted_pace.hpp"
#include "sysc/words/path_source.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/tiny_moves.hpp"

namespace curvecore::tb::sample_pace_test {
using namespace sysc;

constexpr double kPeriod = 100e-6;

TEST(SamplePace, IsTheLeastPeriodAtWhichNoSampleIsLate) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::vector<double> clock{0};
        const int ahead = 1 + round % 2;
        SamplePace pace(ahead);
        pace.sample(0, 0);
        for (unsigned n = 1; n < 60; ++n) {
            clock.push_back(clock.back() + 1 + random() % (random() % 10 == 0 ? 300 : 5));
            pace.sample(n, static_cast<std::uint64_t>(clock.back()));
        }
        double most = 0;
        for (std::size_t n = 1; n < clock.size(); ++n) {
            for (std::size_t k = 0; k < n; ++k) {
                most = std::max(most, (clock[n] - clock[k]) / (static_cast<double>(n - k) + ahead));
            }
        }
        ASSERT_DOUBLE_EQ(pace.period(), most) << round;
    }
}

/// Least period along the plan that a core with `available` clocks a period reaches, in these
/// clocks.
double share_used(const ref::Program& program, const CoreParameters& core, double available,
                  double planned_for = 1) {
    ref::PlanOptions options;
    options.format = core;
    options.sample_period_s = kPeriod;
    options.core = core_time(core, available * planned_for / kPeriod);
    options.segment_queue_words = INT_MAX;  // the core limits, not the queues
    options.profile_queue_words = INT_MAX;
    options.window = program.moves.size() + 1;  // nor the look-ahead
    const ref::Plan plan = make_plan(program, ref::Machine(), options);
    PathSource source(plan, 0, 1 << 16);
    PredictedPace pace(plan, core);
    std::uint64_t s = 0;
    do {
        source.next();
        s += static_cast<std::uint64_t>(source.ds());
        pace.sample(s);
    } while (source.active());
    EXPECT_EQ(s, plan.segments.back().s_start + plan.segments.back().length);
    return pace.period() / available;
}

struct Case {
    const char* name;
    Build build;
    int splines;
    int mode;
    std::vector<double> available;  // clocks, relative to the least
};

TEST(SamplePace, PlansOfTinySegmentsKeepTime) {
    const std::vector<Case> cores{
        {"parallel", Build::kParallel, 0, 0, {1, 2, 7, 30, 100, 133, 140, 300, 1000, 10000}},
        {"parallel splines", Build::kParallel, 1, 1, {1, 7, 100, 520, 530, 3000, 10000}},
        {"serial", Build::kSerial, 0, 0, {1.001, 1.2, 1.5, 2, 3, 10, 100}},
        {"serial polynomial", Build::kSerial, 0, 1, {1.001, 1.5, 2, 10}},
        {"serial splines", Build::kSerial, 1, 1, {1.001, 1.2, 2, 10}},
        {"engine", Build::kEngine, 0, 0, {1.001, 1.2, 2, 10}},
        {"engine splines", Build::kEngine, 1, 1, {1.001, 1.2, 2, 10}},
    };
    for (const Case& one : cores) {
        CoreParameters core;
        core.build = one.build;
        core.splines = one.splines;
        core.mode = one.mode;
        for (const double times : one.available) {
            const double available = times * least_period_clocks(core, one.splines != 0);
            for (int seed = 1; seed <= cases(1, 3); ++seed) {
                const ref::Program program =
                    one.splines != 0 ? tiny_splines(seed, 300) : tiny_moves(seed, 800);
                const double used = share_used(program, core, available);
                EXPECT_LE(used, 1) << one.name << " " << available << " clocks, seed " << seed;
            }
        }
    }
}

TEST(SamplePace, ThePeriodIsMadeUseOf) {
    const ref::Program program = even_lines(8000);
    const std::vector<std::pair<Build, std::vector<double>>> cases{
        {Build::kParallel, {20, 133, 200, 500, 3000}},
        {Build::kSerial, {195, 240, 300, 1000}},
        {Build::kEngine, {8500, 12'000, 20'000, 60'000}}};
    for (const auto& [build, periods] : cases) {
        CoreParameters core;
        core.build = build;
        for (const double available : periods) {
            const double used = share_used(program, core, available);
            EXPECT_LE(used, 1) << build_name(build) << " " << available;
            EXPECT_GT(used, 0.6) << build_name(build) << " " << available;
            RecordProperty(build_name(build) + std::to_string(available), std::to_string(used));
            // Control: a plan for a core that is twice as fast.
            EXPECT_GT(share_used(program, core, available, 2), 1) << available;
        }
    }
}

TEST(SamplePace, ALargerPeriodThanThereIsBreaksTheCheck) {
    Job job;
    ProgramBuilder builder;
    builder.line({1, 0, 0}, 50);
    job.plan.append(make_plan(builder.program(), job.machine, job.options.plan_options()));
    const LimitLoads limits;
    const auto kept = [&](std::optional<double> clocks) {
        for (const Check& check : Report{job, 1, limits, nullptr, clocks}.checks()) {
            if (check.name == "time kept") return check.held;
        }
        throw std::logic_error("no such check");
    };
    EXPECT_TRUE(kept(10000));  // 100 us at 100 MHz
    EXPECT_FALSE(kept(10001));
    EXPECT_TRUE(kept(std::nullopt)) << "not measured";
}

TEST(SamplePace, APeriodShorterThanTheCoresClocksIsRefused) {
    CoreParameters core;
    core.build = Build::kEngine;
    const double least = least_period_clocks(core, false);
    EXPECT_NO_THROW(check_period(core, false, kPeriod, least / kPeriod));
    EXPECT_THROW(check_period(core, false, kPeriod, 0.999 * least / kPeriod), UsageError);
    EXPECT_THROW(check_period(core, true, kPeriod, least / kPeriod), UsageError);
    // Samples share the clocks of a tick.
    const double shared = least_period_clocks(core, false, 2);
    EXPECT_LT(shared, least);
    EXPECT_NO_THROW(check_period(core, false, kPeriod, shared / kPeriod, 2));
    EXPECT_THROW(check_period(core, false, kPeriod, 0.999 * shared / kPeriod, 2), UsageError);
}

}  // namespace curvecore::tb::sample_pace_test
