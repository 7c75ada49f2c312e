// SPDX-License-Identifier: Apache-2.0
// Dialects of G-code: recognised or requested, and reported by every command that reads programs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::dialects_test {

using Arguments = std::vector<std::string>;

const char kPrint[] = "M83\nG28\nG1 X5 Y5 F1200\nG1 X15 E1.5\nG1 E-1 F1800\n";
const char kSaid[] =
    "part.gcode: warning: read as G-code of marlin, which its first lines are of; --dialect names "
    "another\n";

nlohmann::json report(const ProgramRun& program) {
    return nlohmann::json::parse(program.read("out/report.json"));
}

TEST(Dialects, AreSaidByEveryCommandUnlessAskedFor) {
    const ProgramRun program;
    program.write("part.gcode", kPrint);
    for (const Arguments& command :
         {Arguments{"plan"}, Arguments{"run", "--on", "kernel"}, Arguments{"words"},
          Arguments{"compare", "--set", "CoefBits=32"}, Arguments{"explore"}}) {
        Arguments arguments = command;
        arguments.insert(arguments.end(), {"part.gcode", "-q", "-o", "out"});
        const ProgramResult recognised = program.run(arguments);
        EXPECT_EQ(recognised.status, 0) << command[0] << ": " << recognised.err;
        EXPECT_EQ(recognised.err.substr(0, sizeof kSaid - 1), kSaid) << command[0];
        arguments.insert(arguments.end(), {"--dialect", "Marlin"});
        const ProgramResult asked = program.run(arguments);
        EXPECT_EQ(asked.status, 0) << command[0] << ": " << asked.err;
        EXPECT_EQ(asked.err.find("read as G-code of"), std::string::npos) << command[0];
    }
}

TEST(Dialects, AreInTheSummaryAndTheReport) {
    const ProgramRun program;
    program.write("part.gcode", kPrint);
    const ProgramResult recognised = program.run({"plan", "part.gcode", "-o", "out"});
    EXPECT_NE(recognised.out.find("dialect                marlin, recognised\n"), std::string::npos)
        << recognised.out;
    EXPECT_EQ(report(program)["dialect"], "marlin");
    program.write("part.ngc", "G1 X5 F600\n");
    const ProgramResult asked =
        program.run({"plan", "part.ngc", "--dialect", "linuxcnc", "-o", "out"});
    EXPECT_NE(asked.out.find("dialect                linuxcnc\n"), std::string::npos) << asked.out;
    EXPECT_EQ(report(program)["dialect"], "linuxcnc");
    program.write("points.csv", "0 0\n5 1\n9 0\n");
    ASSERT_EQ(program.run({"plan", "points.csv", "-o", "out"}).status, 0);
    EXPECT_FALSE(report(program).contains("dialect"));
}

TEST(Dialects, ChangeWhatIsDrawn) {
    const ProgramRun program;
    program.write("part.nc", "G1 X10 F600\nX2000 Y3\n");
    ASSERT_EQ(program.run({"words", "part.nc", "--dialect", "fanuc", "-q", "-o", "out"}).status, 0);
    const std::string thousandths = program.read("out/segments.hex");
    program.write("part.nc", "G1 X.01 F600\nX2 Y.003\n");
    ASSERT_EQ(program.run({"words", "part.nc", "-q", "-o", "out"}).status, 0);
    EXPECT_EQ(program.read("out/segments.hex"), thousandths);
}

TEST(Dialects, AreJoined) {
    const ProgramRun program;
    const char* const second = "G0 X2 Y14\nG3 X-10 Y12 I-1.170474 J-29.977158 F2000\n";
    program.write("a.ngc", "G1 X-10 F1500\nG3 X0 Y2.679492 I0 J20\n");
    program.write("b.ngc", second);
    ASSERT_EQ(program.run({"join", "a.ngc", "b.ngc", "-q", "--on", "kernel", "-o", "out"}).status,
              0);
    const std::string joined = program.read("out/join.ngc");
    program.write("a.ngc", "G1 X-10000 F1500\nG3 X0 Y2.679492 J20000\n");
    program.write("b.ngc", "G0 X2000 Y14000\nG3 X-10000 Y12. I-1.170474 J-29.977158 F2000\n");
    const Arguments join{"join", "a.ngc", "b.ngc",  "--dialect", "fanuc",
                         "-q",   "--on",  "kernel", "-o",        "out"};
    const ProgramResult done = program.run(join);
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.err.find("a.ngc:1: warning: an axis' number without a point"),
              std::string::npos);
    EXPECT_EQ(program.read("out/join.ngc"), joined);
}

TEST(Dialects, AndEventsOfStandardInputAreInTheReport) {
    const ProgramRun shell("/bin/sh");
    shell.write("part.gcode", "$H\nM3 S500\nG1 X5 Y5 F1200\nM5\nM3\n");
    const auto run = [&shell](const std::string& command) {
        return shell.run({"-c", CURVECORE_PROGRAM " " + command + " -q -o out"});
    };
    ASSERT_EQ(run("plan part.gcode").status, 0);
    const nlohmann::json file = report(shell);
    EXPECT_EQ(file["events"].size(), 5U);
    ASSERT_EQ(run("plan - < part.gcode").status, 0);
    EXPECT_EQ(report(shell)["events"], file["events"]);
    EXPECT_EQ(report(shell)["dialect"], "grbl");
    const std::string kinds =
        R"("events":[["$H",1,1,0.0],["S",1,2,0.0],["M3",2,2,0.0],["M5",1,4,7.0710678118654755]])";
    EXPECT_NE(shell.read("out/report.html").find(kinds), std::string::npos);
    for (const char* const command : {"compare - --set CoefBits=32", "explore -"}) {
        const ProgramResult result = run(command + std::string(" < part.gcode"));
        EXPECT_EQ(result.status, 0) << command << ": " << result.err;
        EXPECT_NE(result.err.find("stdin: warning: read as G-code of grbl"), std::string::npos);
        EXPECT_NE(result.err.find("$H in line 1; M3 in lines 2 and 5; S in line 2"),
                  std::string::npos)
            << result.err;
    }
}

TEST(Dialects, ThatDoNotExistAreRefused) {
    const ProgramRun program;
    program.write("part.ngc", "G1 X5 F600\n");
    const ProgramResult unknown = program.run({"plan", "part.ngc", "--dialect", "haas"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err,
              "curvecore: error: --dialect 'haas': must be one of linuxcnc, grbl, fanuc, marlin\n");
    const ProgramResult both = program.run(
        {"plan", "part.ngc", "--dialect", "grbl", "--interpreter", "linuxcnc", "-o", "out"});
    EXPECT_EQ(both.status, 2);
    EXPECT_EQ(both.err, "curvecore: error: --dialect or --interpreter: LinuxCNC reads its own\n");
}

}  // namespace curvecore::tb::dialects_test
