// SPDX-License-Identifier: Apache-2.0
// Canned cycles and threads, move by move, as LinuxCNC 2.9 executes the same blocks, worked out by
// hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::tb::canned_cycles_test {

using ref::Move;
using ref::Program;

constexpr const char* kBegin = "G21 G90 F60 S120 M3\nG0 X1 Y2 Z10\n";

Program read(const std::string& text) { return ref::read_gcode_text(kBegin + text, "part.ngc"); }

std::string number(double value) {
    return fmt::format("{:.10g}", std::round(value * 1e6) / 1e6 + 0.0);
}

/// Text of the moves after the first: "Rx,y,z" for a rapid, "Fx,y,z" at the feed, "Fx,y,z@f" at
/// another; '.' follows a move that ends at rest, with the seconds of a dwell.
std::string moves(const std::string& text) {
    const Program program = read(text);
    std::string said;
    for (std::size_t i = 1; i < program.moves.size(); ++i) {
        const Move& move = program.moves[i];
        said += fmt::format("{}{}{},{},{}", said.empty() ? "" : " ", move.rapid ? "R" : "F",
                            number(move.end.x()), number(move.end.y()), number(move.end.z()));
        if (!move.rapid && move.feed != 1) said += "@" + number(move.feed);
        const bool last = i + 1 == program.moves.size();
        if (move.exact_stop && !last) said += ".";
        if (move.dwell > 0) said += number(move.dwell);
    }
    return said;
}

std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "nothing is wrong";
}

TEST(CannedCycles, DrillAndReturnToWhereTheRowBeganOrToR) {
    EXPECT_EQ(moves("G98 G81 X3 Y4 Z-5 R1\nX5\nG80 G0 X0"),
              "R3,4,10 R3,4,1 F3,4,-5 R3,4,10 R5,4,10 R5,4,1 F5,4,-5 R5,4,10 R0,4,10");
    EXPECT_EQ(moves("G99 G81 X3 Y4 Z-5 R1\nX5\nG80 G0 X0"),
              "R3,4,10 R3,4,1 F3,4,-5 R3,4,1 R5,4,1 F5,4,-5 R5,4,1 R0,4,1");
    EXPECT_EQ(moves("G81 X3 Y4 Z-5 R1"), "R3,4,10 R3,4,1 F3,4,-5 R3,4,1") << "G99 at first";
}

TEST(CannedCycles, AreKeptForLaterPlacesByL0) {
    EXPECT_EQ(moves("G99 G81 Z-5 R1 L0\nX3 Y4"), "R3,4,10 R3,4,1 F3,4,-5 R3,4,1");
}

TEST(CannedCycles, GoToThePlaceWithEveryAxis) {
    const Program program = read("G99 G81 A30 Z-5 R1\nA60");
    ASSERT_EQ(program.moves.size(), 8U);
    EXPECT_TRUE(program.moves[1].rapid);
    EXPECT_EQ(program.moves[1].aux_end[0], 30);
    EXPECT_EQ(program.moves[7].aux_end[0], 60);
}

TEST(CannedCycles, RiseToRFirstWhereTheyBeginBelow) {
    EXPECT_EQ(moves("G0 Z0\nG98 G81 X3 Y4 Z-5 R1"), "R1,2,0 R1,2,1 R3,4,1 F3,4,-5 R3,4,1");
}

TEST(CannedCycles, WordsStayUntilAnotherCode) {
    EXPECT_EQ(moves("G81 X3 Y4 Z-5 R1\nX5 Z-6\nY6 R2"),
              "R3,4,10 R3,4,1 F3,4,-5 R3,4,1 R5,4,1 F5,4,-6 R5,4,1 R5,6,2 F5,6,-6 R5,6,2");
    EXPECT_EQ(refusal("G81 X3 Z-5 R1\nG0 X0\nG81 X5 R1"),
              "part.ngc:5: error: G81 without Z (the depth)");
    EXPECT_EQ(refusal("G81 X3 Z-5"),
              "part.ngc:3: error: G81 without R (the height where rapids end)");
}

TEST(CannedCycles, G91CountsFromRAndGoesOn) {
    EXPECT_EQ(moves("G91 G81 X3 Y4 Z-5 R-2 L2"),
              "R4,6,10 R4,6,8 F4,6,3 R4,6,8 R7,10,8 F7,10,3 R7,10,8");
    EXPECT_EQ(moves("G91 G98 G81 X3 Z-5 R-2 L2"),
              "R4,2,10 R4,2,8 F4,2,3 R4,2,10 R7,2,10 R7,2,8 F7,2,3 R7,2,10");
    EXPECT_EQ(moves("G81 X3 Z-5 R1 L2"), "R3,2,10 R3,2,1 F3,2,-5 R3,2,1 F3,2,-5 R3,2,1");
}

TEST(CannedCycles, EachCodeHasItsWayDownAndUp) {
    const std::string over = "R3,4,10 R3,4,1 ";
    const auto cycle = [](const std::string& code) { return moves(code + " X3 Y4 Z-5 R1"); };
    EXPECT_EQ(cycle("G82 P.5"), over + "F3,4,-5.0.5 R3,4,1");
    EXPECT_EQ(cycle("G85"), over + "F3,4,-5 F3,4,1");
    EXPECT_EQ(cycle("G89 P.5"), over + "F3,4,-5.0.5 F3,4,1");
    EXPECT_EQ(cycle("G98 G85"), over + "F3,4,-5 F3,4,1 R3,4,10");
    EXPECT_EQ(cycle("G98 G89 P0"), over + "F3,4,-5 F3,4,10");
    EXPECT_EQ(cycle("G86 P.5"), over + "F3,4,-5.0.5 R3,4,1");
    EXPECT_EQ(cycle("G88 P0"), over + "F3,4,-5. R3,4,1");
    EXPECT_EQ(cycle("G84"), over + "F3,4,-5. F3,4,1");
    EXPECT_EQ(cycle("M4 G74"), "R3,4,10 R3,4,1 F3,4,-5. F3,4,1");
    EXPECT_EQ(cycle("G87 I2 J3 K-2"),
              over + "R5,7,1. R5,7,-5 R3,4,-5. F3,4,-2 F3,4,-5. R5,7,-5 R5,7,1 R3,4,1");
}

TEST(CannedCycles, PecksGoBackToRWithG83AndALittleWithG73) {
    EXPECT_EQ(moves("G83 X3 Y4 Z-3 R1 Q2"),
              "R3,4,10 R3,4,1 F3,4,-1 R3,4,1 R3,4,-0.746 F3,4,-3 R3,4,1");
    EXPECT_EQ(moves("G73 X3 Y4 Z-3 R1 Q1.5 D.5"),
              "R3,4,10 R3,4,1 F3,4,-0.5 R3,4,0 F3,4,-2 R3,4,-1.5 F3,4,-3 R3,4,1");
    EXPECT_EQ(refusal("G83 X3 Z-3 R1 Q0"), "part.ngc:3: error: Q of G83 must be above 0");
    EXPECT_EQ(refusal("G83 X3 Z-3 R1 Q.0001"),
              "part.ngc:3: error: G83: more than 20000 pecks in one block");
}

TEST(CannedCycles, StandInEveryPlaneAndTurnWithTheSystem) {
    EXPECT_EQ(moves("G18 G98 G81 X3 Z4 Y-5 R1"), "R3,2,4 R3,1,4 F3,-5,4 R3,2,4");
    EXPECT_EQ(moves("G19 G81 Y3 Z4 X-5 R0"), "R1,3,4 R0,3,4 F-5,3,4 R0,3,4");
    EXPECT_EQ(moves("G10 L2 P1 R90\nG81 X3 Y4 Z-5 R1"), "R-4,3,10 R-4,3,1 F-4,3,-5 R-4,3,1");
    EXPECT_EQ(moves("G10 L2 P1 X100\nG81 X3 Y4 Z-5 R1"), "R103,4,10 R103,4,1 F103,4,-5 R103,4,1");
}

TEST(CannedCycles, AreDrawnExactlyAndLeaveThePathsModeAsItWas) {
    const Program program = read("G64 P.1\nG81 X3 Z-5 R1\nG1 X0\nX1");
    EXPECT_EQ(program.moves[1].tolerance, 0);
    EXPECT_EQ(program.moves[4].tolerance, 0);
    EXPECT_EQ(program.moves[5].tolerance, 0.1);
}

TEST(CannedCycles, SayWhatIsWrong) {
    EXPECT_EQ(refusal("G81 X3 Z-5 R-6"), "part.ngc:3: error: G81: R is below the depth Z");
    EXPECT_EQ(refusal("G93 G81 X3 Z-5 R1 F1"), "part.ngc:3: error: G81 and G93 exclude each other");
    EXPECT_EQ(refusal("M5\nG86 X3 Z-5 R1 P0"),
              "part.ngc:4: error: G86 wants the spindle to turn: M3 or M4 before it");
    EXPECT_EQ(refusal("M4\nG84 X3 Z-5 R1"),
              "part.ngc:4: error: G84 wants the spindle to turn: M3 before it");
    EXPECT_EQ(refusal("G82 X3 Z-5 R1"),
              "part.ngc:3: error: G82 without P (seconds of rest; 0 for none)");
    EXPECT_EQ(refusal("G81 X3 Z-5 R1 L-1"),
              "part.ngc:3: error: L must be a whole number from 0 to 9999, not -1");
    EXPECT_EQ(refusal("G81"), "part.ngc:3: error: G81 without axis words");
}

/// The spindle makes 120 turns a minute: K mm a turn is 2 K mm/s.
TEST(Threads, LinesAndTapsGoSoFarForEachTurn) {
    EXPECT_EQ(moves("G33 Z-5 K1.5\nX5 K2\nG1 X9"), "F1,2,-5@3 F5,2,-5@4 F9,2,-5");
    EXPECT_EQ(moves("G33.1 Z-5 K1.5\nG0 X0"), "F1,2,-5@3. F1,2,10@3. R0,2,10");
    EXPECT_EQ(refusal("G33 Z-5"), "part.ngc:3: error: G33 without K (the way for each turn)");
    EXPECT_EQ(refusal("M5 G33 Z-5 K1"),
              "part.ngc:3: error: G33 wants the spindle to turn: S and M3 or M4 before it");
}

/// The drive line is at X 20; the peak 2 below it, the full depth 1 below the peak.
TEST(Threads, G76CutsInPassesOfEqualDepthOrArea) {
    const std::string start = "R20,0,5 ";
    const auto pass = [](double depth) {
        return fmt::format("R{0},0,5 R{1},0,5 F{1},0,-10@3 R{0},0,-10", number(21 - depth),
                           number(18 - depth));
    };
    EXPECT_EQ(moves("G0 X20 Y0 Z5\nG76 P1.5 Z-10 I-2 J.5 K1"), start + pass(0.5) + " " + pass(1));
    EXPECT_EQ(moves("G0 X20 Y0 Z5\nG76 P1.5 Z-10 I-2 J.5 K1 R2 H1"),
              start + pass(0.5) + " " + pass(0.5 * std::sqrt(2.0)) + " " +
                  pass(0.5 * std::sqrt(3.0)) + " " + pass(1) + " " + pass(1));
    EXPECT_EQ(moves("G7 G0 X40 Y0 Z5\nG76 P1.5 Z-10 I-4 J1 K2"), start + pass(0.5) + " " + pass(1));
}

/// I above 0 puts the thread on the outside of the drive line. Tapers of E along Z rise by K, at
/// the pitch of their slope. Q shifts passes along Z.
TEST(Threads, G76BoresTapersAndCutsAtAnAngle) {
    const std::string slope = "@" + number(3 * std::sqrt(2.0));
    const auto pass = [&slope](double x) {
        return fmt::format("R{0},0,5 F{1},0,5{3} F{2},0,4{3} F{2},0,-9@3 F{1},0,-10{3} R{0},0,-10",
                           number(x - 3), number(x - 1), number(x), slope);
    };
    EXPECT_EQ(moves("G0 X20 Y0 Z5\nG76 P1.5 Z-10 I2 J.5 K1 E1 L3"),
              "R20,0,5 " + pass(22.5) + " " + pass(23));
    EXPECT_EQ(moves("G0 X20 Y0 Z5\nG76 P1.5 Z-10 I-2 J.5 K1 Q45"),
              "R20,0,5 R20.5,0,4.5 R17.5,0,4.5 F17.5,0,-9.5@3 R20.5,0,-9.5 "
              "R20,0,4 R17,0,4 F17,0,-10@3 R20,0,-10");
    EXPECT_EQ(refusal("G76 P1 Z-5 I0 J1 K2"), "part.ngc:3: error: I of G76 must not be 0");
    EXPECT_EQ(refusal("G76 P1 Z-5 I-1 J1"),
              "part.ngc:3: error: G76 wants P (pitch), I (peak), J (first cut) and K (full depth)");
    EXPECT_EQ(refusal("G76 P1 Z-5 I-1 J.001 K9 R3"),
              "part.ngc:3: error: G76 wants more than 2000 passes");
}

}  // namespace curvecore::tb::canned_cycles_test
