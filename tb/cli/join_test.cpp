// SPDX-License-Identifier: Apache-2.0
// `curvecore join`: good joins run through the RTL and are loaded again; programs that cannot be
// joined are refused with the exact message, and nothing is left behind.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::join_test {

using Json = nlohmann::json;

const std::string kA = std::string(DATA_DIR) + "/pass_1.ngc";
const std::string kB = std::string(DATA_DIR) + "/pass_2.ngc";
const std::string kAbove = std::string(DATA_DIR) + "/pass_3.ngc";

double worst(const Json& result, const std::string& move, const char* what) {
    for (const Json& row : result) {
        if (row["move"] != move) continue;
        return std::max(row["start"][what].get<double>(), row["end"][what].get<double>());
    }
    return -1;
}

TEST(Join, RunsThroughTheRtlWithoutAJump) {
    const ProgramRun program;
    const ProgramResult done = program.run({"join", kA, kB, "-o", "out"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.out.find("idle move: quintic, 3 control points"), std::string::npos);
    EXPECT_NE(done.out.find("every check held"), std::string::npos);
    const Json report = Json::parse(program.read("out/report.json"));
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["input"], "join.ngc");
    const Json file = Json::parse(program.read("out/join.json"));
    EXPECT_NEAR(file["start"]["feed"], 25, 1e-12);
    EXPECT_NEAR(file["end"]["feed"], 100.0 / 3, 1e-9);
    EXPECT_NEAR(file["start"]["curvature"][1], 0.05 * std::sqrt(0.75), 1e-7);
    EXPECT_NE(done.out.find("path 2     curvature jumps by 0 /mm, acceleration by 0 g across"),
              std::string::npos);
    EXPECT_EQ(worst(file["result"], "quintic", "curvature"), 0);
    EXPECT_EQ(worst(file["result"], "quintic", "slope_rad"), 0);
    EXPECT_GE(worst(file["result"], "c2", "curvature"), 1e-3);
    EXPECT_GE(worst(file["result"], "moments", "slope_rad"), 1e-3);
    EXPECT_GE(worst(file["result"], "line", "slope_rad"), 0.5);
    EXPECT_GE(worst(file["result"], "arc", "curvature"), 0.05);
    const std::string gcode = program.read("out/join.ngc");
    EXPECT_EQ(gcode.find("Z20"), std::string::npos) << "the rapids between are gone";
    EXPECT_NE(gcode.find("G5.2"), std::string::npos);
    EXPECT_EQ(program.run({"run", "out/join.ngc", "-o", "again", "--on", "kernel"}).status, 0);
}

TEST(Join, LoadedMoveIsTheSameAndTakesOtherChoices) {
    const ProgramRun program;
    const auto join = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "join");
        arguments.insert(arguments.end(), {"--on", "kernel", "-q"});
        const ProgramResult done = program.run(arguments);
        EXPECT_EQ(done.status, 0) << done.err;
    };
    join({kA, kAbove, "--fit", "c2", "--points", "5", "--step", "0.5mm", "-o", "one"});
    join({"--load", "one/join.json", "-o", "two"});
    EXPECT_EQ(program.read("two/join.ngc"), program.read("one/join.ngc"));
    EXPECT_EQ(program.read("two/join.json"), program.read("one/join.json"));
    EXPECT_EQ(program.read("two/join.html"), program.read("one/join.html"));
    join({"--load", "one/join.json", "--least", "jerk", "--exact", "-o", "three"});
    const Json least = Json::parse(program.read("three/join.json"));
    EXPECT_EQ(least["points"].size(), 5U);
    EXPECT_LE(worst(least["result"], "c2", "curvature"), 1e-9);
    EXPECT_EQ(least["gcode"]["form"], "exact");
    EXPECT_NE(program.read("three/join.ngc").find(" R"), std::string::npos) << "G5 in space";
    const ProgramResult cubic =
        program.run({"join", kA, kB, "--fit", "cubic", "-o", "cubic", "--on", "kernel"});
    EXPECT_NE(cubic.out.find("  at its points     curvature jumps by 0.0"), std::string::npos);
    join({kA, kAbove, "-o", "space"});
    EXPECT_EQ(Json::parse(program.read("space/join.json"))["gcode"]["size_mm"], 1e-3);
}

TEST(Join, PointsFilesAreWorkingPathsToo) {
    const ProgramRun program;
    program.write("a.csv", "5,0,0\n10,5,1\n20,0,-2.5\n");
    EXPECT_EQ(program.run({"join", "a.csv", kB, "-o", "out", "--on", "kernel"}).status, 0);
    EXPECT_NE(program.read("out/join.ngc").find("G0 X5 Y0 Z0\n"), std::string::npos);
}

struct BadJoin {
    std::string name;
    std::string a, b;  // programs
    std::vector<std::string> options;
    std::string err;
};

const std::string kGood = "G0 X-5\nG1 X0 F600\n";
const std::string kNext = "G0 X5 Y9\nG1 X-5 F600\n";

const BadJoin kBadJoins[] = {
    {"RapidsOnly",
     "G0 X5\nG0 X7\n",
     kNext,
     {},
     "a.ngc:2: error: no working move: a joint wants a move with a feed (G1, G2, ..)"},
    {"RapidsOnlyBehind",
     kGood,
     "G0 X5\n",
     {},
     "b.ngc:1: error: no working move: a joint wants a move with a feed (G1, G2, ..)"},
    {"Empty", "M2\n", kNext, {}, "a.ngc: error: the program has no moves"},
    {"EndsInADwell",
     "G1 X5 F600\nG4 P1\nG0 Z5\n",
     kNext,
     {},
     "a.ngc:1: error: a dwell (G4) follows the last working move: an idle move goes on from there "
     "without a stop"},
    {"StandsAtItsEnd",
     "F600\nG5 X9 Y9 I3 J0 P0 Q0\n",
     kNext,
     {},
     "a.ngc:2: error: no direction at the joint: the spline stands still there"},
    {"StandsAtItsStart",
     kGood,
     "G0 X9 Y9\nG5 X0 Y0 I0 J0 P3 Q0 F600\n",
     {},
     "b.ngc:2: error: no direction at the joint: the spline stands still there"},
    {"AuxiliaryAxesOnly",
     "G1 X5 F600\nG1 A90\n",
     kNext,
     {},
     "a.ngc:2: error: the move at the joint moves auxiliary axes only: it has no direction"},
    {"AuxiliaryAxesElsewhere",
     kGood,
     "G0 X5 Y9 A90\nG1 X-5 F600\n",
     {},
     "b.ngc:2: error: A begins at 90, a.ngc leaves it at 0: an idle move is of X Y Z alone"},
    {"Together",
     kGood,
     "G0 X0 Y0\nG1 X-5 F600\n",
     {},
     "b.ngc:2: error: begins where a.ngc ends: there is nothing to join"},
    {"BeyondTravel",
     "G1 X900 F600\nG1 X1200\n",
     kNext,
     {},
     "a.ngc:2: error: X = 1200 mm is beyond the machine's travel -1000 .. 1000 mm"},
    {"IdleBeyondTravel",
     "G1 X990 F60000\n",
     "G0 X990 Y200\nG1 X0 F60000\n",
     {"--exact"},
     "join.ngc:10: error: X = 1000.35 mm is beyond the machine's travel -1000 .. 1000 mm"},
    {"TwoForms",
     kGood,
     kNext,
     {"--exact", "--step", "1mm"},
     "curvecore: error: --exact, --tolerance and --step exclude each other"},
    {"ManyChords",
     kGood,
     kNext,
     {"--step", "1nm"},
     "curvecore: error: the idle move becomes more than 1000000 chords"},
    {"FitUnknown",
     kGood,
     kNext,
     {"--fit", "bessel"},
     "curvecore: error: --fit 'bessel': must be one of cubic, moments, c2, quintic"},
    {"PointsNotWhole",
     kGood,
     kNext,
     {"--points", "2.5"},
     "curvecore: error: --points '2.5': must be a whole number in [0, 100]"},
    {"LeastOfTooFew",
     kGood,
     kNext,
     {"--fit", "c2", "--points", "1", "--least", "jerk"},
     "curvecore: error: --least jerk: too few control points to meet tangent and curvature"},
    {"VersionUnknown",
     kGood,
     kNext,
     {"--load", "other.json"},
     "other.json:1: error: is of version 7, this program reads version 1"},
};

class RefusedJoin : public testing::TestWithParam<BadJoin> {};

TEST_P(RefusedJoin, IsSaidAndLeavesNothing) {
    const BadJoin& bad = GetParam();
    const ProgramRun program;
    program.write("a.ngc", bad.a);
    program.write("b.ngc", bad.b);
    program.write("other.json", "{\"curvecore_join\": 7}\n");
    const std::vector<std::string> before = program.files();
    std::vector<std::string> arguments{"join", "a.ngc", "b.ngc", "-o", "out", "--on", "kernel"};
    arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
    const ProgramResult result = program.run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, bad.err + "\n");
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(program.files(), before);
}

INSTANTIATE_TEST_SUITE_P(Cli, RefusedJoin, testing::ValuesIn(kBadJoins),
                         [](const auto& test) { return test.param.name; });

TEST(Join, MoveOfOtherProgramsIsRefused) {
    const ProgramRun program;
    ASSERT_EQ(program.run({"join", kA, kB, "-o", "out", "--on", "kernel"}).status, 0);
    const ProgramResult other =
        program.run({"join", kA, kAbove, "--load", "out/join.json", "-o", "two"});
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(other.err, "out/join.json: error: was made for another end: " + kAbove +
                             " is elsewhere now, or goes another way\n");
    const ProgramResult none = program.run({"join", kA, "-o", "two"});
    EXPECT_EQ(none.err,
              "curvecore: error: join wants two programs, A and B, or --load FILE.json\n");
    EXPECT_EQ(program.files(), std::vector<std::string>{"out"});
}

}  // namespace curvecore::tb::join_test
