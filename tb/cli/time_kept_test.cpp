// SPDX-License-Identifier: Apache-2.0
// Samples within their period: planned, measured, and refused where impossible.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::time_kept_test {

using Json = nlohmann::json;

/// A chain of `count` lines of 0.2 um.
std::string joints(int count) {
    std::string text = "G21 G61 G90 F60000\n";
    for (int n = 1; n <= count; ++n) text += fmt::format("G1 X{:.4f}\n", 2e-4 * n);
    return text + "M2\n";
}

class TimeKept : public testing::Test {
  protected:
    /// Reports a run with a queue that outlasts a stop in moves of 0.2 um: the clocks alone bound
    /// the feed.
    Json report(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin() + 1,
                         {"part.ngc", "-q", "-o", "out", "--segment-queue", "65536"});
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(program_.read("out/report.json"));
    }

    static Json check(const Json& report) {
        for (const Json& one : report.at("checks")) {
            if (one.at("name") == "time kept") return one;
        }
        ADD_FAILURE() << "no such check";
        return {};
    }

    ProgramRun program_;
};

TEST_F(TimeKept, ByTheParallelCoreWithFewClocks) {
    program_.write("part.ngc", joints(300));
    const Json ran = report({"run", "--clock", "1MHz"});
    const Json planned = report({"plan", "--clock", "1MHz"});
    EXPECT_EQ(ran["time_kept"]["clocks_available"], 100);
    EXPECT_GT(ran["time_kept"]["clocks_used"], 50);
    EXPECT_LE(ran["time_kept"]["clocks_used"], 100);
    const double predicted = planned["time_kept"]["clocks_used"];
    EXPECT_NEAR(ran["time_kept"]["clocks_used"], predicted, 0.1 * predicted);
}

TEST_F(TimeKept, IsNotMeasuredWithStalls) {
    program_.write("part.ngc", joints(30));
    const Json stalled = report({"run", "--stall", "1"});
    EXPECT_TRUE(stalled["time_kept"]["clocks_used"].is_null());
    EXPECT_EQ(check(stalled)["detail"], "not measured");
    EXPECT_TRUE(check(stalled)["held"]);
}

TEST_F(TimeKept, APeriodShorterThanTheCoresClocksIsRefused) {
    program_.write("part.ngc", joints(30));
    for (const char* command : {"run", "plan", "words"}) {
        const ProgramResult result =
            program_.run({command, "part.ngc", "-o", "out", "--build", "engine", "--sample-period",
                          "1us", "--clock", "12MHz"});
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("a sample period has 12 clocks, and this engine core needs "),
                  std::string::npos)
            << result.err;
        EXPECT_FALSE(program_.exists("out"));
    }
}

}  // namespace curvecore::tb::time_kept_test
