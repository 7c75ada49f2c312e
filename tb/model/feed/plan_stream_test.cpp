// SPDX-License-Identifier: Apache-2.0
// A program planned in parts: the same path, within the limits, hardly slower, wherever it is cut.
#include "ref/feed/plan_stream.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/planner.hpp"
#include "ref/path/smooth_path.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/judge/hold_run.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/programs/random_lines.hpp"

namespace curvecore::tb::plan_stream_test {

using ref::Effort;
using ref::InputError;
using ref::Machine;
using ref::Move;
using ref::Plan;
using ref::PlanOptions;
using ref::PlanStream;
using ref::Program;
using ref::source_of;

PlanOptions options(Effort effort) {
    PlanOptions options;
    options.format.splines = 1;
    options.aux_axes = 0;
    options.effort = effort;
    return options;
}

/// Speed at the ends of a piece, mm/s.
double speed(const Plan& plan, const ref::ProfilePiece& piece, double ticks) {
    return ref::piece_state(piece, ticks).v * plan.unit_mm / 65536 / plan.tick_s;
}

/// All parts joined as one plan.
struct Joined {
    Plan plan;
    std::size_t parts = 0;
    std::size_t forced_stops = 0;
    double jump = 0;                  // of speed between parts, mm/s
    std::vector<std::uint64_t> ends;  // ends of the parts, ticks
    std::string error;

    Joined() = default;
    Joined(const Program& program, PlanOptions options, std::size_t window, ref::MoveSource source,
           double raise = 1) {
        options.window = window;
        PlanStream stream(std::move(source), {program.file, program.aux_axes, 1e9}, Machine{},
                          options);
        try {
            while (std::optional<Plan> part = stream.next()) {
                append(std::move(*part));
                if (parts == 2) stream.raise_feed(raise);
            }
        } catch (const InputError& refused) {
            error = refused.what();
            EXPECT_FALSE(stream.next());
        }
        forced_stops = stream.forced_stops();
    }

    void append(Plan part) {
        const auto ticks = static_cast<std::uint64_t>(ref::ticks_of(part.pieces));
        ends.push_back(ticks + (ends.empty() ? 0 : ends.back()));
        if (parts++ == 0) {
            plan = std::move(part);
            return;
        }
        jump = std::max(jump, std::abs(speed(part, part.pieces.front(), 0) -
                                       speed(plan, plan.pieces.back(), plan.pieces.back().ticks)));
        EXPECT_EQ(part.hold_acceleration, plan.hold_acceleration);
        EXPECT_EQ(part.stop_ticks, plan.stop_ticks);
        plan.duration_s += part.duration_s;
        for (ref::PlannedBranch& branch : part.branches) {
            branch.piece += plan.pieces.size();
            plan.branches.push_back(std::move(branch));
        }
        plan.segments.insert(plan.segments.end(), part.segments.begin(), part.segments.end());
        plan.pieces.insert(plan.pieces.end(), part.pieces.begin(), part.pieces.end());
    }
};

Joined joined(const Program& program, const PlanOptions& options, std::size_t window) {
    return {program, options, window, source_of(program)};
}

/// Checks that flags, ticks and path lengths are consistent.
void expect_whole(const Plan& plan) {
    std::uint64_t path = 0;
    std::uint64_t ticks = 0;
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
        const ref::Segment& segment = plan.segments[i];
        EXPECT_EQ(segment.s_start, path) << i;
        EXPECT_EQ(segment.last, i + 1 == plan.segments.size()) << i;
        path += segment.length;
        ticks += segment.ticks;
    }
    for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
        path -= plan.pieces[i].ds;
        ticks -= plan.pieces[i].ticks;
        EXPECT_EQ(plan.pieces[i].final, i + 1 == plan.pieces.size()) << i;
    }
    EXPECT_EQ(path, 0U);
    EXPECT_EQ(ticks, 0U);
    EXPECT_LT(speed(plan, plan.pieces.back(), plan.pieces.back().ticks), 1e-3);
}

/// Compares the paths of two plans: with different cuts they differ by a quantum.
void expect_same_path(const Plan& one, const Plan& other) {
    ASSERT_EQ(one.segments.size(), other.segments.size());
    for (std::size_t i = 0; i < one.segments.size(); ++i) {
        const ref::Segment& a = one.segments[i];
        const ref::Segment& b = other.segments[i];
        EXPECT_LE(std::abs(static_cast<double>(a.length) - static_cast<double>(b.length)), 1);
        EXPECT_EQ(a.start, b.start);
        EXPECT_EQ(a.end, b.end);
        EXPECT_EQ(a.move, b.move);
        EXPECT_EQ(a.line, b.line);
    }
}

Program smooth_lines(unsigned seed) {
    Program program = with_tolerance(random_lines(seed), 0.01);
    ref::smooth_path(program, Machine{});
    return program;
}

/// Random programs in windows of a few tenths of a second: cuts everywhere, and windows that cannot
/// continue.
TEST(PlanStream, KeepsLimitsWhereverItIsCut) {
    std::size_t parts = 0;
    std::size_t forced = 0;
    const int programs = cases(6, 16);
    for (int seed = 0; seed < programs; ++seed) {
        for (const Effort effort : {Effort::kRules, Effort::kOptimum}) {
            const std::string which =
                fmt::format("seed {} effort {}", seed, static_cast<int>(effort));
            SCOPED_TRACE(which);
            const Program program = seed % 3 == 0 ? random_lines(seed) : smooth_lines(seed);
            const Joined all = joined(program, options(effort), seed % 2 == 0 ? 40 : 70);
            EXPECT_EQ(all.error, "");
            expect_whole(all.plan);
            expect_same_path(all.plan, ref::make_plan(program, Machine{}, options(Effort::kRules)));
            EXPECT_LT(all.jump, 1e-6);
            const sysc::LimitLoads loads = drawn_limits(all.plan, Machine{});
            EXPECT_LE(loads.most(), 1) << text(loads);
            parts += all.parts;
            forced += all.forced_stops;
        }
    }
    EXPECT_GT(parts, 15U * programs);
    EXPECT_GT(forced, 0U);
}

/// A raster of short chords over a surface, which never stops.
Program surface(int moves) {
    ProgramBuilder builder;
    double x = 0;
    double y = 0;
    double step = 0.2;
    for (int i = 0; i < moves; ++i) {
        x += step;
        if (x > 40 || x < 0) {
            step = -step;
            x += step;
            y += 0.5;
        }
        const double z = 3 * std::sin(x / 5) * std::cos(y / 7);
        builder.line({std::round(x * 1e4) / 1e4, y, std::round(z * 1e4) / 1e4}, 50);
    }
    Program program = with_tolerance(builder.program(), 0.01);
    ref::smooth_path(program, Machine{});
    return program;
}

TEST(PlanStream, IsHardlySlowerThanTheWholePlan) {
    const Program program = surface(6000);
    for (const Effort effort : {Effort::kRules, Effort::kOptimum}) {
        const Plan whole = joined(program, options(effort), program.moves.size() + 1).plan;
        const Joined all = joined(program, options(effort), 300);
        EXPECT_GE(all.parts, 4U);
        EXPECT_EQ(all.forced_stops, 0U);
        EXPECT_LE(all.plan.duration_s, 1.005 * whole.duration_s);
        EXPECT_LE(drawn_limits(all.plan, Machine{}).most(), 1);
    }
}

TEST(PlanStream, HasFewerLongMovesInAWindow) {
    ProgramBuilder builder;
    for (int i = 1; i <= 200; ++i) builder.line({i % 2 * 400.0 + i % 7, i % 11 * 5.0, 0}, 500);
    Program program = with_tolerance(builder.program(), 0.1);
    ref::smooth_path(program, Machine{});
    const Plan whole = joined(program, options(Effort::kRules), 100000).plan;
    const Joined all = joined(program, options(Effort::kRules), 400);
    EXPECT_GE(all.parts, 4U);
    EXPECT_EQ(all.forced_stops, 0U);
    EXPECT_LE(all.plan.duration_s, 1.001 * whole.duration_s);
    EXPECT_LE(drawn_limits(all.plan, Machine{}).most(), 1);
}

/// Moves may take long and have many stretches.
TEST(PlanStream, HasAsMuchInAWindowAsThereIsMemoryFor) {
    ProgramBuilder slow;
    for (int i = 1; i <= 600; ++i) slow.line({i * 0.2, i % 2 * 0.01, 0}, 0.02);  // 10 s each
    ProgramBuilder corners;
    for (int i = 1; i <= 500; ++i) corners.line({i % 2 * 0.5, i * 0.2, 0}, 100);
    for (ProgramBuilder* builder : {&slow, &corners}) {
        Program program = with_tolerance(builder->program(), 0.005);
        ref::smooth_path(program, Machine{});
        const Joined all = joined(program, options(Effort::kOptimum), PlanOptions().window);
        EXPECT_GE(all.parts, 2U);
        EXPECT_EQ(all.forced_stops, 0U);
        EXPECT_LT(all.jump, 1e-6);
        expect_whole(all.plan);
    }
}

/// The feed rises in the middle of motion; parts already given stay.
TEST(PlanStream, RaisesTheFeedOfWhatFollows) {
    for (const unsigned seed : {1U, 2U, 4U}) {
        for (const Effort effort : {Effort::kRules, Effort::kOptimum}) {
            SCOPED_TRACE(fmt::format("seed {} effort {}", seed, static_cast<int>(effort)));
            Program program = with_tolerance(smooth_lines(seed), 0.01);
            for (Move& move : program.moves) move.feed = 20;
            ref::smooth_path(program, Machine{});
            const PlanOptions with = options(effort);
            const Joined before = joined(program, with, 50);
            const Joined all(program, with, 50, source_of(program), 10);
            expect_whole(all.plan);
            expect_same_path(all.plan, before.plan);
            EXPECT_LT(all.jump, 1e-6);
            EXPECT_LE(drawn_limits(all.plan, Machine{}).most(), 1);
            ASSERT_GE(all.ends.size(), 3U);
            EXPECT_EQ(all.ends[1], before.ends[1]);
            EXPECT_LT(all.plan.duration_s, 0.8 * before.plan.duration_s);
        }
    }
}

TEST(PlanStream, RaisesNoFeedBeyondTheFastest) {
    ProgramBuilder builder;
    builder.line({100, 0, 0}, 20);
    const Program program = builder.program();
    for (const double fastest : {20., 30., 1e9}) {
        PlanStream stream(source_of(program), {program.file, 0, fastest}, Machine{},
                          options(Effort::kRules));
        stream.raise_feed(2);
        stream.raise_feed(1.2);
        const std::optional<Plan> plan = stream.next();
        EXPECT_NEAR(plan->duration_s, 100 / std::min(fastest, 40.), 0.1) << fastest;
    }
}

/// Dwells and stops at the places of cuts.
TEST(PlanStream, KeepsRests) {
    Program program = random_lines(3);
    double dwells = 0;
    for (std::size_t i = 5; i < program.moves.size(); i += 9) {
        program.moves[i].dwell = 0.01;
        dwells += 0.01;
    }
    const Joined all = joined(program, options(Effort::kRules), 10);
    const Plan whole = ref::make_plan(program, Machine{}, options(Effort::kRules));
    expect_whole(all.plan);
    EXPECT_GE(all.parts, 10U);
    double rest = 0;
    for (const ref::ProfilePiece& piece : all.plan.pieces) {
        if (piece.ds == 0) rest += piece.ticks * all.plan.tick_s;
    }
    EXPECT_NEAR(rest, dwells, 1e-9);
    EXPECT_NEAR(all.plan.duration_s, whole.duration_s, 0.1 * whole.duration_s);
}

TEST(PlanStream, EndsAtRestBeforeWhatItCannotRead) {
    const Program program = smooth_lines(2);
    for (const std::size_t fails : {std::size_t(1), std::size_t(100), std::size_t(290)}) {
        const ref::MoveSource good = source_of(program);
        const Joined all{program, options(Effort::kOptimum), 60,
                         [good, fails, read = std::size_t(0)](Move& move) mutable {
                             if (read++ == fails) throw InputError("part.ngc", 7, "is odd");
                             return good(move);
                         }};
        EXPECT_EQ(all.error, "part.ngc:7: error: is odd");
        expect_whole(all.plan);
        EXPECT_EQ(all.plan.segments.back().move, fails - 1);
    }
}

TEST(PlanStream, EndsAtRestBeforeWhatTheMachineCannotDo) {
    for (const std::size_t fails : {std::size_t(1), std::size_t(100), std::size_t(149)}) {
        Program program = random_lines(4);
        program.moves[fails].end.x() = 2000;
        program.moves[fails].line = 77;
        const Joined all = joined(program, options(Effort::kRules), 40);
        EXPECT_NE(all.error.find(":77: error: X"), std::string::npos) << all.error;
        expect_whole(all.plan);
        EXPECT_EQ(all.plan.segments.back().move, fails - 1);
    }
}

TEST(PlanStream, EndsWithAProgramThatCannotBePlanned) {
    Program program = random_lines(5);
    program.moves.front().dwell = 1e9;
    const Joined all = joined(program, options(Effort::kRules), program.moves.size() + 1);
    EXPECT_EQ(all.parts, 0U);
    EXPECT_NE(all.error.find("a dwell of 2^31 ticks"), std::string::npos) << all.error;
}

TEST(PlanStream, OfNothingIsRefused) {
    Program program;
    program.file = "part.ngc";
    EXPECT_EQ(joined(program, options(Effort::kRules), 10).error,
              "part.ngc: error: the program moves nothing");
    Program odd = random_lines(1);
    odd.moves.front().end.x() = 2000;
    EXPECT_EQ(joined(odd, options(Effort::kRules), 10).parts, 0U);
}

/// Parts planned without knowledge of the next are no faster than any plan may continue. Holds
/// before cuts, by branches and by the bounds of the whole program.
TEST(PlanStream, HoldsKeepTheLimitsAcrossCuts) {
    std::size_t branches = 0;
    const int programs = cases(2, 4);
    for (int seed = 1; seed <= programs; ++seed) {
        const Joined all = joined(smooth_lines(seed), options(Effort::kOptimum), 60);
        branches += all.plan.branches.size();
        for (std::size_t part = 0; part + 1 < all.ends.size(); part += all.ends.size() / 5 + 1) {
            for (const std::uint64_t before : {10, 60, 150, 300, 600}) {
                HoldRun run(all.plan, Machine{});
                for (std::uint64_t tick = 0; tick + before < all.ends[part]; ++tick) {
                    run.tick(1 << 16);
                }
                EXPECT_LE(run.stop(), 2 * all.plan.stop_ticks);
                for (int tick = 0; tick < 100; ++tick) run.tick(0);
                while (run.active()) run.tick(1 << 16);
                const sysc::LimitLoads loads = run.finish();
                EXPECT_LE(loads.most(), 1) << seed << " " << part << " " << text(loads);
            }
        }
    }
    EXPECT_GT(branches, 12U * programs);
}

TEST(PlanStream, BoundsHoldsByTheFastestMotion) {
    const Program program = smooth_lines(6);
    const auto bounds = [&](double fastest) {
        PlanOptions some = options(Effort::kOptimum);
        some.window = 100;
        PlanStream stream(source_of(program), {program.file, 0, fastest}, Machine{}, some);
        return *stream.next();
    };
    const Plan whole = ref::make_plan(program, Machine{}, options(Effort::kOptimum));
    const Plan any = bounds(1e9);
    EXPECT_GE(any.stop_ticks, whole.stop_ticks);
    EXPECT_LT(bounds(100).stop_ticks, any.stop_ticks);
}

}  // namespace curvecore::tb::plan_stream_test
