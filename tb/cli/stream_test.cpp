// SPDX-License-Identifier: Apache-2.0
// Programs of any length: words equal to those of a plan, and up to the last valid block of a
// pipe.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/long_programs.hpp"

namespace curvecore::tb::stream_test {

using Json = nlohmann::json;

TEST(Stream, WordsOfALongProgramAreThoseOfItsPlan) {
    const ProgramRun program;
    program.write("part.ngc", raster(9000, "G61"));
    for (const char* command : {"words", "plan"}) {
        const ProgramResult result = program.run({command, "part.ngc", "-q", "-o", command});
        ASSERT_EQ(result.status, 0) << result.err;
    }
    const Json words = Json::parse(program.read("words/words.json"));
    const Json plan = Json::parse(program.read("plan/report.json"));
    EXPECT_EQ(words["segments"]["count"], plan["segments"]);
    EXPECT_EQ(words["profile"]["count"], plan["profile_pieces"]);
    EXPECT_EQ(words["samples"], plan["samples"]);
    const Json segments = Json::parse(program.read("plan/segments.json"))["segments"];
    const std::string memory = program.read("words/segments.hex");
    for (std::size_t i = 0; i < segments.size(); i += 500) {
        const std::string first = segments[i]["words"][0];
        EXPECT_NE(memory.find(fmt::format("// segment {}, line {}\n{}\n", i,
                                          segments[i]["line"].get<int>(), first)),
                  std::string::npos)
            << i;
    }
}

/// A machine that ends at y = 0, where a rounded curve joins a line: the smooth path would leave
/// the machine. Such groups are drawn as programmed, the others are smooth.
TEST(Stream, DrawsAsProgrammedWhatTheMachineCannotHaveSmooth) {
    const ProgramRun program;
    const auto hills = [](double y) {
        std::string text;
        for (int i = 1; i <= 15; ++i) {
            text += fmt::format("G1 X{:.4f} Y{:.4f}\n", 0.4 * i,
                                y - 1.5 + 1.5 * std::cos(i * M_PI / 15));
        }
        for (int i = 1; i <= 15; ++i) {
            text += fmt::format("G1 X{:.4f} Y{:.4f}\n", 6 + 0.4 * i,
                                y - 1.5 - 1.5 * std::cos(i * M_PI / 15));
        }
        return text + fmt::format("G1 X20 Y{:.4f}\n", y);
    };
    const std::string head = "G21 G90 G64 P0.05 F3000\n";
    const std::string away = "G61 G0 X0 Y-1\nG64 P0.05\n";
    const auto write = [&](const char* name, double y) {
        program.write(name, fmt::format("{}{}{}{}M2\n", head, hills(y), away, hills(-1)));
    };
    write("at_the_end.ngc", 0);
    write("within.ngc", -0.2);
    std::string ini = "[TRAJ]\nCOORDINATES = X Y Z\nLINEAR_UNITS = mm\n";
    for (const char axis : {'X', 'Y', 'Z'}) {
        ini += fmt::format("[AXIS_{}]\nMIN_LIMIT = -100\nMAX_LIMIT = {}\n", axis,
                           axis == 'Y' ? 0 : 100);
    }
    program.write("small.ini", ini);
    const auto words = [&](std::vector<std::string> arguments, int warnings) {
        arguments.insert(arguments.begin(), "words");
        arguments.insert(arguments.end(), {"-q", "-o", "out", "--machine", "small.ini"});
        const ProgramResult result = program.run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        int said = 0;
        const std::string warning = "drawn as programmed";
        for (std::size_t at = 0; (at = result.err.find(warning, at)) != std::string::npos; ++at) {
            ++said;
        }
        EXPECT_EQ(said, warnings) << result.err;
        return Json::parse(program.read("out/words.json"))["samples"].get<int>();
    };
    const int exact = words({"at_the_end.ngc", "--path", "exact"}, 0);
    const int in_part = words({"at_the_end.ngc"}, 1);
    const int smooth = words({"within.ngc"}, 0);
    EXPECT_LT(in_part, 0.98 * exact);
    EXPECT_LT(smooth, 0.98 * in_part);
}

TEST(Stream, SegmentsAreWrittenUnlessTheyAreNotWanted) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 F900\nG1 X10\n");
    ASSERT_EQ(program.run({"plan", "part.ngc", "-q", "-o", "plan"}).status, 0);
    EXPECT_TRUE(program.exists("plan/segments.json"));
    ASSERT_EQ(program.run({"plan", "part.ngc", "-q", "--no-segments", "-o", "plan"}).status, 0);
    EXPECT_FALSE(program.exists("plan/segments.json"));
}

class Pipe : public testing::Test {
  protected:
    ProgramResult words(const std::string& text) {
        shell_.write("part.ngc", text);
        return shell_.run({"-c", "cat part.ngc | " CURVECORE_PROGRAM " words - -q -o words"});
    }
    ProgramRun shell_{"/bin/sh"};
};

TEST_F(Pipe, AFaultAfterTheFirstWordsLeavesWhatWasGood) {
    const std::string good = raster(9000, "G61");
    const ProgramResult result = words(good + "G1 X3000\n");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("stdin:9002: error: X = 3000 mm is beyond"), std::string::npos);
    EXPECT_EQ(shell_.read("words/INCOMPLETE"), result.err.substr(result.err.find("stdin:")));
    const Json broken = Json::parse(shell_.read("words/words.json"));
    ASSERT_EQ(words(good).status, 0);
    EXPECT_FALSE(shell_.exists("words/INCOMPLETE"));
    const Json whole = Json::parse(shell_.read("words/words.json"));
    EXPECT_EQ(broken["segments"]["count"], whole["segments"]["count"]);
    EXPECT_EQ(broken["path_quanta"], whole["path_quanta"]);
}

TEST_F(Pipe, AFaultBeforeTheFirstWordsLeavesNothing) {
    EXPECT_EQ(words("G21 G90 F900\nG1 X3000\n").status, 2);
    EXPECT_FALSE(shell_.exists("words"));
}

TEST_F(Pipe, WhatTheFirstMovesDoNotShowIsRefused) {
    const ProgramResult axis = words(raster(9000, "G61") + "G1 A5\n");
    EXPECT_EQ(axis.status, 2);
    EXPECT_NE(axis.err.find("stdin:9002: error: an axis that the first moves"), std::string::npos);
    const ProgramResult spline = words(raster(9000, "G61") + "G5 X9 Y6 I0 J3 P-2 Q0\n");
    EXPECT_EQ(spline.status, 2);
    EXPECT_NE(spline.err.find("give --set Splines=1"), std::string::npos) << spline.err;
}

/// A file's fault is reported before a word is written.
TEST(Stream, AFileIsLookedAtFirst) {
    const ProgramRun program;
    program.write("part.ngc", raster(9000, "G61") + "G1 X3000\n");
    const ProgramResult result = program.run({"words", "part.ngc", "-q", "-o", "words"});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("part.ngc:9002: error: X = 3000 mm is beyond"), std::string::npos);
    EXPECT_FALSE(program.exists("words"));
    program.write("part.ngc", raster(9000, "G61") + "G1 A5\n");
    EXPECT_EQ(program.run({"words", "part.ngc", "-q", "-o", "words"}).status, 0);
    EXPECT_EQ(Json::parse(program.read("words/words.json"))["parameters"]["AuxAxes"], 1);
}

}  // namespace curvecore::tb::stream_test
