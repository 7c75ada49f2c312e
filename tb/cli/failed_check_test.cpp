// SPDX-License-Identifier: Apache-2.0
// Failed checks: each is named and sets the exit status, in the program with a core that rounds
// wrongly (tb/mutants).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::failed_check_test {

constexpr char kPart[] = "G21 G61 G90 F450\nG1 X0.1\nG3 X0.2 Y0.1 I0 J0.1\nM2\n";

std::vector<std::string> failed_checks(const ProgramRun& program) {
    const nlohmann::json report = nlohmann::json::parse(program.read("out/report.json"));
    std::vector<std::string> names;
    for (const nlohmann::json& check : report.at("checks")) {
        if (!check["held"].get<bool>()) names.push_back(check["name"]);
    }
    return names;
}

TEST(FailedCheck, GivesStatusOneAndItsName) {
    const ProgramRun program(CURVECORE_WRONG_ROUNDING);
    program.write("part.ngc", kPart);
    const ProgramResult result = program.run({"run", "part.ngc", "-o", "out"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.rfind("curvecore: check failed: RTL equals kernel: ", 0), 0U)
        << result.err;
    EXPECT_NE(result.out.find("A CHECK FAILED"), std::string::npos) << result.out;
    EXPECT_EQ(failed_checks(program), std::vector<std::string>{"RTL equals kernel"});
}

TEST(FailedCheck, IsNamedWhenQuiet) {
    const ProgramRun program(CURVECORE_WRONG_ROUNDING);
    program.write("part.ngc", kPart);
    const ProgramResult result = program.run({"run", "part.ngc", "-q", "-o", "out"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.rfind("curvecore: check failed: RTL equals kernel: ", 0), 0U)
        << result.err;
    EXPECT_EQ(result.out, "");
}

TEST(FailedCheck, IsTheCoresDoing) {
    const ProgramRun program;
    program.write("part.ngc", kPart);
    const ProgramResult result = program.run({"run", "part.ngc", "-o", "out"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(failed_checks(program), std::vector<std::string>{});
}

}  // namespace curvecore::tb::failed_check_test
