// SPDX-License-Identifier: Apache-2.0
// Meaning of programs: every code of the reader, against moves worked out by hand.
#include "ref/program/gcode_reader.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>

#include "ref/text/input_error.hpp"

namespace curvecore::tb::gcode_reader_test {

using ref::Move;
using ref::Program;
using ref::Vec3;

constexpr double kPi = 3.14159265358979323846;

Program read(const std::string& text) { return ref::read_gcode_text(text, "part.ngc"); }

/// The last move of a short program that begins with G21 G90 G17 G94 F600.
Move last(const std::string& text) { return read("G21 G90 G17 G94 F600\n" + text).moves.back(); }

/// Point of an arc at a fraction of its angle, from centre, normal, angle and advance alone.
Vec3 at(const Move& move, double part) {
    const Vec3 radius = move.start - move.centre;
    return move.centre + Eigen::AngleAxisd(move.angle * part, move.normal) * radius +
           move.advance * part;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " is not " << b.transpose();
}

TEST(GcodeReader, LinesAreInMillimetresAndMillimetresPerSecond) {
    const Move move = last("G1 X30 Y-4.5 Z.25 F1200");
    EXPECT_EQ(move.kind, Move::Kind::kLine);
    EXPECT_EQ(move.start, Vec3::Zero());
    EXPECT_EQ(move.end, Vec3(30, -4.5, 0.25));
    EXPECT_EQ(move.feed, 20);
    EXPECT_EQ(move.line, 2);
    EXPECT_FALSE(move.rapid);
}

TEST(GcodeReader, InchesScaleLinearAxesAndFeedButNotDegrees) {
    const Move linear = last("G20 G1 X1 A1 U1 F60");
    EXPECT_EQ(linear.end.x(), 25.4);
    EXPECT_EQ(linear.aux_end[0], 1);
    EXPECT_EQ(linear.aux_end[3], 25.4);
    EXPECT_DOUBLE_EQ(linear.feed, 25.4);
    EXPECT_DOUBLE_EQ(last("G20 G1 A90 F60").feed, 1);
    EXPECT_DOUBLE_EQ(last("G20 G1 U90 A90 F60").feed, 25.4);
}

TEST(GcodeReader, LengthIsThatOfXyzThenUvwThenAbc) {
    EXPECT_EQ(last("G1 X3 Y4 A90 U7").length(), 5);
    EXPECT_EQ(last("G1 U3 V4 A90").length(), 5);
    EXPECT_EQ(last("G1 A30 B40").length(), 50);
}

TEST(GcodeReader, MotionIsModalAndWordsMayStandInAnyOrderAndCase) {
    const Program program = read("n10 x5 g1 f600\ny5\n  / N30 z 1 . 5 (up) x+6 ; end\nG0\nX0\n");
    ASSERT_EQ(program.moves.size(), 4U);
    EXPECT_EQ(program.moves[2].end, Vec3(6, 5, 1.5));
    EXPECT_EQ(program.moves[2].line, 3);
    EXPECT_TRUE(program.moves[3].rapid);
    EXPECT_EQ(program.moves[3].feed, 0);
}

TEST(GcodeReader, IncrementalMovesAddUp) {
    const Program program = read("G91 G1 F600 X1\nX2 Y1\nG90 X1\nG91 G2 X2 Y0 I1");
    EXPECT_EQ(program.moves[1].end, Vec3(3, 1, 0));
    EXPECT_EQ(program.moves[2].end, Vec3(1, 1, 0));
    EXPECT_EQ(program.moves[3].end, Vec3(3, 1, 0));
    EXPECT_EQ(program.moves[3].centre, Vec3(2, 1, 0));
}

TEST(GcodeReader, OffsetsMoveTheProgramsZero) {
    EXPECT_EQ(last("G10 L2 P2 X10 Y20\nG55 G1 X1 Y1").end, Vec3(11, 21, 0));
    EXPECT_EQ(last("G10 L2 P0 X10\nG1 X1").end, Vec3(11, 0, 0));
    EXPECT_EQ(last("G10 L2 P9 X10\nG59.3 G1 X1").end, Vec3(11, 0, 0));
    EXPECT_EQ(last("G10 L2 P9 X10\nG59.2 G1 X1").end, Vec3(1, 0, 0));
    EXPECT_EQ(last("G10 L2 P1 X10\nG53 G1 X1").end, Vec3(1, 0, 0));
    EXPECT_EQ(last("G10 L2 P1 X10\nG53 G1 X1\nY1").end, Vec3(1, 1, 0));
    EXPECT_EQ(last("G20 G10 L2 P1 X1 A5\nG21 G1 X1").end, Vec3(26.4, 0, 0));
}

TEST(GcodeReader, G92ShiftsSuspendsAndRestores) {
    const std::string shift = "G1 X10\nG92 X0 Y-5\n";
    EXPECT_EQ(last(shift + "G1 X1 Y0").end, Vec3(11, 5, 0));
    EXPECT_EQ(last(shift + "G92.1\nG1 X1").end, Vec3(1, 0, 0));
    EXPECT_EQ(last(shift + "G92.2\nG1 X1").end, Vec3(1, 0, 0));
    EXPECT_EQ(last(shift + "G92.2\nG92.3\nG1 X1").end, Vec3(11, 0, 0));
    EXPECT_EQ(last(shift + "G92.1\nG92.3\nG1 X1").end, Vec3(1, 0, 0));
    EXPECT_EQ(last(shift + "G92.2\nG53 G1 X1").end, Vec3(1, 0, 0));
    EXPECT_EQ(last("G10 L2 P1 X3\nG1 X10\nG92 X0\nX1").end, Vec3(14, 0, 0));
}

TEST(GcodeReader, InverseTimeGivesEveryBlockItsDuration) {
    const Move line = last("G93 G1 X30 Y40 F2");
    EXPECT_DOUBLE_EQ(line.length() / line.feed, 30);
    const Move helix = last("G93 G3 X0 Y0 Z7 I5 P3 F12");
    EXPECT_DOUBLE_EQ(helix.length() / helix.feed, 5);
    const Move tilted = last("G93 G2.4 X1 Y1 Z1 F60\nX2 Y0");
    EXPECT_DOUBLE_EQ(tilted.length() / tilted.feed, 1);
    const Move back = last("G93 G1 X30 F2\nG94 X0 F60");
    EXPECT_EQ(back.feed, 1);
}

struct ArcCase {
    const char* name;
    const char* text;
    Vec3 middle;  // a point on the way
    Vec3 centre;
    double turns;
};

class Arc : public testing::TestWithParam<ArcCase> {};

TEST_P(Arc, GoesByWayOfItsMiddleToItsEnd) {
    const ArcCase& expected = GetParam();
    const Move move = last(expected.text);
    EXPECT_EQ(move.kind, Move::Kind::kArc);
    EXPECT_NEAR(move.angle, expected.turns * 2 * kPi, 1e-14);
    EXPECT_NEAR(move.normal.norm(), 1, 1e-15);
    expect_near(move.centre, expected.centre, 1e-12);
    expect_near(at(move, 0.5), expected.middle, 1e-11);
    expect_near(at(move, 1), move.end, 1e-11);
}

constexpr double kHalf = 0.70710678118654752440;

INSTANTIATE_TEST_SUITE_P(
    Of, Arc,
    testing::Values(
        ArcCase{"G2InG17", "G2 X2 I1", {1, 1, 0}, {1, 0, 0}, 0.5},
        ArcCase{"G3InG17", "G3 X2 I1", {1, -1, 0}, {1, 0, 0}, 0.5},
        ArcCase{"G2InG18", "G18 G2 X2 I1", {1, 0, -1}, {1, 0, 0}, 0.5},
        ArcCase{"G3InG18", "G18 G3 X2 I1", {1, 0, 1}, {1, 0, 0}, 0.5},
        ArcCase{"G2InG19", "G19 G2 Y2 J1", {0, 1, 1}, {0, 1, 0}, 0.5},
        ArcCase{"G3InG19", "G19 G3 Y2 J1", {0, 1, -1}, {0, 1, 0}, 0.5},
        ArcCase{"SmallRadius", "G3 X1 Y1 R1", {kHalf, 1 - kHalf, 0}, {0, 1, 0}, 0.25},
        ArcCase{"NegativeRadius", "G3 X1 Y1 R-1", {1 + kHalf, -kHalf, 0}, {1, 0, 0}, 0.75},
        ArcCase{"SmallRadiusG2", "G2 X1 Y1 R1", {1 - kHalf, kHalf, 0}, {1, 0, 0}, 0.25},
        ArcCase{"NegativeRadiusG2", "G2 X1 Y1 R-1", {-kHalf, 1 + kHalf, 0}, {0, 1, 0}, 0.75},
        ArcCase{"RadiusInG18", "G18 G2 X1 Z1 R1", {kHalf, 0, 1 - kHalf}, {0, 0, 1}, 0.25},
        ArcCase{"FullCircle", "G3 I5", {10, 0, 0}, {5, 0, 0}, 1},
        ArcCase{"FullCircleWithEnd", "G2 X0 Y0 J-5", {0, -10, 0}, {0, -5, 0}, 1},
        ArcCase{"AbsoluteCentre", "G1 X1\nG90.1 G3 X3 I2 J0", {2, -1, 0}, {2, 0, 0}, 0.5},
        ArcCase{"AbsoluteCentreWithOffset",
                "G10 L2 P1 X5\nG1 X1\nG90.1 G3 X3 I2 J0",
                {7, -1, 0},
                {7, 0, 0},
                0.5},
        ArcCase{"InInches", "G20 G3 X2 I1", {25.4, -25.4, 0}, {25.4, 0, 0}, 0.5},
        ArcCase{"Turns", "G3 X2 I1 P3", {1, -1, 0}, {1, 0, 0}, 2.5},
        ArcCase{"FullTurns", "G2 I1 P2", {0, 0, 0}, {1, 0, 0}, 2},
        ArcCase{"Helix", "G3 X2 Z4 I1", {1, -1, 2}, {1, 0, 0}, 0.5},
        ArcCase{"HelixDownG2", "G2 X2 Z-4 I1", {1, 1, -2}, {1, 0, 0}, 0.5},
        ArcCase{"HelixInG18", "G18 G2 X2 Y6 I1", {1, 3, -1}, {1, 0, 0}, 0.5},
        ArcCase{"HelixInG19", "G19 G3 Y2 X6 J1 P2", {3, 1, 1}, {0, 1, 0}, 1.5},
        ArcCase{"HelixOfFullTurns", "G3 Z8 I5 P4", {0, 0, 4}, {5, 0, 0}, 4},
        ArcCase{"ThroughAPoint", "G2.4 X1 Y1 Z0\nX2 Y0 Z0", {1, 1, 0}, {1, 0, 0}, 0.5},
        ArcCase{"ThroughAPointTheOtherWay", "G3.4 X1 Y-1\nX2 Y0", {1, -1, 0}, {1, 0, 0}, 0.5}),
    [](const auto& tested) { return tested.param.name; });

TEST(GcodeReader, ThreePointArcHoldsItsMiddleAndMayBeModalAndIncremental) {
    const Program program =
        read("G91 G1 F600 X1 Y2 Z3\nG2.4 X3 Y1 Z2\n(the end)\n\nN5 X-1 Y4 Z-1\nX1 Y1 Z3\nX1 Y-2");
    ASSERT_EQ(program.moves.size(), 3U);
    const std::array<Vec3, 2> middles = {Vec3(4, 3, 5), Vec3(4, 8, 7)};
    const std::array<Vec3, 2> ends = {Vec3(3, 7, 4), Vec3(5, 6, 7)};
    for (int i = 0; i < 2; ++i) {
        const Move& move = program.moves[i + 1];
        EXPECT_EQ(move.end, ends[i]);
        expect_near(at(move, 1), move.end, 1e-12);
        const double radius = (move.start - move.centre).norm();
        EXPECT_NEAR((middles[i] - move.centre).norm(), radius, 1e-12);
        EXPECT_NEAR(move.normal.dot(middles[i] - move.centre), 0, 1e-12);
        EXPECT_EQ(move.advance, Vec3::Zero());
        const double there =
            move.normal.dot((move.start - move.centre).cross(middles[i] - move.centre));
        const double to_middle =
            std::atan2(there, (move.start - move.centre).dot(middles[i] - move.centre));
        EXPECT_LT(to_middle < 0 ? to_middle + 2 * kPi : to_middle, move.angle);
    }
}

TEST(GcodeReader, CentresStayWhereTheyAreGiven) {
    for (const char* text : {"G3 X20 Y20 I0.003 J20.001", "G2 X300 Y299.9 I300 J0.1",
                             "G3 X20 Y-0.001 I10 J0", "G2 X10 Y10 R7.07"}) {
        expect_near(at(last(text), 1), last(text).end, 1e-9);
    }
    const Move given = last("G3 X20 Y0 I10.002 J-3");
    EXPECT_EQ(given.centre, Vec3(10.002, -3, 0));
    EXPECT_NEAR(given.advance.norm(), std::hypot(10.002, 3) - std::hypot(9.998, 3), 1e-12);
    expect_near(last("G2 X10 Y10 R7.07").centre, Vec3(5, 5, 0), 1e-12);
}

TEST(GcodeReader, RotaryAxesGoAlongWithArcs) {
    const Program program = read("F600 G3 X2 I1 A90\nG2.4 X3 Y1\nX4 Y0 C5");
    EXPECT_EQ(program.moves[0].aux_end[0], 90);
    EXPECT_EQ(program.moves[1].aux_start[0], 90);
    EXPECT_EQ(program.moves[1].aux_end[2], 5);
    EXPECT_EQ(program.aux_axes, 3);
}

TEST(GcodeReader, TheToleranceOfThePathIsThatInForce) {
    const auto tolerance = [](const std::string& text) {
        return read("F600 " + text + "\nG1 X1").moves.front().tolerance;
    };
    EXPECT_EQ(tolerance(""), ref::kPathTolerance);
    EXPECT_EQ(tolerance("G64 P0.05 Q0.01"), 0.05);
    EXPECT_EQ(tolerance("G20 G64 P0.001"), 0.0254);
    EXPECT_EQ(tolerance("G64 P0"), 0) << "the exact path";
    EXPECT_EQ(tolerance("G64 P0.05\nG64"), ref::kPathTolerance);
    EXPECT_EQ(tolerance("G61"), 0);
    EXPECT_EQ(tolerance("G61.1"), 0);
    EXPECT_EQ(tolerance("G64 P0.05\nG61\nG64"), ref::kPathTolerance);
}

TEST(GcodeReader, StopsAreWhereTheProgramAsksForThem) {
    const auto stops = [](const std::string& text) {
        std::string flags;
        for (const Move& move : read("F600 G1 X1\n" + text + "\nX2\nX3").moves) {
            flags += move.exact_stop ? '1' : '0';
        }
        return flags;
    };
    EXPECT_EQ(stops(""), "001");
    EXPECT_EQ(stops("G61"), "001") << "the exact path, without a stop";
    EXPECT_EQ(stops("G61.1"), "011");
    EXPECT_EQ(stops("G61.1\nG64 P0.1 Q0.1"), "001");
    EXPECT_EQ(stops("G61.1\nG61"), "001");
    EXPECT_EQ(stops("G4 P0"), "101");
    EXPECT_EQ(stops("X1.5 M0"), "0101");
    EXPECT_EQ(stops("X1.5 M3 S100"), "1001");
    EXPECT_EQ(stops("M5"), "101");
    EXPECT_EQ(stops("T2 M6"), "101");
    EXPECT_EQ(stops("M1"), "101");
    EXPECT_EQ(stops("T2 M8 M7"), "001");
    EXPECT_EQ(stops("X1.5 M2"), "01");
    EXPECT_EQ(stops("M30"), "1");
}

TEST(GcodeReader, DwellsAddUpAtTheMoveBefore) {
    const Program program = read("G4 P9\nF600 G1 X1\nG4 P0.5\nG4 P0.25\nX2");
    ASSERT_EQ(program.moves.size(), 3U);
    EXPECT_EQ(program.moves[0].dwell, 9);
    EXPECT_EQ(program.moves[0].length(), 0);
    EXPECT_EQ(program.moves[0].line, 1);
    EXPECT_EQ(program.moves[1].dwell, 0.75);
    EXPECT_EQ(program.moves[2].dwell, 0);
}

TEST(GcodeReader, MovesOfLengthZeroAreLeftOutAndCounted) {
    const Program program = read("F600 G1 X1\nX1\nG91 X0\nX0.0000000001\nG90 X1.5");
    ASSERT_EQ(program.moves.size(), 2U);
    EXPECT_EQ(program.moves[1].start, program.moves[0].end);
    EXPECT_EQ(program.warnings.front(),
              "part.ngc:2: warning: a move of length 0 is left out (3 times)");
}

TEST(GcodeReader, RoundingOfIncrementsIsNotAMove) {
    const Program program = read("F600 G91 G1 X0.1\nX0.2\nG90 X0.3 A90");
    EXPECT_EQ(program.moves.back().start, program.moves.back().end);
    EXPECT_EQ(program.moves.back().length(), 90);
}

TEST(GcodeReader, ToolLengthIsZeroWithAWarningAndHarmlessCodesPass) {
    const Program program = read("G40 G49 G80 G97 G98 G8 M48 M9\nG43 H3\nF600 G1 Z5");
    EXPECT_EQ(program.moves.front().end.z(), 5);
    EXPECT_EQ(program.warnings.back(),
              "part.ngc:2: warning: tools have a length of 0: --tools FILE.tbl or a TOOL_TABLE of "
              "--machine's .ini says it");
    EXPECT_EQ(program.warnings.size(), 2U) << "M48 and M9 are left out";
}

/// Requests besides motion are reported, with their lines, in one warning at the first of them.
TEST(GcodeReader, WhatIsLeftOutIsSaidOnce) {
    const auto warnings = [](const std::string& text) { return read(text).warnings; };
    const std::string begin =
        "part.ngc:1: warning: only axes move, nothing is switched or waited for: ";
    using Warnings = std::vector<std::string>;
    EXPECT_EQ(
        warnings("T1 M6 S12000 M3\nF600 G1 X1\nM5"),
        Warnings{begin + "M3 in line 1; M6 in line 1; S in line 1; T in line 1; M5 in line 3"});
    for (const char* code :
         {"M0", "M1", "M3", "M4", "M5", "M6", "M7", "M8", "M9", "M48", "M49", "M60"}) {
        EXPECT_EQ(warnings(std::string(code) + "\nF600 G1 X1"),
                  Warnings{begin + code + " in line 1"});
    }
    EXPECT_EQ(warnings("M8\nF600 G1 X1\nM8 X2\nX3\nM8\nM8\nM8\nM30"),
              Warnings{begin + "M8 in lines 1, 3, 5 and 2 more"});
    EXPECT_EQ(warnings("F600 G1 X1\nM2"), Warnings{});
    EXPECT_EQ(warnings("M8\nF600 G1 X1\nX1").size(), 2U) << "others stay";
}

/// Moves of different S are one path: reported where the path continues, not where it stops
/// between.
TEST(GcodeReader, PowerThatChangesOnTheWayIsSaid) {
    const auto said = [](const std::string& text) {
        return read(text).warnings.at(0).find("; moves of different S become one") !=
               std::string::npos;
    };
    EXPECT_TRUE(said("F600 G1 X1 S10\nX2 S20"));
    EXPECT_TRUE(said("F600 G1 X1\nX2 S20")) << "from none";
    EXPECT_FALSE(said("S10\nF600 G1 X1\nX2 S10"));
    EXPECT_FALSE(said("S10\nF600 G1 X1\nM5\nS20\nX2"));
    EXPECT_FALSE(said("S10 M3\nF600 G1 X1\nS20 M3\nX2"));
    EXPECT_TRUE(said("S10 M3\nF600 G1 X1\nS20 M3\nX2\nS30 X3"));
}

TEST(GcodeReader, NothingIsReadBehindTheEnd) {
    EXPECT_EQ(read("G0 X1\nM2\nrubbish").moves.size(), 1U);
    EXPECT_EQ(read("\n%\nG0 X1\n%\nrubbish").moves.size(), 1U);
    EXPECT_EQ(read("% (part)\nG0 X1\n").moves.size(), 1U);
    EXPECT_EQ(read("G0 X1\n%\nrubbish").moves.size(), 1U);  // TPL and others write no first one
    EXPECT_EQ(read("(a (comment) in one) G0 X1\n").moves.size(), 1U);
    EXPECT_EQ(read("%_N_PART_MPF\nG0 X1\n%\nrubbish").moves.size(), 1U);
}

TEST(GcodeReader, LinesEndAsOnAnySystem) {
    EXPECT_EQ(read("\xEF\xBB\xBFG0 X1\r\nX2\rX3\n\nX4").moves.back().line, 5);
}

TEST(GcodeReader, CommentsMayHoldAnyText) {
    EXPECT_EQ(read("(\xC2\xB5m; #1 [) G0 X1 ; (\xFF ( )").moves.size(), 1U);
}

class Part : public testing::TestWithParam<std::string> {};

TEST_P(Part, IsAChainOfMovesThatEndWhereTheyShould) {
    const Program program = ref::read_gcode(GetParam());
    Vec3 here = Vec3::Zero();
    ref::Aux aux{};
    for (const Move& move : program.moves) {
        EXPECT_EQ(move.start, here) << GetParam() << ":" << move.line;
        EXPECT_EQ(move.aux_start, aux) << GetParam() << ":" << move.line;
        if (move.kind == Move::Kind::kArc) {
            EXPECT_GT(move.angle, 0);
            expect_near(at(move, 1), move.end, 1e-9);
        }
        if (move.kind == Move::Kind::kCubic) {
            expect_near(move.cubic.position(0), move.start, 1e-12);
            expect_near(move.cubic.position(1), move.end, 1e-12);
        }
        here = move.end;
        aux = move.aux_end;
    }
    for (const std::string& warning : program.warnings) {
        EXPECT_NE(warning.find("only axes move"), std::string::npos) << warning;
    }
}

std::vector<std::string> parts() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(DATA_DIR)) {
        if (entry.path().extension() == ".ngc") {
            files.push_back(entry.path().string());
        }
    }
    return files;
}

INSTANTIATE_TEST_SUITE_P(Of, Part, testing::ValuesIn(parts()), [](const auto& tested) {
    return std::filesystem::path(tested.param).stem().string();
});

}  // namespace curvecore::tb::gcode_reader_test
