// SPDX-License-Identifier: Apache-2.0
// `--interpreter linuxcnc` with recorded lines in place of the interpreter: the drawn path, and
// messages on invalid lines. No test needs LinuxCNC.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::linuxcnc_test {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr char kStart[] = R"({"kind":"start","at":[0,0,0,0,0,0,0,0,0]})"
                          "\n";
constexpr char kLine[] = R"({"kind":"line","line":1,"to":[2,0,0,0,0,0,0,0,0],"feed":10})"
                         "\n";
constexpr char kEnd[] = R"({"kind":"end"})"
                        "\n";

class Linuxcnc : public testing::Test {
  protected:
    void TearDown() override { unsetenv("CURVECORE_LINUXCNC"); }

    /// Sets a shell script that runs in place of the interpreter.
    void stand_in(const std::string& script) const {
        program_.write("part.ngc", "what stands here is the interpreter's affair\n");
        program_.write("interpreter", "#!/bin/sh\n" + script);
        const fs::path file = program_.folder() / "interpreter";
        fs::permissions(file, fs::perms::owner_all);
        setenv("CURVECORE_LINUXCNC", file.c_str(), 1);
    }

    ProgramResult run(const char* command, const std::string& lines,
                      const std::string& behind = "") const {
        program_.write("lines", lines);
        stand_in("cat lines\n" + behind);
        return program_.run({command, "part.ngc", "--interpreter", "linuxcnc", "-q", "-o", "out"});
    }

    void expect_refused(const std::string& lines, const std::string& message,
                        const std::string& behind = "") const {
        const ProgramResult result = run("plan", lines, behind);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err.substr(0, 9 + message.size()), "part.ngc:" + message) << result.err;
        EXPECT_FALSE(program_.exists("out"));
    }

    ProgramRun program_;
};

TEST_F(Linuxcnc, DrawsEveryKindOfMove) {
    const ProgramResult result =
        run("plan", std::string(kStart) +
                        R"({"kind":"path","mode":"exact path","tolerance":0})"
                        "\n"
                        R"({"kind":"rapid","line":2,"to":[1,0,0,0,0,0,0,0,0]})"
                        "\n"
                        R"({"kind":"line","line":3,"to":[3,0,0,10,0,0,0,0,0],"feed":5})"
                        "\n"
                        R"({"kind":"dwell","seconds":0.5})"
                        "\n"
                        R"({"kind":"arc","line":4,"to":[3,0,1,10,0,0,0,0,0],)"
                        R"("centre":[3,2,0],"normal":[0,0,-1],"turns":2,"feed":5})"
                        "\n"
                        R"({"kind":"stop"})"
                        "\n"
                        R"({"kind":"nurbs","line":5,"to":[6,0,1,10,0,0,0,0,0],"order":4,)"
                        R"("points":[[3,0,1],[4,1,1],[5,1,1],[6,0,1]],)"
                        R"("weights":[1,1,1,1],"feed":5})"
                        "\n"
                        R"({"kind":"warning","line":6,"text":"mind the gap"})"
                        "\n" +
                        kEnd);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "part.ngc:6: warning: mind the gap\n");
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["moves"], 4);
    const Json segments = Json::parse(program_.read("out/segments.json"))["segments"];
    double turned = 0;
    for (const Json& segment : segments) {
        if (segment["line"] == 4) turned += segment["length_mm"].get<double>();
    }
    EXPECT_NEAR(turned, std::hypot(2 * 2 * M_PI * 2, 1), 1e-5);
    EXPECT_NEAR(segments.back()["end_mm"][0].get<double>(), 6, 1e-9);
    EXPECT_EQ(segments.back()["kind"], "spline");
}

TEST_F(Linuxcnc, WhatSwitchesSomethingIsNamed) {
    const ProgramResult result =
        run("plan", std::string(kStart) +
                        R"({"kind":"left out","code":"M62","line":7})"
                        "\n"
                        R"({"kind":"left out","code":"S","line":8,"value":5})"
                        "\n" +
                        kLine + kEnd);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err,
              "part.ngc:7: warning: only axes move, nothing is switched or waited for: M62 in line "
              "7; S in line 8\n");
}

TEST_F(Linuxcnc, MessagesKeepLineAndText) {
    expect_refused(std::string(kStart) + kLine +
                       R"({"kind":"error","line":7,"text":"Unknown word"})"
                       "\n",
                   "7: error: Unknown word\n");
}

TEST_F(Linuxcnc, LinesThatAreWrongAreRefused) {
    const auto third = [](const std::string& text) { return std::string(kStart) + kLine + text; };
    expect_refused(third("{\"kind\":\"line\",\"to\":[NaN]}\n"),
                   " error: the interpreter's line 3 is not understood: ");
    expect_refused(third("{\"kind\":\"line\",\"line\":1,\"to\":[1,2]}\n"),
                   " error: the interpreter's line 3 is not understood: ");
    expect_refused(third("{\"kind\":\"hop\"}\n"),
                   " error: the interpreter's line 3 is of an unknown kind, hop\n");
    expect_refused(third("[]\n"), " error: the interpreter's line 3 is not understood: ");
    expect_refused(third(R"({"kind":"line","line":4,"to":[1e300,0,0,0,0,0,0,0,0],"feed":10})"
                         "\n"),
                   "4: error: the target is out of range: beyond 1000000 mm\n");
    expect_refused(third(R"({"kind":"line","line":4,"to":[3,0,0,0,0,0,0,0,0]})"
                         "\n"),
                   "4: error: the feed is out of range: 0 mm/min\n");
    expect_refused(third(R"({"kind":"arc","line":4,"to":[3,0,0,0,0,0,0,0,0],"centre":[3,0,0],)"
                         R"("normal":[0,0,1],"turns":1,"feed":1})"
                         "\n"),
                   "4: error: the arc's radius is 0\n");
    expect_refused(third(R"({"kind":"arc","line":4,"to":[2,0,0,0,0,0,0,0,0],"centre":[2,1,0],)"
                         R"("normal":[0,0,2],"turns":1,"feed":1})"
                         "\n"),
                   "4: error: the arc's normal is no unit vector\n");
    expect_refused(third(R"({"kind":"arc","line":4,"to":[2,0,0,0,0,0,0,0,0],"centre":[2,1,0],)"
                         R"("normal":[0,0,1],"turns":0,"feed":1})"
                         "\n"),
                   "4: error: an arc of 0 turns: 1 to 10000 are drawn\n");
    expect_refused(third(R"({"kind":"nurbs","line":4,"to":[2,0,0,0,0,0,0,0,0],"order":3,)"
                         R"("points":[[2,0,0],[1,1,0]],"weights":[1,1],"feed":1})"
                         "\n"),
                   "4: error: a NURBS of order 3 with 2 points and 2 weights\n");
    expect_refused(third(R"({"kind":"nurbs","line":4,"to":[2,2,0,0,0,0,0,0,0],"order":2,)"
                         R"("points":[[2,0,0],[2,2,0]],"weights":[1,0],"feed":1})"
                         "\n"),
                   "4: error: the weight 0 is not above 0\n");
    expect_refused(third("{\"kind\":\"dwell\",\"seconds\":-1}\n"),
                   " error: a dwell must be 0 to 86400 seconds, not -1\n");
    expect_refused(third(kStart),
                   " error: the machine is said to stand elsewhere after its first motion\n");
    expect_refused(std::string(kStart) + kEnd, " error: the program has no moves\n");
}

TEST_F(Linuxcnc, InterpreterThatEndsBeforeTheProgramIsAnError) {
    const std::string ended = " error: LinuxCNC's interpreter ended before the program did: ";
    const std::string moves = std::string(kStart) + kLine;
    expect_refused(moves, ended + "exit status 0\n");
    expect_refused(moves + "{\"kind\":\"end\"}", ended + "exit status 0\n");  // a truncated line
    expect_refused(moves, ended + "exit status 3; it says: no memory\n",
                   "echo no memory >&2; exit 3\n");
    expect_refused(moves, ended + "signal 11 (Segmentation fault)\n", "kill -SEGV $$\n");
    setenv("CURVECORE_LINUXCNC", "/nowhere", 1);
    const ProgramResult result =
        program_.run({"plan", "part.ngc", "--interpreter", "linuxcnc", "-o", "out"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "part.ngc:" + ended + "exit status 127\n");
}

TEST_F(Linuxcnc, WordsAndJoinReadItToo) {
    const ProgramResult words = run("words", std::string(kStart) + kLine + kEnd);
    ASSERT_EQ(words.status, 0) << words.err;
    EXPECT_TRUE(program_.exists("out/segments.hex"));
    stand_in("echo '" + std::string(kStart) + kLine + "'\necho '" + kEnd + "'\n");
    program_.write("lines", std::string(kStart) + kLine + kEnd);
    stand_in(
        "case $1 in *b.ngc) sed 's/\\[0,0,0/[9,0,0/; s/\\[2,0,0/[11,0,0/' lines ;;\n"
        "*) cat lines ;; esac\n");
    program_.write("b.ngc", "");
    const ProgramResult join = program_.run({"join", "part.ngc", "b.ngc", "--interpreter",
                                             "linuxcnc", "--on", "kernel", "-q", "-o", "joined"});
    EXPECT_EQ(join.status, 0) << join.err;
}

TEST_F(Linuxcnc, PointsAndPipesAreNotForIt) {
    for (const char* file : {"points.csv", "-"}) {
        const ProgramResult result =
            program_.run({"plan", file, "--interpreter", "linuxcnc", "-o", "out"});
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err, "curvecore: error: --interpreter linuxcnc is for files of G-code\n");
    }
}

}  // namespace curvecore::tb::linuxcnc_test
