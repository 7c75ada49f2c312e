// SPDX-License-Identifier: Apache-2.0
// Programs that are planned shortly before they are drawn, so that feeds may be raised meanwhile:
// the same path, hardly slower, within the limits, and a change is never far.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/program/gcode_stream.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/panel/planned_path.hpp"
#include "tb/support/judge/hold_run.hpp"
#include "tb/support/programs/live_programs.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::live_plan_test {

struct Case {
    const char* name;
    double feed;  // mm/min
    std::string (*moves)();
};

std::string one_line() { return "G1 X400\n"; }

sysc::Options live_options(const std::string& text) {
    std::istringstream stream(text);
    ref::GcodeStream gcode(stream, "t.ngc", {});
    sysc::Options options;
    options.program = std::make_shared<ref::HeldProgram>(
        ref::HeldProgram{ref::read_all(gcode, "t.ngc"), gcode.events(), {}});
    options.live = true;
    return options;
}

class LivePlanOf : public testing::TestWithParam<Case> {
  protected:
    struct Planned {
        ref::Plan plan;
        std::vector<double> parts;  // s
    };

    /// Plans the program; `percent` gives the override before each part.
    static Planned plan(bool live, const std::function<double(double)>& percent = {},
                        const ref::Machine& machine = {}) {
        sysc::Options options = live_options(fmt::format("G90 G64 P0.01 F{}\n", GetParam().feed) +
                                             GetParam().moves() + "M2\n");
        options.live = live;
        sysc::JobStream job(options, machine);
        Planned all;
        double time = 0;
        for (;;) {
            if (percent) job.raise(percent(time));
            const ref::Plan* part = job.next();
            if (part == nullptr) return all;
            time += part->duration_s;
            all.parts.push_back(part->duration_s);
            append(*part, all.plan);
        }
    }

    static void append(const ref::Plan& part, ref::Plan& plan) {
        if (plan.pieces.empty()) {
            plan = part;
            return;
        }
        for (ref::PlannedBranch branch : part.branches) {
            branch.piece += plan.pieces.size();
            plan.branches.push_back(std::move(branch));
        }
        plan.duration_s += part.duration_s;
        plan.segments.insert(plan.segments.end(), part.segments.begin(), part.segments.end());
        plan.pieces.insert(plan.pieces.end(), part.pieces.begin(), part.pieces.end());
    }

    static std::uint64_t length(const ref::Plan& plan) {
        return plan.segments.back().s_start + plan.segments.back().length;
    }
};

TEST_P(LivePlanOf, IsHardlySlowerInShortParts) {
    const Planned whole = plan(false);
    const Planned live = plan(true);
    EXPECT_NEAR(static_cast<double>(length(live.plan)), static_cast<double>(length(whole.plan)),
                static_cast<double>(live.plan.segments.size()));
    EXPECT_LT(live.plan.duration_s, 1.04 * whole.plan.duration_s);
    const double longest = *std::max_element(live.parts.begin(), live.parts.end());
    std::cout << fmt::format(
        "{}: {:.3f} s, planned at once {:.3f} s; {} parts, the longest {:.3f} s\n", GetParam().name,
        live.plan.duration_s, whole.plan.duration_s, live.parts.size(), longest);
    EXPECT_LT(longest, 1.5);
}

TEST_P(LivePlanOf, StopsByItsBranchesInMostPlaces) {
    constexpr double kSoon = 0.3;  // s
    constexpr double kShare = 0.25;
    const Planned live = plan(true);
    HoldRun run(live.plan, ref::Machine{});
    int holds = 0, late = 0;
    for (int tick = 1; run.active(); ++tick) {
        run.tick(1 << 16);
        if (tick % 97 != 0) continue;
        HoldRun held = run;
        late += static_cast<double>(held.stop()) * live.plan.tick_s > kSoon ? 1 : 0;
        if (holds % 40 == 0) {
            EXPECT_LE(held.finish().most(), 1) << tick;
        }
        ++holds;
    }
    std::cout << fmt::format("{}: {} of {} holds take more than {} s\n", GetParam().name, late,
                             holds, kSoon);
    EXPECT_LT(late, kShare * holds);
}

TEST_P(LivePlanOf, HoldsKeepTheLimitsAtAnyRateWithASlowAxis) {
    ref::Machine machine;
    machine.axis[1].velocity = machine.velocity / 10;
    machine.axis[1].acceleration = machine.acceleration / 10;
    machine.axis[1].jerk = machine.jerk / 10;
    const Planned live = plan(true, {}, machine);
    const int every = static_cast<int>(live.plan.duration_s / live.plan.tick_s) / cases(60, 600);
    for (const double rate : {1.0, 0.99, 0.8, 0.6, 0.3}) {
        HoldRun run(live.plan, machine);
        const auto target = static_cast<std::int32_t>(std::lround(rate * (1 << 16)));
        for (int tick = 1; run.active(); ++tick) {
            run.tick(target);
            if (tick % every != 0) continue;
            HoldRun held = run;
            held.stop();
            EXPECT_LE(held.finish().most(), 1) << rate << ", tick " << tick;
        }
    }
}

TEST_P(LivePlanOf, KeepsTheLimitsWhereFeedsAreRaisedAndTimeIsScaled) {
    const int runs = cases(2, 100);
    for (int seed = 1; seed <= runs; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        double most = 100;
        const Planned live = plan(true, [&](double) {
            if (random() % 3 == 0) most = 100 + random() % 101;
            return most;
        });
        HoldRun run(live.plan, ref::Machine{});
        std::int32_t target = 1 << 16;
        while (run.active()) {
            if (random() % 3000 == 0) target = static_cast<std::int32_t>(random() % 65537);
            if (target < 6000 && random() % 500 == 0) target = 1 << 16;
            run.tick(target);
        }
        const sysc::LimitLoads loads = run.finish();
        EXPECT_LE(loads.most(), 1) << seed;
    }
}

TEST_P(LivePlanOf, IsFasterBehindTheRaise) {
    const Planned before = plan(true);
    const Planned raised = plan(true, [](double time) { return time > 1 ? 200 : 100; });
    EXPECT_EQ(raised.parts[0], before.parts[0]);
    EXPECT_LT(raised.plan.duration_s, 0.9 * before.plan.duration_s);
}

/// Moves that take longer than a window, by the machine's speed: neither a refusal nor a stop.
TEST(LivePlan, OfASlowMachineDoesNotStopOnALine) {
    ref::Machine machine;
    machine.velocity = 12;
    machine.acceleration = 100;
    machine.jerk = 2000;
    for (const char* text : {"G0 X100\nG1 X300 F3000\nM2\n", "G1 X1 F3000\nG1 X200\nM2\n"}) {
        sysc::Options options = live_options(text);
        double seconds[2] = {};
        for (const bool live : {true, false}) {
            options.live = live;
            sysc::JobStream job(options, machine);
            while (const ref::Plan* part = job.next()) seconds[live] += part->duration_s;
        }
        EXPECT_LT(seconds[1], 1.02 * seconds[0]) << text;
    }
}

/// A queue of 1,024 words and an engine that loads two steps a tick carry fourteen branches a
/// second at least: pieces are long enough to load them, and each of them may have one.
TEST(LivePlan, OfABoardWithShortQueuesHasBranches) {
    for (const double feed : {300, 1800, 4000}) {
        sysc::Options options = live_options(fmt::format("G0 Z20\nG1 X60 F{}\nM2\n", feed));
        options.core.build = sysc::Build::kEngine;
        options.core.splines = options.core.mode = 1;
        options.sample_period_s = 1.6e-3;
        options.clock_hz = 5.12e6;
        options.segment_queue_words = options.profile_queue_words = 1024;
        sysc::JobStream job(options);
        double seconds = 0;
        std::size_t branches = 0;
        while (const ref::Plan* part = job.next()) {
            seconds += part->duration_s;
            branches += part->branches.size();
        }
        const double least = feed < 600 ? 8 : 14;  // a second; the slowest are 0.5 mm apart
        EXPECT_GT(static_cast<double>(branches), least * seconds) << feed;
    }
}

/// Time that is left at a program's last place is 0, also where it rests there: else stream waits.
TEST(LivePlan, NothingIsLeftBehindALastDwell) {
    sysc::Options options = live_options("G1 X5 F600\nG4 P9\nM2\n");
    options.holds = ref::Holds::kBounds;
    sysc::JobStream job(options);
    sysc::PlannedPath path;
    std::uint64_t end = 0;
    while (const ref::Plan* part = job.next()) {
        path.add(*part);
        end = part->segments.back().s_start + part->segments.back().length;
    }
    EXPECT_GT(path.time_s(), 9);
    EXPECT_EQ(path.at(end).time_s, path.time_s());
}

INSTANTIATE_TEST_SUITE_P(Form, LivePlanOf,
                         testing::Values(Case{"Line", 3000, one_line},
                                         Case{"Surface", 3000, surface},
                                         Case{"Corners", 2000, corners}, Case{"Arcs", 6000, arcs}),
                         [](const auto& form) { return std::string(form.param.name); });

}  // namespace curvecore::tb::live_plan_test
