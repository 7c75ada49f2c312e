// SPDX-License-Identifier: Apache-2.0
// Holds of planned programs: quick from any tick, within the limits, and time goes on after them.
#include "ref/feed/stops/planned_branches.hpp"

#include <gtest/gtest.h>

#include "hls/words.hpp"
#include "ref/feed/planner.hpp"
#include "ref/feed/stops/queue_cover.hpp"
#include "ref/feed/stops/stop_branch.hpp"
#include "ref/format/path_words.hpp"
#include "tb/support/judge/hold_run.hpp"
#include "tb/support/judge/shortest_stop.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/even_paths.hpp"
#include "tb/support/programs/random_joints.hpp"
#include "tb/support/segments/random_splines.hpp"

namespace curvecore::tb::planned_branches_test {

using ref::Machine;
using ref::Plan;
using ref::PlannedBranch;

constexpr std::int32_t kOne = 1 << 16;
constexpr double kSlowDistance = 0.15;

std::uint64_t ticks(const Plan& plan) {
    return static_cast<std::uint64_t>(std::llround(plan.duration_s / plan.tick_s));
}

struct Held {
    double time;  // s to rest
    sysc::LimitLoads loads;
};
/// Holds from a tick of the plan to rest; if it `resumes`, continues to the program's end.
Held hold(const Plan& plan, const Machine& machine, std::uint64_t tick, bool resumes) {
    HoldRun run(plan, machine);
    for (std::uint64_t k = 0; k < tick; ++k) run.tick(kOne);
    const std::uint64_t stop = run.stop();
    for (int k = 0; k < 400; ++k) run.tick(0);
    while (resumes && run.active()) run.tick(kOne);
    return {static_cast<double>(stop) * plan.tick_s, run.finish()};
}

struct Curve {
    std::string name;
    ref::Program program;
    Machine machine = Machine();
};
std::vector<Curve> curves() {
    std::vector<Curve> all;
    for (const EvenPath& even : even_paths()) all.push_back({even.name, even.program});
    all.push_back({"wave", chopped_wave(0, 500)});
    all.push_back({"turn", chopped_turn(0, 500)});
    for (const unsigned seed : {1U, 5U}) {
        all.push_back(
            {"splines " + std::to_string(seed), random_splines(seed, 8), unequal_machine(seed)});
    }
    return all;
}

// First tick from which on the rate 1 counts as constant.
constexpr std::uint64_t kFirst = 2;

TEST(PlannedBranches, StopWithinTheLimitsFromAnywhere) {
    for (const Curve& curve : curves()) {
        const Plan plan = make_plan(curve.program, curve.machine, {});
        const std::uint64_t every = ticks(plan) / 17 + 1;
        for (std::uint64_t tick = kFirst; tick < ticks(plan); tick += every) {
            const Held held = hold(plan, curve.machine, tick, tick % 3 == 0);
            EXPECT_LE(held.time, 0.3) << curve.name << " " << tick;
            EXPECT_LE(held.loads.most(), 1) << curve.name << " " << tick << text(held.loads);
        }
    }
}

// A branch at the rate r0 takes 1 / r0 of the time, and r0, r0^2, r0^3 of the limits.
TEST(PlannedBranches, StopWithinTheLimitsAtEveryRate) {
    int looked_at = 0;
    for (const Curve& curve : curves()) {
        const Plan plan = make_plan(curve.program, curve.machine, {});
        for (const double r0 : {0.99, 0.9, 0.8, 0.6}) {
            const auto rate = static_cast<std::int32_t>(r0 * kOne);
            double most = 0;
            for (int part = 1; part < 12; ++part) {
                HoldRun run(plan, curve.machine);
                for (double k = 0; k < static_cast<double>(ticks(plan)) * part / 12; k += r0) {
                    run.tick(rate);
                }
                most = std::max(most, static_cast<double>(run.stop()) * plan.tick_s);
                while (part % 3 == 0 && run.active()) run.tick(rate);
                const sysc::LimitLoads loads = run.finish();
                EXPECT_LE(loads.most(), 1) << curve.name << " " << r0 << " " << part << text(loads);
                ++looked_at;
            }
            EXPECT_LE(most, r0 < 0.8 ? 0.38 : 0.3) << curve.name << " " << r0;
        }
    }
    EXPECT_GT(looked_at, 200);
}

// No branch is due yet; without them a hold there takes 1.2 s.
TEST(PlannedBranches, StopAsQuicklyInAProgramsFirstTicks) {
    for (const Curve& curve : curves()) {
        const Plan plan = make_plan(curve.program, curve.machine, {});
        for (std::uint64_t tick = kFirst; tick <= ref::kStopLead; tick += 3) {
            const Held held = hold(plan, curve.machine, tick, false);
            EXPECT_LE(held.time, 0.1) << curve.name << " " << tick;
            EXPECT_LE(held.loads.most(), 1) << curve.name << " " << tick << text(held.loads);
        }
    }
}

// Branches that passed while time was slower announce the next one.
TEST(PlannedBranches, StopAsQuicklyAfterAResume) {
    int looked_at = 0;
    for (const Curve& curve : curves()) {
        const Plan plan = make_plan(curve.program, curve.machine, {});
        for (std::uint64_t tick = 50; tick < ticks(plan); tick += ticks(plan) / 8 + 1) {
            for (const int later : {0, 1, 40, 300}) {
                HoldRun run(plan, curve.machine);
                for (std::uint64_t k = 0; k < tick; ++k) run.tick(kOne);
                run.stop();
                while (run.active() && run.tick(kOne) != kOne) {
                }
                for (int k = 0; k < 2 + later && run.active(); ++k) run.tick(kOne);
                if (!run.active()) break;
                const double time = static_cast<double>(run.stop()) * plan.tick_s;
                const sysc::LimitLoads loads = run.finish();
                EXPECT_LE(time, 0.3) << curve.name << " " << tick << " + " << later;
                EXPECT_LE(loads.most(), 1) << curve.name << " " << tick << " + " << later;
                ++looked_at;
            }
        }
    }
    EXPECT_GT(looked_at, 60);
}

TEST(PlannedBranches, StopNearlyAsSoonAsCanBe) {
    for (const EvenPath& even : even_paths()) {
        const Machine machine;
        const ref::PlanOptions options;
        const Plan plan = make_plan(even.program, machine, options);
        const ref::Geometry geometry = make_geometry(even.program, machine, options);
        ref::ProfileCourse course(even.program, machine, geometry, plan, 1);
        const ref::PieceGrid grid(machine, plan.unit_mm, plan.tick_s);
        walk_pieces(plan, geometry, grid, [&](const ref::PieceStretch& part) { course.add(part); });
        const ShortestStop shortest(machine, even.bend, even.third);
        double behind = 0;
        for (std::uint64_t tick = kFirst; tick < ticks(plan); tick += 97) {
            const auto at = static_cast<double>(tick);
            for (const ref::CourseCell& cell : course.cells()) {
                if (at < cell.from || at >= cell.to) continue;
                const ref::PieceMotion m = course.motion(cell, at);
                const double time = hold(plan, machine, tick, false).time;
                behind = std::max(behind, time - shortest.time(m.v, m.a));
                break;
            }
        }
        EXPECT_LE(behind, 0.13) << even.name;  // most where it accelerates
    }
}

TEST(PlannedBranches, OfRandomProgramsStopWithinTheLimits) {
    int looked_at = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const JointCase random = RandomJoints(seed).make();
        const Plan plan = make_plan(random.program, random.machine, random.options);
        if (ticks(plan) > 40000) continue;
        for (int part = 1; part < 5; ++part) {
            const Held held =
                hold(plan, random.machine, ticks(plan) * static_cast<unsigned>(part) / 5, true);
            EXPECT_LE(held.loads.most(), 1) << seed << " " << part << text(held.loads);
            ++looked_at;
        }
    }
    EXPECT_GT(looked_at, 80);
}

/// Fewest ticks that 3/4 of a queue hold, from any piece at that distance from the end.
std::uint64_t least_cover(const Plan& plan, std::size_t queue) {
    std::vector<std::size_t> words{0};
    std::vector<std::uint64_t> ticks{0};
    auto branch = plan.branches.begin();
    for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
        words.push_back(words.back() + ref::kProfileBusWords);
        ticks.push_back(ticks.back() + plan.pieces[i].ticks);
        if (branch == plan.branches.end() || branch->piece != i) continue;
        words.back() += branch_words(*branch++);
    }
    std::uint64_t least = UINT64_MAX;
    for (std::size_t from = 0, to = 0; from < words.size(); ++from) {
        while (to + 1 < words.size() && words[to + 1] - words[from] <= queue * 3 / 4) ++to;
        if (to + 1 == words.size()) break;
        least = std::min(least, ticks[to] - ticks[from]);
    }
    return least;
}

TEST(PlannedBranches, LeaveAStopInTheQueue) {
    for (const Curve& curve : curves()) {
        for (const int queue : {512, 1024, 2048}) {
            ref::PlanOptions options;
            options.profile_queue_words = queue;
            const Plan plan = make_plan(curve.program, curve.machine, options);
            EXPECT_GE(least_cover(plan, static_cast<std::size_t>(queue)), plan.stop_ticks)
                << curve.name << " " << queue;
        }
    }
}

TEST(PlannedBranches, AreDroppedOnlyWhereTheQueueIsShort) {
    int some = 0;
    for (const Curve& curve : curves()) {
        const Plan whole = make_plan(curve.program, curve.machine, {});
        Plan bare = whole;
        bare.branches.clear();
        for (const int queue : {256, 512, 1024, 65536}) {
            const auto words = static_cast<std::size_t>(queue);
            Plan plan = whole;
            ref::PlanOptions options;
            options.profile_queue_words = queue;
            drop_uncovered(options, plan);
            const std::uint64_t needed =
                plan.stop_ticks + 64 +
                static_cast<std::uint64_t>(std::ceil(ref::kHostLate / plan.tick_s));
            if (least_cover(whole, words) >= needed) {
                EXPECT_EQ(plan.branches.size(), whole.branches.size())
                    << curve.name << " " << queue;
            } else if (least_cover(bare, words) >= needed) {
                EXPECT_GE(least_cover(plan, words), needed) << curve.name << " " << queue;
                EXPECT_LT(plan.branches.size(), whole.branches.size());
                some += plan.branches.empty() ? 0 : 1;
            }
        }
    }
    EXPECT_GT(some, 0);
}

TEST(PlannedBranches, GiveWayWhereTheQueueIsShort) {
    std::size_t without = 0;
    for (const Curve& curve : curves()) {
        ref::PlanOptions options;
        options.profile_queue_words = 512;
        const Plan plan = make_plan(curve.program, curve.machine, options);
        options.holds = ref::Holds::kBounds;
        const Plan bounds = make_plan(curve.program, curve.machine, options);
        EXPECT_LE(plan.duration_s, bounds.duration_s / 0.99) << curve.name;
        without += plan.branches.empty() ? 1 : 0;
    }
    EXPECT_GT(without, 0U);
}

TEST(PlannedBranches, FitTheirWordsAndTheCore) {
    for (const Curve& curve : curves()) {
        const Plan plan = make_plan(curve.program, curve.machine, {});
        ASSERT_FALSE(plan.branches.empty()) << curve.name;
        EXPECT_EQ(plan.branches.front().piece, 0U);
        std::uint64_t start = 0;
        std::size_t piece = 0;
        std::uint64_t last = 0;
        for (const PlannedBranch& branch : plan.branches) {
            for (; piece < branch.piece; ++piece) start += plan.pieces[piece].ticks;
            EXPECT_TRUE(start == 0 || start - last > ref::kStopLead);
            last = start;
            EXPECT_GE(branch.wait, 1U);
            EXPECT_LE((branch.wait - ref::kStopLead) * plan.tick_s, kSlowDistance)
                << curve.name << " " << start;
            ASSERT_LE(branch.steps.size(), static_cast<std::size_t>(ref::kStopSteps));
            EXPECT_LE(branch.steps.front().change, 0);
            for (const ref::StopStep& step : branch.steps) {
                EXPECT_LT(step.ticks, 1U << ref::kStepTicksBits);
            }
        }
    }
}

/// Branches whose steps, two a tick, do not fit into the piece before them.
int hurried(const Plan& plan) {
    int count = 0;
    for (const PlannedBranch& branch : plan.branches) {
        if (branch.piece == 0) continue;
        count += branch.steps.size() > 2 * plan.pieces[branch.piece - 1].ticks ? 1 : 0;
    }
    return count;
}

TEST(PlannedBranches, LeaveACoreTheTimeToLoadThem) {
    int before = 0;
    std::size_t branches = 0;
    std::size_t left = 0;
    for (const Curve& curve : curves()) {
        ref::PlanOptions options;
        options.sample_period_s = 400e-6;
        const Plan any = make_plan(curve.program, curve.machine, options);
        options.core.branch_steps = 2;
        const Plan loaded = make_plan(curve.program, curve.machine, options);
        before += hurried(any);
        branches += any.branches.size();
        left += loaded.branches.size();
        EXPECT_EQ(hurried(loaded), 0) << curve.name;
    }
    EXPECT_GT(before, 0);
    EXPECT_GT(left, branches - static_cast<std::size_t>(before)) << "others take their place";
}

// The ticks of the profile that a hold takes are those that the core must have queued.
TEST(PlannedBranches, PassNoMoreOfTheProfileThanTheGuardKeeps) {
    for (const Curve& curve : curves()) {
        const Plan plan = make_plan(curve.program, curve.machine, {});
        for (std::uint64_t tick = 1; tick < ticks(plan); tick += ticks(plan) / 19 + 1) {
            HoldRun run(plan, curve.machine);
            for (std::uint64_t k = 0; k < tick; ++k) run.tick(kOne);
            double passed = 0;
            for (std::int32_t rate = 1; rate != 0;) passed += (rate = run.tick(0)) / 65536.;
            EXPECT_LE(passed, plan.stop_ticks) << curve.name << " " << tick;
        }
    }
}

TEST(PlannedBranches, TakenElsewhereBreakTheLimits) {
    Plan plan = make_plan(fast_arc(10, 6 * M_PI, 12), Machine(), {});
    for (std::size_t i = 0; i + 4 < plan.branches.size(); ++i) {
        plan.branches[i].steps = plan.branches[i + 4].steps;
    }
    double worst = 0;
    for (std::uint64_t tick = 500; tick < ticks(plan); tick += ticks(plan) / 17) {
        worst = std::max(worst, hold(plan, Machine(), tick, false).loads.most());
    }
    EXPECT_GT(worst, 1);
}

}  // namespace curvecore::tb::planned_branches_test
