// SPDX-License-Identifier: Apache-2.0
// Codes besides plain moves, compared with closed forms: preambles, stored positions, offsets with
// rotations, tool lengths, feed per turn.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <sstream>

#include "ref/program/gcode_reader.hpp"
#include "ref/program/gcode_stream.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::tb::gcode_codes_test {

using ref::Move;
using ref::Program;
using ref::Vec3;

constexpr double kPi = 3.14159265358979323846;

Program read(const std::string& text) { return ref::read_gcode_text(text, "part.ngc"); }

Move last(const std::string& text) { return read("G21 G90 G17 G94 F600\n" + text).moves.back(); }

std::string refusal(const std::string& text) {
    try {
        read("F600 G1 X1\n" + text);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "nothing is wrong";
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " is not " << b.transpose();
}

TEST(GcodeCodes, AMotionCodeStandsBesideG80InAnyOrder) {
    EXPECT_TRUE(last("G0 G17 G40 G49 G80 G90 G21 X2").rapid);
    EXPECT_TRUE(last("G80 G0 X2").rapid);
    EXPECT_EQ(last("G80 G2 X2 I1").kind, Move::Kind::kArc);
    EXPECT_EQ(refusal("G80 G0 G1 X2"),
              "part.ngc:2: error: G0 and G1 exclude each other in one block");
    EXPECT_EQ(refusal("G80 G80"), "part.ngc:2: error: G80 twice in one block");
    EXPECT_EQ(refusal("G80\nX2"),
              "part.ngc:3: error: axis words, but no motion code (G0 G1 G2 G3) is in force");
}

TEST(GcodeCodes, PostsWriteUnitsAndCentresInTheirWay) {
    EXPECT_EQ(last("G70\nG1 X1").end.x(), 25.4);
    EXPECT_EQ(last("G20\nG71 G91.1\nG1 X1").end.x(), 1);
    EXPECT_EQ(last("G2 X2 I1 K0").kind, Move::Kind::kArc);
    EXPECT_EQ(refusal("G2 X2 I1 K1"), "part.ngc:2: error: K with an arc in the XY plane");
    EXPECT_EQ(refusal("G71 Q100").substr(0, 18), "part.ngc:2: error:");
    EXPECT_EQ(refusal("G71 U2 R1").substr(0, 18), "part.ngc:2: error:");
}

TEST(GcodeCodes, PolarPlacesDoNotRepeat) {
    EXPECT_EQ(refusal("G91 G81 R1 Z-1 ^60 L6"),
              "part.ngc:2: error: polar coordinates (@ ^) do not repeat (L): give each place");
}

TEST(GcodeCodes, ProbesLeaveTheirEndInParameters) {
    EXPECT_EQ(last("#5070=1\nG38.2 X3 Z-2\nG1 X[10+#5061] Y#5063 Z#5070").end, Vec3(13, -2, 0));
    EXPECT_DOUBLE_EQ(last("G20 G31 Z-1 F10\nG10 L20 P0 Z0\nG38.3 Z-.5\nG1 Y#5063").end.y(), -12.7);
}

/// Ends of a program's moves after the first.
std::vector<Vec3> ends(const std::string& text) {
    std::vector<Vec3> points;
    for (const Move& move : read("G21 G90 F600\nG1 X5 Y6 Z-2\n" + text).moves) {
        points.push_back(move.end);
    }
    points.erase(points.begin());
    return points;
}

using Points = std::vector<Vec3>;

/// LinuxCNC's tolerances: 0.02 sqrt 2 mm or 0.002 sqrt 2 inch; 0.1 % up to 100 times that.
TEST(GcodeCodes, RadiiAtAnArcsEndsMayDifferAsForLinuxcnc) {
    const auto ends_at = [](double x) {
        return refusal("G0 X0\nG3 Y1 J1 X" + std::to_string(1 + x)).substr(0, 42);
    };
    const std::string differ = "part.ngc:3: error: the arc's radii differ:";
    EXPECT_EQ(ends_at(0.028), "nothing is wrong");
    EXPECT_EQ(ends_at(0.029), differ);
    EXPECT_EQ(refusal("G20 G0 X0\nG3 X1.00282 Y1 J1"), "nothing is wrong");
    EXPECT_EQ(refusal("G20 G0 X0\nG3 X1.00283 Y1 J1").substr(0, 42), differ);
    EXPECT_EQ(refusal("G0 X0\nG3 X1000.99 Y1000 J1000"), "nothing is wrong");
    EXPECT_EQ(refusal("G0 X0\nG3 X1001.01 Y1000 J1000").substr(0, 42), differ);
    EXPECT_EQ(refusal("G0 X0\nG3 X10002.9 Y10000 J10000").substr(0, 42), differ);
}

TEST(GcodeCodes, ACentreThatDoesNotFitIsRefusedWithOneThatDoes) {
    EXPECT_EQ(refusal("G20 G0 X0\nG3 X1 Y1 I.2 J1"),
              "part.ngc:3: error: the arc's radii differ: 25.903 mm at the start, 20.32 mm at the "
              "end; the centre I0.1 J0.9 would fit; --arc-tolerance allows more than 0.0718 mm");
    EXPECT_EQ(
        refusal("G91.1 G0 X10 Y4\nG2 X16 Y10 I10 J10"),
        "part.ngc:3: error: the arc's radii differ: 14.1421 mm at the start, 5.65685 mm at the "
        "end; as absolute ones (G90.1) these centre words fit; --arc-tolerance allows more "
        "than 0.0283 mm");
}

TEST(GcodeCodes, CentresThatFitAsAbsoluteOnesAloneAreThat) {
    const std::string arc = "G0 X10 Y4\nG2 X16 Y10 I10 J10\nG2 X10 Y16 I10 J10";
    const Program program = read("F600 G1 X1\n" + arc);
    ASSERT_EQ(program.moves.size(), 4U);
    EXPECT_EQ(program.moves[2].centre, Vec3(10, 10, 0));
    EXPECT_EQ(program.moves[3].centre, Vec3(10, 10, 0));
    EXPECT_EQ(program.warnings.front(),
              "part.ngc:3: warning: the program's centre words fit as absolute ones alone: they "
              "are read as in G90.1, which LinuxCNC wants in the program");
    // An arc has shown that they are relative; both of one arc say nothing.
    EXPECT_EQ(refusal("G0 X10 Y4\nG2 X16 Y10 I6\n" + arc).substr(0, 18), "part.ngc:5: error:");
    EXPECT_EQ(refusal("G0 X0 Y0\nG2 X10 Y0 I5 J0\n" + arc), "nothing is wrong");
}

TEST(GcodeCodes, AxisWordsBeforeAnyMotionCodeAreRapids) {
    const Program program = read("X5 Y1\nG1 X6 F600\nZ1");
    ASSERT_EQ(program.moves.size(), 3U);
    EXPECT_TRUE(program.moves[0].rapid);
    EXPECT_FALSE(program.moves[2].rapid);
    EXPECT_EQ(program.warnings.front(),
              "part.ngc:1: warning: axis words before any motion code are G0's, as grbl begins; "
              "LinuxCNC refuses them");
}

TEST(GcodeCodes, CompensationOfNoRadiusIsTheProgrammedPath) {
    const Program program = read("F600 T3 M6 G1 X1\nG41 D3 Y5\nX9\nG40 X10\nG42.1 D0 X11\nG40");
    ASSERT_EQ(program.moves.size(), 5U);
    EXPECT_EQ(program.moves[1].end, Vec3(1, 5, 0));
    EXPECT_TRUE(std::any_of(program.warnings.begin(), program.warnings.end(), [](const auto& said) {
        return said ==
               "part.ngc:2: warning: cutter compensation of a tool whose diameter nobody "
               "says: the programmed path is drawn; --tools FILE.tbl says it";
    }));
    EXPECT_EQ(last("F60 G41 D5 G1 X#<_ccomp>").end.x(), 400);
    EXPECT_EQ(last("F60 G41 D5\nG1 X#<_ccomp>").end.x(), 410);
    EXPECT_EQ(refusal("G42.1 D6 X2"),
              "part.ngc:2: error: G42.1: cutter compensation of a tool of 6 mm belongs to "
              "LinuxCNC's interpreter (--interpreter linuxcnc); D0 draws the programmed path");
    EXPECT_EQ(refusal("G42.1 X2"), "part.ngc:2: error: G42.1 without D, a diameter");
    EXPECT_EQ(refusal("G10 L1 P3 R2\nG41 D3 X2").substr(0, 58),
              "part.ngc:3: error: G41: cutter compensation of a tool of 4");
}

TEST(GcodeCodes, SpeedsOfASurfaceAreSaidNotToBeTurns) {
    const std::string warning =
        ": warning: feeds per turn are not exact in G96: S, a speed of the surface, is taken as "
        "turns a minute; G97 S names those";
    const Program program = read("G96 D2000 S120 M3\nG95 F0.1\nG0 X5\nG1 X4\nX3\nG97 S900 X2");
    EXPECT_EQ(program.moves[1].feed, 0.2);
    EXPECT_EQ(program.warnings.front(), "part.ngc:4" + warning + " (2 times)");
    for (const std::string& said : read("G96 S120 M3\nG1 X4 F50\nG97 G95 S9 X3 F1").warnings) {
        EXPECT_EQ(said.find("feeds per turn"), std::string::npos) << said;
    }
}

TEST(GcodeCodes, G28LeadsByWayOfItsPointToTheStoredPositionOfTheNamedAxes) {
    EXPECT_EQ(ends("G91 G28 Z0"), (Points{{5, 6, 0}}));
    EXPECT_EQ(ends("G91 G0 G28 Z0\nX1"), (Points{{5, 6, 0}, {6, 6, 0}}));
    EXPECT_EQ(ends("G28 Z10"), (Points{{5, 6, 10}, {5, 6, 0}}));
    EXPECT_EQ(ends("G28"), (Points{{0, 0, 0}}));
    EXPECT_EQ(ends("G91 G28 X0 Y0\nG90 G1 X1"), (Points{{0, 0, -2}, {1, 0, -2}}));
    EXPECT_EQ(ends("G28.1\nG1 X9 Z3\nG28 X20"), (Points{{9, 6, 3}, {20, 6, 3}, {5, 6, 3}}));
    EXPECT_EQ(ends("G30.1\nG1 X9 Z3\nG30"), (Points{{9, 6, 3}, {5, 6, -2}}));
    EXPECT_EQ(ends("G10 L2 P1 X100 Z50\nG28 Z0"), (Points{{5, 6, 50}, {5, 6, 0}}));
    const Program program = read("F600 G1 X5\nG28\nX2");
    EXPECT_TRUE(program.moves[1].rapid);
    EXPECT_FALSE(program.moves[2].rapid) << "the motion code holds on";
    EXPECT_EQ(refusal("G28 G2 X2 I1"),
              "part.ngc:2: error: G28 and G2 both want the axis words of this block");
}

TEST(GcodeCodes, G10L20GivesThePresentPointItsCoordinates) {
    EXPECT_EQ(last("G1 X7 Y3\nG10 L20 P1 X0 Y1\nG1 X2 Y2").end, Vec3(9, 4, 0));
    EXPECT_EQ(last("G1 X7\nG10 L20 P2 X1\nX8\nG55 X1").end, Vec3(7, 0, 0));
    EXPECT_EQ(last("G1 X7\nG92 X10\nG10 L20 P0 X1\nX2").end, Vec3(8, 0, 0));
    EXPECT_EQ(last("G20 G10 L20 P1 X1\nG1 X2").end, Vec3(25.4, 0, 0));
}

/// The relation machine = R (p + shift) + offset + tool, for every way to set one of these.
TEST(GcodeCodes, OffsetsRotationShiftAndToolAddUpAsDocumented) {
    std::mt19937 random(34);
    std::uniform_int_distribution<int> numbers(-999, 999);
    for (int n = 0; n < 200; ++n) {
        const auto number = [&] { return numbers(random) / 10.0; };
        const Vec3 offset(number(), number(), number());
        const Vec3 shift(number(), number(), number());
        const Vec3 tool(number(), number(), number());
        const Vec3 point(number(), number(), number());
        const double angle = number();
        const auto words = [](const Vec3& v) {
            return " X" + std::to_string(v.x()) + " Y" + std::to_string(v.y()) + " Z" +
                   std::to_string(v.z()) + "\n";
        };
        const Eigen::AngleAxisd turn(angle * kPi / 180, Vec3::UnitZ());
        const auto machine = [&](const Vec3& p) -> Vec3 {
            return turn * (p + shift) + offset + tool;
        };
        const std::string set = "G43.1" + words(tool) + "G10 L2 P1 R" + std::to_string(angle) +
                                words(offset) + "G52" + words(shift);
        const Vec3 next(number(), 0, 0);
        const std::string go = "G1" + words(point);
        expect_near(last(set + go).end, machine(point), 1e-9);
        expect_near(last(set + go + "X" + std::to_string(next.x())).end,
                    machine({next.x(), point.y(), point.z()}), 1e-9);
        expect_near(last(set + go + "G91 G1 X7").end, machine(point + Vec3(7, 0, 0)), 1e-9);
        expect_near(last(set + go + "G53 G1 X7").end,
                    Vec3(7, machine(point).y(), machine(point).z()), 1e-9);
        expect_near(last(set + go + "G10 L20 P1 X1 Y2 Z3\nG1 X2 Y4 Z6").end,
                    machine(point) + turn * Vec3(1, 2, 3), 1e-9);
        expect_near(last(set + go + "G92 X1 Y2 Z3\nG1 X2 Y4 Z6").end,
                    machine(point) + turn * Vec3(1, 2, 3), 1e-9);
        expect_near(last(set + go + "G28 X7").end,
                    turn * Vec3((turn.inverse() * Vec3::Zero()).x(),
                                (turn.inverse() * machine(point)).y(), machine(point).z()),
                    1e-9);
        const Move arc = last(set + go + "G2 I3 J4");
        expect_near(arc.centre, machine(point + Vec3(3, 4, 0)), 1e-9);
        EXPECT_EQ(arc.normal, -Vec3::UnitZ());
        const Move upright = last(set + go + "G18 G3 I3 K4");
        expect_near(upright.centre, machine(point + Vec3(3, 0, 4)), 1e-9);
        expect_near(upright.normal, turn * Vec3::UnitY(), 1e-12);
        const Move spline = last(set + go + "G91 G5 X5 Y1 I1 J2 P3 Q4");
        expect_near(ref::to_bezier(spline.cubic)[1], machine(point + Vec3(1, 2, 0)), 1e-9);
        expect_near(ref::to_bezier(spline.cubic)[2], machine(point + Vec3(8, 5, 0)), 1e-9);
    }
}

TEST(GcodeCodes, RotationTurnsTheProgramsAxes) {
    const double half = std::sqrt(0.5);
    expect_near(last("G10 L2 P1 R45\nG1 X5").end, Vec3(5 * half, 5 * half, 0));
    expect_near(last("G10 L2 P1 R90\nG2 X2 Y0 I1 J0").end, Vec3(0, 2, 0));
}

TEST(GcodeCodes, ToolLengthsAreSetAndAddedTo) {
    EXPECT_EQ(last("G43.1 Z10\nG1 Z1").end, Vec3(0, 0, 11));
    EXPECT_EQ(last("G43.1 Z10\nG43.2 Z5 X1\nG1 Z1").end, Vec3(0, 0, 16));
    EXPECT_EQ(last("G43.1 Z10\nG43.2 Z5 X1\nG1 X1 Z1").end, Vec3(2, 0, 16));
    EXPECT_EQ(last("G43.1 Z10\nG49\nG1 Z1").end, Vec3(0, 0, 1));
    EXPECT_EQ(last("G20 G43.1 Z1\nG1 Z1").end, Vec3(0, 0, 50.8));
    EXPECT_EQ(last("G43.1 Z10\nG53 G1 Z1").end, Vec3(0, 0, 1));
}

TEST(GcodeCodes, DiametersAreTwiceX) {
    EXPECT_EQ(last("G7 G1 X10 Y10").end, Vec3(5, 10, 0));
    EXPECT_EQ(last("G7 G1 X10\nG8 X3").end, Vec3(3, 0, 0));
    EXPECT_EQ(last("G7 G1 X10\nG91 X2").end, Vec3(6, 0, 0));
    EXPECT_EQ(last("G7 G1 X10\nG92 X4\nX8").end, Vec3(7, 0, 0));
}

TEST(GcodeCodes, FeedPerTurnIsOfTheProgrammedSpeed) {
    EXPECT_DOUBLE_EQ(last("S1200 M3\nG95 G1 X10 F0.1").feed, 2);
    EXPECT_DOUBLE_EQ(last("S1200 G20 G95 G1 X1 F0.1").feed, 2 * 25.4);
    EXPECT_DOUBLE_EQ(last("S600 G95 G1 A10 F0.1").feed, 1);
    EXPECT_DOUBLE_EQ(last("S1200 G95 G1 X10 F0.1\nG94 F60 X11").feed, 1);
    EXPECT_EQ(
        refusal("G95 F0.1 X2"),
        "part.ngc:2: error: G1 in G95: F is per turn of the spindle, whose speed is 0: give S");
    EXPECT_EQ(refusal("S600 G95 X2"),
              "part.ngc:2: error: G1 without a feed: no F yet; give one before it, or by "
              "RS274NGC_STARTUP_CODE of the machine's .ini");
}

TEST(GcodeCodes, ProbingGoesToItsEnd) {
    for (const char* code : {"G38.2", "G38.3", "G38.4", "G38.5"}) {
        const Program program = read("F600 G1 X1\n" + std::string(code) + " Z-5\nG0 X9");
        EXPECT_EQ(program.moves[1].end, Vec3(1, 0, -5));
        EXPECT_EQ(program.moves[1].feed, 10);
        EXPECT_TRUE(program.moves[1].exact_stop);
        EXPECT_EQ(program.warnings.front(),
                  "part.ngc:2: warning: a probing move is drawn to its end");
    }
}

TEST(GcodeCodes, LookingAheadIsDoneAnyway) {
    const Program program = read("G05.1 Q1\nF600 G1 X1\nX2\nG5.1 Q0\nG5 P10000");
    EXPECT_EQ(program.moves.size(), 2U);
    EXPECT_EQ(program.warnings.back(),
              "part.ngc:1: warning: G5.1 asks for looking ahead, which is done anyway (2 times)");
}

TEST(GcodeCodes, WhatAsksForMoreThanMotionIsAnEventWithItsPlace) {
    std::istringstream text(
        "S500 M3 T7\nF600 G1 X3 Y4\nM62 P2\nG1 X6 Y8 S600\nM67 E0 Q2.5\nM68 E3 Q4\n"
        "G81 Z-1 R0\nM8 M30");
    ref::GcodeStream stream(text, "part.ngc", {});
    ref::read_all(stream, "part.ngc");
    std::ostringstream said;
    const ref::Events events = stream.events();
    for (const ref::Events::Event& event : events.list()) {
        said << event.line << ' ' << events.code_of(event) << ' ' << event.value << " at "
             << event.length << ", ";
    }
    EXPECT_EQ(said.str(),
              "1 S 500 at 0, 1 T 7 at 0, 1 M3 0 at 0, 3 M62 2 at 5, 4 S 600 at 5, "
              "5 M67 2.5 at 10, 6 M68 E3 4 at 10, 8 M8 0 at 12, ");
}

TEST(GcodeCodes, MCodesTakeTheirWordsAndUnknownOnesWarn) {
    for (const char* text : {"M62 P3", "M63 P0", "M64 P1", "M65 P2", "M66 P0 L3 Q5", "M67 Q50",
                             "M50 P1", "M19 R90 Q2", "M61 Q7", "M100 P1 Q2"}) {
        const Program program = read("F600 G1 X1\n" + std::string(text) + "\nX2");
        EXPECT_EQ(program.moves.size(), 2U) << text;
        EXPECT_EQ(program.warnings.size(), 1U) << text;
    }
    EXPECT_EQ(read("F600 G1 X1 M29 S500").warnings.back(), "part.ngc:1: warning: unknown code M29");
    EXPECT_EQ(refusal("M8 P1"), "part.ngc:2: error: P has no use in this block");
}

}  // namespace curvecore::tb::gcode_codes_test
