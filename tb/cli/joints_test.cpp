// SPDX-License-Identifier: Apache-2.0
// Machines whose joints bend a line: their parts keep path and limits at any override, on the
// kernel and as the engine's RTL draws them; what they cannot do is refused.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::joints_test {

using Arguments = std::vector<std::string>;

std::string machine(const std::string& name) {
    return std::string(DATA_DIR) + "/machines/" + name + ".ini";
}

/// A part of lines, arcs, rapids and rests that a machine's tool reaches.
std::string part_of(const std::string& name) {
    if (name == "scara") {
        return "G21 G90 G64 P0.02\nG0 X250 Y-30 Z5\nG1 X250 Y-10 Z1 F4000\nG2 X240 Y0 I-10 J0\n"
               "G1 X231 Y4\nG4 P0.01\nG3 X220 Y-8 R20\nG0 Z5\nM2\n";
    }
    if (name == "trunnion") {
        return "G21 G90 G64 P0.02\nG0 X10 Y-5 Z5 A0 C0\nG1 X12 Y4 Z0 A8 C-20 F2500\n"
               "G2 X8 Y8 I-4 J0\nG1 X-3 Y3 A-5 C10\nG1 A0 C0\nG0 Z5\nM2\n";
    }
    return "G21 G90 G64 P0.02\nG0 X40 Y20 Z5\nG1 X44 Y31 Z1 F4000\nG2 X34 Y41 I-10 J0\nG1 X26 Y40\n"
           "G4 P0.01\nG3 X20 Y25 R20\nG0 Z5\nM2\n";
}

class JointsCommand : public testing::TestWithParam<std::string> {
  protected:
    JointsCommand() { program_.write("part.ngc", part_of(GetParam())); }

    /// Runs the part, and checks what its report says of tool and limits.
    void keeps(const Arguments& more) const {
        Arguments all{"run", "part.ngc", "--machine", machine(GetParam()), "-o", "out", "-q"};
        all.insert(all.end(), more.begin(), more.end());
        const ProgramResult result = program_.run(all);
        ASSERT_EQ(result.status, 0) << result.err;
        const auto report = nlohmann::json::parse(program_.read("out/report.json"));
        EXPECT_EQ(report["rtl_equals_kernel"], 0);
        EXPECT_LT(report["joints"]["of_bound"], 1);
        EXPECT_GT(report["joints"]["of_bound"], 0.01);
        EXPECT_LT(report["joints"]["tool_off_mm"], 1e-6);
        for (const char* limit : {"velocity", "acceleration", "jerk"}) {
            EXPECT_LE(report["limits"]["samples"][limit], 1) << limit;
        }
    }

    ProgramRun program_;
};

TEST_P(JointsCommand, KeepsToolAndLimitsOnTheKernel) {
    keeps({"--on", "kernel"});
    keeps({"--on", "kernel", "--override", "99"});
    keeps({"--on", "kernel", "--override", "40", "--effort", "rules"});
    keeps({"--on", "kernel", "--path", "exact", "--set", "Order=4"});
}

TEST_P(JointsCommand, IsDrawnByTheEngine) { keeps({"--sample-period", "500us"}); }

INSTANTIATE_TEST_SUITE_P(Machines, JointsCommand,
                         testing::Values("corexy", "delta", "polar", "scara", "trunnion"),
                         [](const auto& of) { return of.param; });

TEST(JointsRefusal, NamesWhatThereIsNot) {
    const ProgramRun program;
    program.write("part.ngc", part_of("delta"));
    const auto refusal = [&](Arguments more) {
        Arguments all{"run", "part.ngc", "-o", "out"};
        all.insert(all.end(), more.begin(), more.end());
        const ProgramResult result = program.run(all);
        EXPECT_EQ(result.status, 2);
        EXPECT_FALSE(program.exists("out"));
        return result.err;
    };
    const std::string delta = machine("delta");
    EXPECT_NE(refusal({"--machine", delta, "--build", "parallel"})
                  .find("--machine: joints are drawn by --build engine"),
              std::string::npos);
    EXPECT_NE(refusal({"--machine", delta, "--curve", "clothoid"})
                  .find("--curve: the core draws this machine's joints, no other table"),
              std::string::npos);
    EXPECT_NE(refusal({"--machine", machine("scara")})
                  .find("times as far as the tool; [KINS] JOINT_RATIO allows 1.9"),
              std::string::npos);
    for (const char* command : {"compare", "choose", "join"}) {
        Arguments all{command, "--machine", delta, "-o", "out"};
        if (command == std::string("choose")) {
            all.insert(all.end(), {"--error", "1um", "--radius", "1mm", "--feed", "1m/min",
                                   "--device", "up5k"});
        } else {
            all.emplace_back("part.ngc");
            if (command == std::string("join")) all.emplace_back("part.ngc");
        }
        const ProgramResult result = program.run(all);
        EXPECT_EQ(result.status, 2) << command;
        EXPECT_NE(result.err.find(std::string("--machine: delta.ini has lineardeltakins, and ") +
                                  command + " draws no joints"),
                  std::string::npos)
            << result.err;
    }
    program.write("robot.ini", "[KINS]\nKINEMATICS = pumakins\n[TRAJ]\n");
    EXPECT_NE(refusal({"--machine", "robot.ini"})
                  .find("robot.ini:2: error: KINEMATICS = pumakins: one of trivkins, corexykins"),
              std::string::npos);
}

}  // namespace curvecore::tb::joints_test
