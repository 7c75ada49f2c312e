// SPDX-License-Identifier: Apache-2.0
// Turns of rotary axes (ref/geometry/rotary_turns.hpp): words hold the remainder of the turns.
#include "ref/geometry/rotary_turns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ref/numeric/angles.hpp"

namespace curvecore::ref::rotary_turns_test {

constexpr double kRange = 2147.483648;  // degrees that words of 32 bits and 1e-6 degrees hold

struct Turns {
    Move move;
    PlanOptions options;
    Machine machine;
    RotaryTurns turns{machine, options};

    double pieces(double from, double to) {
        move.aux_start[0] = from;
        move.aux_end[0] = to;
        return turns.pieces(move);
    }
};

TEST(RotaryTurns, FewestPiecesThatAnyBeginningLeavesRoomFor) {
    Turns t;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> far(-1e6, 1e6);
    for (int n = 0; n < 1000; ++n) {
        const double from = far(random);
        const double to = n % 2 == 0 ? far(random) : from + far(random) * 1e-2;
        const double pieces = t.pieces(from, to);
        ASSERT_LT(kTurnDegrees + std::abs(to - from) / pieces, kRange);
        if (pieces > 1) {
            ASSERT_GE(kTurnDegrees + std::abs(to - from) / (pieces - 1), kRange);
        }
    }
    EXPECT_EQ(t.pieces(5, 5), 1);
    t.machine.axis[3].rotary = false;
    EXPECT_EQ(t.pieces(-1e6, 1e6), 1);
}

TEST(RotaryTurns, WordsBeginWithinATurnOnTheirOwnSide) {
    Turns t;
    t.machine.axis[4].rotary = false;
    for (const double degrees : {0.0, 359.0, 360.0, 1081.5, -359.0, -360.0, -1081.5, 3.6e6}) {
        Segment segment;
        segment.aux_start = {degrees * 1e6, 7e9};
        segment.aux_end = {(degrees + 500) * 1e6, 8e9};
        t.turns.leave_out(segment);
        EXPECT_EQ(segment.aux_start[0], std::fmod(degrees, 360) * 1e6);
        EXPECT_EQ(segment.aux_end[0], segment.aux_start[0] + 500e6);
        EXPECT_EQ(segment.aux_turned[0], degrees * 1e6 - segment.aux_start[0]);
        EXPECT_EQ(segment.aux_start[1], 7e9);
        EXPECT_EQ(segment.aux_end[1], 8e9);
    }
}

TEST(RotaryTurns, ASplinesTurnsAreOneSegments) {
    Turns t;
    for (const double travel : {1000.0, -1787.0, 1788.0, -5000.0}) {
        t.move.aux_end[0] = travel;
        t.move.kind = Move::Kind::kLine;
        EXPECT_EQ(t.turns.beyond_words(t.move, 3), "");
        t.move.kind = Move::Kind::kCubic;
        EXPECT_EQ(t.turns.beyond_words(t.move, 3).empty(),
                  std::abs(travel) < kRange - kTurnDegrees);
    }
    t.options.format.position_bits = 29;
    t.move.kind = Move::Kind::kLine;
    EXPECT_EQ(t.turns.beyond_words(t.move, 3),
              "A: words of a turn and a segment's 0 degrees need more than PositionBits 29, or a "
              "larger unit");
    t.move.aux_end[0] = 0;
    EXPECT_EQ(t.turns.beyond_words(t.move, 3), "");
}

}  // namespace curvecore::ref::rotary_turns_test
