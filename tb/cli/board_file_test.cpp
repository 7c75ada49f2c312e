// SPDX-License-Identifier: Apache-2.0
// The option --board: plans use the values of the board's table.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::board_file_test {

using Json = nlohmann::json;

class BoardFile : public testing::Test {
  protected:
    void SetUp() override { program_.write("part.ngc", "G21 G90 F900\nG1 X5\nG3 X7 Y2 J2\nM2\n"); }

    Json words(const std::string& board) {
        const ProgramResult result =
            program_.run({"words", "part.ngc", "-q", "-o", "words", "--board", board});
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(program_.read("words/words.json"));
    }
    void refuse(const std::vector<std::string>& options, const std::string& message) {
        std::vector<std::string> arguments{"words", "part.ngc"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }

    const ProgramRun program_;
};

TEST_F(BoardFile, SaysCorePeriodAndQueues) {
    const Json json = words("tang_nano_20k");
    EXPECT_EQ(json["sample_period_s"].get<double>(), 4096 / 135e6);
    EXPECT_EQ(json["parameters"]["Splines"], 1);
    EXPECT_EQ(json["queue_words"]["segments"], 2048);
    EXPECT_EQ(json["queue_words"]["profile"], 2048);
}

TEST_F(BoardFile, OfOnesOwnIsRead) {
    program_.write("mine.json",
                   R"({"clock_hz": 50e6, "parameters": {"Build": 0, "PeriodLog2": 12, "Order": 5,
                       "ProfileQueueWords": 2048, "MultiplierForm": 1}})");
    const Json json = words("mine.json");
    EXPECT_EQ(json["sample_period_s"].get<double>(), 4096 / 50e6);
    EXPECT_EQ(json["parameters"]["Order"], 5);
    EXPECT_EQ(json["queue_words"]["profile"], 2048);
}

TEST_F(BoardFile, EveryBoardOfTheTreeIsRead) {
    for (const char* name : {"tang_nano_9k", "tang_nano_20k", "icebreaker", "colorlight_i5",
                             "ulx3s_85", "ulx3s_85_parallel"}) {
        EXPECT_GT(words(name)["samples"].get<int>(), 0) << name;
    }
}

TEST_F(BoardFile, OfTheEngineKeepsItsPeriodOrIsRefused) {
    const auto board = [&](int period_log2) {
        program_.write("engine.json", R"({"clock_hz": 100e6, "parameters": {"Build": 2,
                                          "PeriodLog2": )" +
                                          std::to_string(period_log2) + "}}");
        return std::vector<std::string>{"plan", "part.ngc", "-q",         "-o",
                                        "plan", "--board",  "engine.json"};
    };
    const ProgramResult kept = program_.run(board(13));
    EXPECT_EQ(kept.status, 0) << kept.err;
    EXPECT_EQ(Json::parse(program_.read("plan/report.json"))["build"], "engine");
    const ProgramResult late = program_.run(board(10));
    EXPECT_EQ(late.status, 2);
    EXPECT_NE(late.err.find("a sample period has 1024 clocks, and this engine core needs "),
              std::string::npos)
        << late.err;
}

TEST_F(BoardFile, WhatIsNoBoardIsRefused) {
    refuse({"--board", "arty"}, "--board: there is no 'arty': colorlight_i5, icebreaker, ");
    refuse({"--board", "icebreaker", "--core", "core.json"}, "--core or --board");
    program_.write("bad.json", "{\"parameters\": {}}");
    refuse({"--board", "bad.json"}, "bad.json:1: error: 'clock_hz' is missing");
    program_.write("worse.json", R"({"clock_hz": 1e6, "parameters": {"Length": 3}})");
    refuse({"--board", "worse.json"}, "worse.json:1: error: motion_board has no parameter Length");
    for (const char* build : {"1", "3"}) {
        program_.write("build.json",
                       std::string(R"({"clock_hz": 1e6, "parameters": {"Build": )") + build + "}}");
        refuse({"--board", "build.json"},
               "build.json:1: error: Build must be 0 (parallel) or 2 (engine)");
    }
    program_.write("anchor.json", R"({"clock_hz": 1e6, "parameters": {"Build": 2, "Order": 1}})");
    refuse({"--board", "anchor.json"}, "anchor.json:1: error: Order must be in [2, 12]");
    program_.write("wrong.json", "{\"clock_hz\": \"1MHz\",\n \"parameters\": {}}");
    refuse({"--board", "wrong.json"}, "wrong.json:1: error: 'clock_hz': not a number");
    program_.write(
        "device.json",
        "{\"clock_hz\": 1e6, \"parameters\": {},\n \"family\": \"ecp5\", \"device\": {}}");
    refuse({"--board", "device.json"}, "device.json:2: error: 'size' is missing");
    refuse({"--board", "none.json"}, "none.json");
}

}  // namespace curvecore::tb::board_file_test
