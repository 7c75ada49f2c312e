// SPDX-License-Identifier: Apache-2.0
// Moves that take long are cut into parts, which have the same path.
#include "ref/limits/move_parts.hpp"

#include <gtest/gtest.h>

#include "ref/moves/move_part.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::move_parts_test {

using ref::Machine;
using ref::Move;
using ref::Program;

std::vector<Move> parts_of(const Program& program, const Machine& machine = {}) {
    ref::MoveParts parts(source_of(program), machine);
    std::vector<Move> all;
    for (Move move; parts.next(move);) all.push_back(move);
    return all;
}

/// A line, a helix, a cubic and auxiliary axes alone, some minutes each.
Program slow_moves() {
    ProgramBuilder builder;
    builder.line({40, 30, 0}, 0.1);
    builder.arc({30, 30, 0}, {0, 0.1, 1}, 5, 3, 0.1);
    const ref::Vec3 at = builder.at();
    builder.cubic(at + ref::Vec3(20, 0, 0), at + ref::Vec3(20, 30, 10), at + ref::Vec3(0, 40, 0),
                  0.1);
    builder.line(builder.at(), 0.1).aux_end[0] = 90;
    for (Move& move : builder.program().moves) {
        move.exact_stop = true;
        move.dwell = 2;
    }
    return builder.program();
}

TEST(MoveParts, AreTheMove) {
    const Program program = slow_moves();
    const std::vector<Move> parts = parts_of(program);
    std::size_t next = 0;
    for (const Move& move : program.moves) {
        const std::size_t first = next;
        double s = 0;
        while (next < parts.size() && parts[next].line == move.line) {
            const Move& part = parts[next++];
            EXPECT_LE(part.length(), 20 * (1 + 1e-9)) << "200 s at 0.1 mm/s";
            const bool last = next == parts.size() || parts[next].line != move.line;
            EXPECT_EQ(part.exact_stop, last);
            EXPECT_EQ(part.dwell, last ? 2 : 0);
            EXPECT_NEAR(part.aux_start[0], move.aux_end[0] * s / move.length(), 1e-9);
            for (const double of : {0.0, 0.3, 1.0}) {
                if (move.start == move.end) break;  // auxiliary axes alone
                const double along = of * part.length();
                const ref::MovePlace here = place_on(part, along);
                const ref::MovePlace there = place_on(move, s + along);
                EXPECT_LT((here.position - there.position).norm(), 1e-8) << move.line;
                EXPECT_LT((here.tangent - there.tangent).norm(), 1e-8) << move.line;
            }
            s += part.length();
        }
        EXPECT_GE(next - first, 2U);
        EXPECT_NEAR(s, move.length(), 1e-8);
        EXPECT_EQ(parts[first].start, move.start);
        EXPECT_EQ(parts[next - 1].end, move.end);
        EXPECT_EQ(parts[next - 1].aux_end, move.aux_end);
    }
    EXPECT_EQ(next, parts.size());
}

TEST(MoveParts, LeaveQuickMovesAsTheyAre) {
    Program program = slow_moves();
    for (Move& move : program.moves) move.feed = 1;
    EXPECT_EQ(parts_of(program).size(), program.moves.size());
}

/// Many turns have many knots, at any feed; more so where an axis is slow.
TEST(MoveParts, CutManyTurns) {
    ProgramBuilder builder;
    builder.arc({-10, 0, 0}, {0, 0, 1}, 100 * M_PI, 50, 500);
    const std::size_t even = parts_of(builder.program()).size();
    Machine machine;
    machine.axis[1].velocity = 50;
    const std::size_t slow = parts_of(builder.program(), machine).size();
    EXPECT_GE(even, 2U);
    EXPECT_GE(slow, 2 * even);
}

}  // namespace curvecore::tb::move_parts_test
