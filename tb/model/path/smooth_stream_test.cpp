// SPDX-License-Identifier: Apache-2.0
// A path made smooth in windows: as good as in one window, wherever it is cut.
#include "ref/path/smooth_stream.hpp"

#include <gtest/gtest.h>

#include "ref/feed/planner.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/judge/frechet.hpp"
#include "tb/support/programs/random_lines.hpp"

namespace curvecore::tb::smooth_stream_test {

using ref::Machine;
using ref::Move;
using ref::Program;
using ref::Smoothed;
using ref::SmoothStream;

struct Drawn {
    Program program;
    Smoothed report;
    std::string error;
    bool refused = false;
};

Drawn drawn(const Program& program, std::size_t window, std::size_t fails = 1000000,
            const ref::MovesCheck& carried = {}) {
    const auto source = [&program, fails, next = std::size_t(0)](Move& move) mutable {
        if (next == fails) throw ref::InputError("part.ngc", 7, "is odd");
        if (next == program.moves.size()) return false;
        move = program.moves[next++];
        return true;
    };
    SmoothStream stream(source, Machine(), 1, carried, window);
    Drawn all;
    all.program = program;
    all.program.moves.clear();
    try {
        for (Move move; stream.next(move);) all.program.moves.push_back(move);
    } catch (const ref::InputError& refused) {
        all.error = refused.what();
    }
    all.report = stream.report();
    all.refused = stream.refused();
    return all;
}

void expect_joined(const std::vector<Move>& moves) {
    for (std::size_t i = 1; i < moves.size(); ++i) {
        EXPECT_LT((moves[i].start - moves[i - 1].end).norm(), 1e-9) << i;
    }
}

double duration(const Program& program) {
    ref::PlanOptions options;
    options.effort = ref::Effort::kRules;
    return ref::make_plan(program, Machine(), options).duration_s;
}

/// Random lines, in windows so short that most of the possible curves are cut.
TEST(SmoothStream, KeepsTheToleranceWhereverItIsCut) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const double tolerance = seed % 2 == 0 ? 0.01 : 0.1;
        const Program program = with_tolerance(random_lines(seed), tolerance);
        const Drawn all = drawn(program, 24);
        expect_joined(all.program.moves);
        EXPECT_EQ(all.program.moves.front().start, program.moves.front().start);
        EXPECT_LT((all.program.moves.back().end - program.moves.back().end).norm(), 1e-12);
        EXPECT_LE(all.report.share, 1 + 1e-12);
        EXPECT_EQ(all.report.moves, program.moves.size());
        const double fine = tolerance / 20;
        EXPECT_LE(frechet(polyline(program.moves, fine), polyline(all.program.moves, fine),
                          1.1 * tolerance),
                  1.05 * tolerance);
    }
}

/// A wave of 60 mm.
Program wave_in_chords() {
    ProgramBuilder builder;
    for (int i = 1; i <= 3000; ++i) {
        const double x = 0.02 * i;
        builder.line({x, std::round(3e4 * std::sin(x)) / 1e4, 0}, 500);
    }
    return with_tolerance(builder.program(), 0.005);
}

/// One curve, cut in its middle.
TEST(SmoothStream, PassesACutInACurve) {
    const Program program = wave_in_chords();
    const Drawn whole = drawn(program, program.moves.size() + 1);
    const Drawn parts = drawn(program, 400);
    EXPECT_EQ(whole.report.curves, 1U);
    EXPECT_GE(parts.report.curves, 8U);
    EXPECT_LE(parts.report.share, 1 + 1e-12);
    expect_joined(parts.program.moves);
    for (std::size_t i = 1; i < parts.program.moves.size(); ++i) {  // C2
        const Move& before = parts.program.moves[i - 1];
        const ref::MovePlace one = ref::place_on(before, before.length());
        const ref::MovePlace two = ref::place_on(parts.program.moves[i], 0);
        EXPECT_LT((one.tangent - two.tangent).norm(), 1e-6) << i;
        EXPECT_LT((one.curvature - two.curvature).norm(), 1e-4) << i;
    }
    EXPECT_LE(duration(parts.program), 1.05 * duration(whole.program));
}

/// Half circles, each 1 to 100 pieces of the programmed path.
TEST(SmoothStream, ReadsFewMovesAheadThatHaveManyPieces) {
    for (const double radius : {0.1, 5.0, 500.0}) {
        ProgramBuilder builder;
        for (int i = 0; i < 300; ++i) {
            const double x = 2 * radius * i + radius;
            builder.arc({x, 0, 0}, {0, 0, i % 2 == 0 ? 1.0 : -1.0}, M_PI, 0, 100);
        }
        const Program program = with_tolerance(builder.program(), 0.01);
        const std::size_t parts = ref::PathJoints::parts(program.moves.front(), 0.01);
        SmoothStream stream(ref::source_of(program), Machine(), 1, {}, 200);
        Move move;
        ASSERT_TRUE(stream.next(move));
        EXPECT_EQ(stream.report().moves, std::min<std::size_t>(200, (3200 + parts - 1) / parts) + 1)
            << radius << " mm, " << parts;
    }
}

TEST(SmoothStream, DrawsAsProgrammedWhatIsRefused) {
    const Program program = wave_in_chords();
    const double middle = program.moves[1500].end[0];
    const auto carried = [middle](const std::deque<Move>& moves) {
        return middle < moves.front().start[0] || middle > moves.back().end[0];
    };
    const Drawn all = drawn(program, 400, 1000000, carried);
    const Drawn smooth = drawn(program, 400);
    EXPECT_TRUE(all.refused);
    EXPECT_FALSE(smooth.refused);
    EXPECT_LT(all.report.curves, smooth.report.curves);
    EXPECT_GT(all.report.curves, 2U);
    expect_joined(all.program.moves);
    EXPECT_LT((all.program.moves.back().end - program.moves.back().end).norm(), 1e-12);
    std::size_t lines = 0;
    for (const Move& move : all.program.moves) {
        if (move.kind != Move::Kind::kLine) continue;
        ++lines;
        EXPECT_EQ(move.deviation, 0);
        EXPECT_LT(std::abs(move.end[0] - middle), 0.02 * 400);
    }
    EXPECT_GT(lines, 100U);
    EXPECT_LE(frechet(polyline(program.moves, 2e-4), polyline(all.program.moves, 2e-4), 0.006),
              0.0052);
}

TEST(SmoothStream, GivesAllThatCameBeforeAFault) {
    const Program program = with_tolerance(random_lines(2), 0.01);
    for (const std::size_t fails : {std::size_t(1), std::size_t(30), std::size_t(100)}) {
        const Drawn some = drawn(program, 24, fails);
        EXPECT_EQ(some.error, "part.ngc:7: error: is odd");
        EXPECT_LT((some.program.moves.back().end - program.moves[fails - 1].end).norm(), 1e-12);
    }
    EXPECT_TRUE(drawn(program, 24, 0).program.moves.empty());
}

}  // namespace curvecore::tb::smooth_stream_test
