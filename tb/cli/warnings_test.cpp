// SPDX-License-Identifier: Apache-2.0
// Warnings: every command that reads programs reports requests that are not met, with line and
// cause.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::warnings_test {

using Arguments = std::vector<std::string>;

const char kSwitches[] = "G21 G90 G64 F600\nT1 M6\nS1000 M3 M8\nG1 X10\nG1 X20 S500\nM5 M9\nM2\n";
const char kSaid[] =
    "part.ngc:2: warning: only axes move, nothing is switched or waited for: M6 in line 2; T in "
    "line "
    "2; M3 in line 3; M8 in line 3; S in lines 3 and 5; M5 in line 6; M9 in line 6; moves of "
    "different S become one\n";

TEST(Warnings, WhatSwitchesSomethingIsNamedByEveryCommand) {
    const ProgramRun program;
    program.write("part.ngc", kSwitches);
    for (const Arguments& command :
         {Arguments{"plan"}, Arguments{"run", "--on", "kernel"}, Arguments{"words"},
          Arguments{"compare", "--set", "CoefBits=32"}, Arguments{"explore"}}) {
        Arguments arguments = command;
        arguments.insert(arguments.end(), {"part.ngc", "-q", "-o", "out"});
        const ProgramResult result = program.run(arguments);
        EXPECT_EQ(result.status, 0) << command[0] << ": " << result.err;
        EXPECT_EQ(result.err, kSaid) << command[0];
    }
    const std::string next = std::string(DATA_DIR) + "/pass_2.ngc";
    const ProgramResult joined =
        program.run({"join", "part.ngc", next, "--on", "kernel", "-q", "-o", "joined"});
    EXPECT_NE(joined.err.find(kSaid), std::string::npos) << joined.err;
}

/// Tangent moves of half a micrometre between long ones: two changes within a very short path.
TEST(Warnings, WhatTheClockSlowsIsNamedWithItsLine) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 G61 F6000\nG1 X20\nG1 X20.0005\nG1 X40\nM2\n");
    const auto plan = [&](const char* clock) {
        const ProgramResult result = program.run({"plan", "part.ngc", "--build", "serial", "--set",
                                                  "Mode=1", "--clock", clock, "-q", "-o", "out"});
        EXPECT_EQ(result.status, 0) << result.err;
        return result.err;
    };
    EXPECT_EQ(plan("100MHz"), "");
    const std::string said = plan("2.2MHz");
    EXPECT_EQ(said.substr(0, 19), "part.ngc:3: warning") << said;
    EXPECT_NE(said.find("this core takes its time for their steps"), std::string::npos) << said;
}

TEST(Warnings, PlansAreForTheQueuesOfTheCoreUnlessTold) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 F600\nG1 X10\nM2\n");
    ASSERT_EQ(program.run({"words", "part.ngc", "-q", "-o", "out"}).status, 0);
    const auto queues = nlohmann::json::parse(program.read("out/words.json"))["queue_words"];
    EXPECT_EQ(queues["segments"], 4096);
    EXPECT_EQ(queues["profile"], 4096);
}

}  // namespace curvecore::tb::warnings_test
