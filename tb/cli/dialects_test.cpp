// SPDX-License-Identifier: Apache-2.0
// Dialects of G-code: recognised or requested, and reported by every command that reads programs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {
namespace {

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

}  // namespace
}  // namespace curvecore::tb
