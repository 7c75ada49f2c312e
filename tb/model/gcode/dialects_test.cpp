// SPDX-License-Identifier: Apache-2.0
// Dialects: their recognition, and the meaning of their lines as RS274/NGC.
#include <gtest/gtest.h>

#include <sstream>

#include "ref/gcode/lines/dialect.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/program/gcode_stream.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::tb::dialects_test {

using ref::Dialect;
using ref::InputError;
using ref::Move;
using ref::Program;
using ref::Vec3;

Dialect recognised(const std::string& text) {
    std::istringstream lines(text);
    return *ref::GcodeStream(lines, "part.nc", ref::GcodeOptions()).dialect();
}

Program read(const std::string& text, std::optional<Dialect> dialect = {}) {
    return ref::read_gcode_text(text, "part.nc", {ref::kFitTolerance, dialect, {}});
}

std::string refusal(const std::string& text, std::optional<Dialect> dialect = {}) {
    try {
        read(text, dialect);
        return "nothing is wrong";
    } catch (const InputError& error) {
        return error.what();
    }
}

bool warns(const Program& program, const std::string& text) {
    for (const std::string& warning : program.warnings) {
        if (warning.find(text) != std::string::npos) return true;
    }
    return false;
}

TEST(Dialects, AreRecognisedByWhatNoOtherHas) {
    EXPECT_EQ(recognised("G21\nG1 X1 F600\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised(""), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("(head)\n$H\nG21\n"), Dialect::kGrbl);
    EXPECT_EQ(recognised("; by a slicer\nM201 X500\nG28\nM104 S200\n"), Dialect::kMarlin);
    EXPECT_EQ(recognised("G28\nG1 X1 E.5 F1800\n"), Dialect::kMarlin);
    EXPECT_EQ(recognised("M82\nG1 X1\n"), Dialect::kMarlin);
    EXPECT_EQ(recognised("%\nO1234 (PART)\nG0 X10. Y5.\n%\n"), Dialect::kFanuc);
    EXPECT_EQ(recognised(":0001\nG00 X1.\n"), Dialect::kFanuc);
    // LinuxCNC's own: numbered programs, M67 E, user's M codes, O-words.
    EXPECT_EQ(recognised("O1 (main)\nG0 X10 Y5\nM30\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("M67 E0 Q5\nG1 X1\nM104 P1\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("O1 sub\nG0 X1.\nO1 endsub\nO7\nG1 X1.\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("(G1 E5 (G1 E6) E7)\n;M82\nG1 X1\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("O7\n#1=5.\nG1 X#1 Y2\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("O7\n#1=5.\nG1 Y2. F60\n"), Dialect::kFanuc);
    EXPECT_EQ(recognised("G1 X1 M67 E0 Q5\n"), Dialect::kLinuxcnc);
    EXPECT_EQ(recognised("G1 X1e3\n"), Dialect::kLinuxcnc);  // foreign syntax
}

TEST(Dialects, GrblsLinesAreNoted) {
    const Program program = read("$H\n$X\nG21 G1 X5 F600\n?\nX7\n%\nX9\n");
    ASSERT_EQ(program.moves.size(), 3U);
    EXPECT_EQ(program.moves.back().end.x(), 9);
    EXPECT_TRUE(program.moves[0].exact_stop);  // at the ?
    EXPECT_TRUE(warns(program, "$H in line 1; $X in line 2; ? in line 4"));
    EXPECT_EQ(refusal("G1 X1 F60\n$H\n", Dialect::kLinuxcnc),
              "part.nc:2: error: a line of grbl's: --dialect grbl notes it");
}

TEST(Dialects, FanucsNumbersWithoutAPointAreThousandths) {
    const std::string text =
        "O0001\nG21 G90 G0 X10. Y5\nG1 Z-2000 F600\nG2 X20. I5000 J0\nG1 X0 Y0\n";
    const Program program = read(text);
    EXPECT_EQ(program.moves[0].end, Vec3(10, 0.005, 0));
    EXPECT_EQ(program.moves[1].end, Vec3(10, 0.005, -2));
    EXPECT_EQ(program.moves[1].feed, 10);
    EXPECT_EQ(program.moves[2].centre, Vec3(15, 0.005, -2));
    EXPECT_TRUE(warns(program, "counts in 0.001 mm or 0.0001 inch"));
    EXPECT_EQ(read("O1\nG0 X10. Y5\n", Dialect::kLinuxcnc).moves[0].end, Vec3(10, 5, 0));
    EXPECT_EQ(read("O1\nG20 G1 X1. F60.\nX25000\nX[5]\n").moves[1].end.x(), 2.5 * 25.4);
    EXPECT_FALSE(warns(read("O1\nG20 G1 X1. Y0 F60.\n"), "counts in"));
}

TEST(Dialects, FanucsDwellsAreMillisecondsOrSeconds) {
    const char* const head = "O1\nG1 X1. F600\n";
    const std::pair<const char*, double> cases[] = {
        {"G4 P1500", 1.5}, {"G4 P2.", 2}, {"G04 X2.5", 2.5}, {"G4 X500", 0.5}, {"G4 U1.", 1}};
    for (const auto& [text, seconds] : cases) {
        EXPECT_EQ(read(head + std::string(text) + "\nX2.\n").moves[0].dwell, seconds) << text;
    }
}

TEST(Dialects, FanucsCyclesHaveMillisecondsAndTimes) {
    const Program program =
        read("O1\nG91 G1 F600 X1.\nG99 G82 X10. Z-5000 R-1. P500 K2\nG80\nM30\n");
    double lowest = 0;
    double dwell = 0;
    for (const Move& move : program.moves) {
        lowest = std::min(lowest, move.end.z());
        dwell += move.dwell;
    }
    EXPECT_EQ(lowest, -6);
    EXPECT_EQ(dwell, 1);
    EXPECT_EQ(program.moves.back().end.x(), 21);
}

TEST(Dialects, BehindFanucsG80TheMotionBeforeTheCycleIsInForce) {
    const std::string cycle = "G99 G81 X10. Z-5. R1. F100\nG80\nX20.\n";
    EXPECT_TRUE(read("O1\nG0 Z9.\n" + cycle).moves.back().rapid);
    EXPECT_EQ(read("O1\nG0 Z9.\nG1 Z8. F600\n" + cycle).moves.back().feed, 100 / 60.0);
    EXPECT_EQ(refusal("G0 Z9.\n" + cycle).substr(0, 10), "part.nc:4:");
}

TEST(Dialects, FanucsSumsRadiiAndSettings) {
    const Program program =
        read("O1\nG187 P2\nN5 G187\nG0 G43 H1 D1 Z5.\n#1=10.\n#1=#1+2.5\nG1 X#1 F600\nM30\n");
    EXPECT_EQ(program.moves.back().end.x(), 12.5);
    EXPECT_TRUE(warns(program, "G187 in lines 2 and 3"));
    EXPECT_EQ(refusal("#1=10.\n#1=#1+2.5\n").substr(0, 10), "part.nc:2:");
}

TEST(Dialects, FanucCallsWithTimesAhead) {
    EXPECT_EQ(read("O0001\nG91 G1 F600 X1.\nM98 P30002\nM30\nO0002\nX1.\nM99\n").moves.size(), 4U);
    EXPECT_EQ(read("O0001\nG91 G1 F600 X1.\nM98 P2 L2\nM30\nO0002\nX1.\nM99\n").moves.size(), 3U);
    EXPECT_EQ(read("O0001\nG1 F600 X1.\n/2 X5.\n").moves.back().end.x(), 5);
}

TEST(Dialects, FanucsMacrosHaveAssignmentsWithoutBracketsAndPlainArguments) {
    const Program program = read(
        "O1\n#100=0\nG1 F600 X1.\nWHILE [#100 LT 2] DO1\nN5 #100=#100+1\n"
        "IF [#100 EQ 2] THEN #101=#100+3\nX[#100*10]\nEND1\nX#101\nG65 P7 X30 A5\nM30\n"
        "O7\nX[#24+#1]\nM99\n");
    std::vector<double> xs;
    for (const Move& move : program.moves) xs.push_back(move.end.x());
    EXPECT_EQ(xs, (std::vector<double>{1, 10, 20, 5, 35}));
}

TEST(Dialects, FanucsLathesHaveIncrements) {
    const Program program =
        read("O1\nG0 X10. Z5.\nG1 U-2. W-5000 F600\nW-1.\nG91 U1.\nG90 X3.\nG28 U0 W0\nG4 U1.\n");
    const std::vector<Vec3> expected{{10, 0, 5}, {8, 0, 0},  {8, 0, -1},
                                     {9, 0, -1}, {3, 0, -1}, {0, 0, 0}};
    std::vector<Vec3> ends;
    for (const Move& move : program.moves) ends.push_back(move.end);
    EXPECT_EQ(ends, expected);
    EXPECT_TRUE(warns(program, "U V W are increments of X Y Z, as on Fanuc's lathes"));
    EXPECT_EQ(program.moves.back().dwell, 1);
    EXPECT_EQ(read("G1 U5 F60\n").moves[0].aux_end[3], 5);  // LinuxCNC's axis
}

TEST(Dialects, FanucsDrillingMayHaveARest) {
    const Program program = read("O1\nG0 Z10.\nG83 X9. Z-5. R1. Q2. P500 F20\nX5.\nG80\n");
    EXPECT_EQ(program.moves.back().end.x(), 5);
    EXPECT_TRUE(warns(program, "the rest at a hole's bottom (P) of G73 G81 G83 is not drawn"));
}

TEST(Dialects, TinygsHomingIsNoted) {
    for (const char* const text :
         {"G1 X5 F600\nG28.2 X0 Y0\nX7\n", "$H\nG1 X5 F600\nn3g28.2z0\nX7\n"}) {
        const Program program = read(text);
        ASSERT_EQ(program.moves.size(), 2U);
        EXPECT_TRUE(program.moves[0].exact_stop);
        EXPECT_TRUE(warns(program, "G28.2"));
    }
}

TEST(Dialects, MarlinsExtruderIsAnAuxiliaryAxis) {
    const Program program = read(
        "M82\nG28\nG92 E0\nG1 Z.2 F3000\nG1 X10 E2\nG1 X20 E4.5\nG92 E0\nG1 E-1 F1800\n"
        "G0 X30 F6000\nG1 E0\nM83\nG1 X40 E.5\nG1 X50 E.5\nM82\nG1 X60 E2\n");
    std::vector<double> extruded;
    for (const Move& move : program.moves) extruded.push_back(move.aux_end[0]);
    const std::vector<double> expected{0, 2, 4.5, 3.5, 3.5, 4.5, 5, 5.5, 6.5};
    ASSERT_EQ(extruded.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(extruded[i], expected[i], 1e-8);
    EXPECT_EQ(program.aux_axes, 1);
    EXPECT_EQ(program.moves[1].length(), 10);  // of X Y Z alone
    EXPECT_EQ(program.moves[3].length(), 1);
    EXPECT_EQ(program.moves[3].feed, 30);
    EXPECT_FALSE(program.moves[4].rapid);  // G0 has its feed
    EXPECT_EQ(program.moves[4].feed, 100);
}

TEST(Dialects, MarlinsRelativeModesAndInchesReachTheExtruder) {
    EXPECT_NEAR(read("G91\nG1 X1 E1 F600\nG1 X1 E1\n").moves[1].aux_end[0], 2, 1e-8);
    EXPECT_NEAR(read("M83\nG91\nG90\nG1 X1 E1 F600\nG1 X2 E3\n").moves[1].aux_end[0], 3, 1e-8);
    EXPECT_NEAR(read("M83\nG20\nG1 X1 E1 F600\n").moves[0].aux_end[0], 25.4, 1e-8);
}

TEST(Dialects, MarlinsOtherCommandsAreNotedOrWaitedFor) {
    const Program program = read(
        "M140 S60\nM117 It's (hot; \xC3\xA9\nG28 W\nG29\nG29.1 S2\nT0\nG1 X5 F600 E1\nM106 S255\n"
        "G1 X6 E2\nM400\nM73 P5 R2\nN12 G1 X7 E3*55\nG4 S2\nG4 P500\nG1 X8\nM84\n");
    ASSERT_EQ(program.moves.size(), 4U);
    EXPECT_FALSE(program.moves[0].exact_stop);
    EXPECT_TRUE(program.moves[1].exact_stop);
    EXPECT_EQ(program.moves[2].dwell, 2.5);
    EXPECT_TRUE(warns(program, "G29.1 in line 5"));
    EXPECT_TRUE(warns(program, "M106 in line 8"));
    EXPECT_TRUE(warns(program, "M73 in line 11"));
}

TEST(Dialects, CommandsOfAFirmwareAreNoted) {
    const Program program = read("START_PRINT BED=60 ; begin\nM83\nG1 X5 E1 F600\nend_print\n");
    EXPECT_EQ(program.moves.size(), 1U);
    EXPECT_TRUE(warns(program, "START_PRINT in line 1"));
    EXPECT_TRUE(warns(program, "end_print in line 4"));
}

TEST(Dialects, MarlinHomesTheAxesThatItNames) {
    const Program program = read("M83\nG1 X5 Y6 Z7 E1 F600\nG28 X Y\nG28\n");
    EXPECT_EQ(program.moves[1].end, Vec3(0, 0, 7));
    EXPECT_EQ(program.moves[2].end, Vec3(0, 0, 0));
    EXPECT_EQ(program.moves[2].aux_end[0], 1);
    EXPECT_EQ(read("M83\nG1 X5 Y6 E1 F600\nG92 XE\nG1 X1 Y7\n").moves[1].end, Vec3(6, 7, 0));
}

TEST(Dialects, MarlinsFirstFeedIsItsOwn) {
    EXPECT_EQ(read("M83\nG0 X5\n").moves[0].feed, 25);
    EXPECT_NEAR(read("M83\nG20\nG0 X5\n").moves[0].feed, 25, 1e-6);
}

TEST(Dialects, RefuseWhatTheyDoNotKnow) {
    EXPECT_EQ(refusal("M83\nG1 X1 E1..5 F60\n"), "part.nc:2: error: E1..5 is not a number");
    EXPECT_EQ(refusal("M83\nG1 X1 E F60\n"), "part.nc:2: error: E is not a number");
    EXPECT_EQ(refusal("M83\nG99 X1\n"),
              "part.nc:2: error: G99 is not known of Marlin (--dialect linuxcnc, if the program "
              "is not for a printer)");
    EXPECT_EQ(refusal("M83\n#1=5\n"), "part.nc:2: error: '#' where a command should begin");
}

}  // namespace curvecore::tb::dialects_test
