// SPDX-License-Identifier: Apache-2.0
// State in which a program begins, from options and the machine's .ini, and codes that are no
// motion: report.json lists them with line and path length.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::program_start_test {

using Json = nlohmann::json;

// Raises by 5 mm above the tool's tip, goes 10 mm, then 10 mm more with coolant.
const char kTooled[] = "T1 M6\nG43 H1\nG0 Z5\nF600 M3 S100\nG1 X10\nM8\nG1 X20\nM5\nM2\n";

Json plan(const ProgramRun& program, const std::vector<std::string>& options) {
    std::vector<std::string> all{"plan", "part.ngc", "-q", "-o", "out"};
    all.insert(all.end(), options.begin(), options.end());
    const ProgramResult result = program.run(all);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(program.read("out/report.json"));
}

TEST(ProgramStart, ToolsOfATableOrOfTheMachineHaveTheirLength) {
    const ProgramRun program;
    program.write("part.ngc", kTooled);
    program.write("tools.tbl", "T1 P1 Z10.5 D6\n");
    program.write("mill.ini", "[TRAJ]\nLINEAR_UNITS = mm\n[EMCIO]\nTOOL_TABLE = tools.tbl\n");
    const auto first_coolant = [](const Json& report) {
        for (const Json& event : report["events"]) {
            if (event["code"] == "M8") return event["path_mm"].get<double>();
        }
        return -1.0;
    };
    EXPECT_DOUBLE_EQ(first_coolant(plan(program, {})), 5 + 10);
    EXPECT_DOUBLE_EQ(first_coolant(plan(program, {"--tools", "tools.tbl"})), 15.5 + 10);
    EXPECT_DOUBLE_EQ(first_coolant(plan(program, {"--machine", "mill.ini"})), 15.5 + 10);
}

TEST(ProgramStart, EventsHaveLineCodeValueAndPath) {
    const ProgramRun program;
    program.write("part.ngc", kTooled);
    const Json events = plan(program, {})["events"];
    ASSERT_EQ(events.size(), 6U);
    const Json spindle = {{"line", 4}, {"code", "S"}, {"value", 100.0}, {"path_mm", 5.0}};
    EXPECT_EQ(events[2], spindle);
    EXPECT_EQ(events[5]["code"], "M5");
    EXPECT_DOUBLE_EQ(events[5]["path_mm"].get<double>(), 25);
}

TEST(ProgramStart, RadiiMayDifferByWhatIsAsked) {
    const ProgramRun program;
    program.write("part.ngc", "G0 X10\nG2 X0 Y10.05 I-10 J0 F600\nM2\n");
    const ProgramResult refused = program.run({"plan", "part.ngc", "-q", "-o", "out"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err,
              "part.ngc:2: error: the arc's radii differ: 10 mm at the start, 10.05 mm at the end; "
              "the centre I-10.0249 J0.0250622 would fit; --arc-tolerance allows more than "
              "0.0283 mm\n");
    EXPECT_FALSE(program.exists("out"));
    plan(program, {"--arc-tolerance", "0.06mm"});
}

TEST(ProgramStart, WrongTablesAreNamed) {
    const ProgramRun program;
    program.write("part.ngc", kTooled);
    program.write("bad.tbl", "T1 P1 Z10\nT2 P2 Zx\n");
    const ProgramResult bad = program.run({"plan", "part.ngc", "--tools", "bad.tbl"});
    EXPECT_EQ(bad.status, 2);
    EXPECT_EQ(bad.err, "bad.tbl:2: error: Zx is no word of a tool table\n");
    const ProgramResult none = program.run({"plan", "part.ngc", "--tools", "none.tbl"});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err, "none.tbl: error: no such file\n");
}

}  // namespace curvecore::tb::program_start_test
