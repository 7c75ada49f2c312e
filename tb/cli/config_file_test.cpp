// SPDX-License-Identifier: Apache-2.0
// Defaults of options from a file: curvecore.toml, or what --config names.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::config_file_test {

using Json = nlohmann::json;

constexpr const char* kPart = "G21 G90 G61 F600\nG1 X2 Y1\nM2\n";

/// A folder with a part and a file of defaults.
class ConfigFile : public testing::Test {
  protected:
    ConfigFile() { program_.write("part.ngc", kPart); }

    Json plan(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"plan", "part.ngc", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        said_ = result.err;
        return Json::parse(result.out);
    }

    void expect_refused(const std::string& text, const std::string& message,
                        const std::vector<std::string>& more = {}) {
        program_.write("bad.toml", text);
        std::vector<std::string> arguments{"plan", "part.ngc", "--config", "bad.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 2) << text;
        EXPECT_EQ(result.err, message + "\n");
        EXPECT_EQ(result.out, "");
    }

    ProgramRun program_;
    std::string said_;
};

TEST_F(ConfigFile, OfTheWorkingFolderIsReadAndSaidToBe) {
    program_.write("curvecore.toml",
                   "# defaults\nunit = \"10nm\"  # of all\n\n[run]\nunit=\"1um\"\n");
    EXPECT_EQ(plan()["unit_mm"], 1e-5);
    EXPECT_EQ(said_, "curvecore: of curvecore.toml: --unit\n");
    EXPECT_EQ(plan({"-q"})["unit_mm"], 1e-5);
    EXPECT_EQ(said_, "");
}

TEST_F(ConfigFile, IsReplacedByTheLineAndByTheCommandsOwn) {
    program_.write("curvecore.toml", "unit = \"1um\"\n");
    program_.write("mine.toml",
                   "unit = \"10nm\"\nset = [\"Order=4\", \"CoefBits=30\"]\n"
                   "[plan]\nunit = '100nm'\nsample-period = 50us\nno-segments = true\n");
    const std::vector<std::string> mine{"--config", "mine.toml"};
    Json report = plan(mine);
    EXPECT_EQ(report["unit_mm"], 1e-4);
    EXPECT_EQ(report["sample_period_s"], 50e-6);
    EXPECT_EQ(report["parameters"]["Order"], 4);
    EXPECT_EQ(report["parameters"]["CoefBits"], 30);
    EXPECT_EQ(said_, "");
    report = plan({"--config=mine.toml", "--unit", "1nm", "--set", "Order=5"});
    EXPECT_EQ(report["unit_mm"], 1e-6);
    EXPECT_EQ(report["parameters"]["Order"], 5);
    EXPECT_EQ(report["parameters"]["CoefBits"], 36);
    EXPECT_EQ(report["sample_period_s"], 50e-6);
}

TEST_F(ConfigFile, WhatIsWrongInItIsRefusedWithItsLine) {
    expect_refused("\nunti = \"1nm\"\n",
                   "bad.toml:2: error: no command has an option 'unti'; did you mean 'unit'?");
    expect_refused("[plan]\nfeeed = \"1m/min\"\n",
                   "bad.toml:2: error: plan has no option 'feeed'; did you mean 'feed'?");
    expect_refused(
        "[plan]\nlisten = \"here\"\n",
        "bad.toml:2: error: plan has no option 'listen'; curvecore plan --help-all lists "
        "them");
    expect_refused("[rum]\n", "bad.toml:1: error: there is no command 'rum'; did you mean 'run'?");
    expect_refused("no-segments = maybe\n",
                   "bad.toml:1: error: no-segments is a switch: true or false");
    expect_refused("unit = \"1nm\"\nunit = \"2nm\"\n", "bad.toml:2: error: 'unit' is there twice");
    for (const char* text : {"quiet\n", "set = [\"Order=5\",\n\"CoefBits=30\"]\n", "x\n"}) {
        expect_refused(text, "bad.toml:1: error: expected name = value, or [command], in one line");
    }
    for (const char* text : {"unit =\n", "unit = \"1um\n", "unit = \"1#um\"\n"}) {
        expect_refused(text, "bad.toml:1: error: expected a value, or \"a value\" without # in it");
    }
    expect_refused("unit = \"1parsec\"\n",
                   "bad.toml:1: error: --unit '1parsec': the unit must be nm, um, mm, m or in");
    // Of a value on the line the file's line says nothing.
    expect_refused("sample-period = \"50us\"\n",
                   "curvecore: error: --unit '1parsec': the unit must be nm, um, mm, m or in",
                   {"--unit", "1parsec"});
    const ProgramResult none = program_.run({"plan", "part.ngc", "--config", "none.toml"});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err, "none.toml: error: no such file\n");
    EXPECT_EQ(program_.files(), (std::vector<std::string>{"bad.toml", "part.ngc"}));
}

TEST_F(ConfigFile, OptionsThatDoNotGoTogetherAreOfTheFirstThatIsNamed) {
    program_.write("bad.toml", "[run]\nstall = 1\non = \"kernel\"\n");
    const ProgramResult result = program_.run({"run", "part.ngc", "--config", "bad.toml"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "bad.toml:2: error: --stall is for --on rtl and systemc-rtl\n");
}

TEST_F(ConfigFile, LeavesWhatIsBehindItsOptionsAlone) {
    program_.write(
        "curvecore.toml",
        "[curve]\nrow = [\"T=1,0,0\", \"N=0,1,0\", \"kappa=0,0,0\", \"sigma=0.0025\"]\n");
    const ProgramResult result = program_.run({"curve", "check", "clothoid", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(Json::parse(result.out).contains("bound_units"));
}

TEST_F(ConfigFile, IsNotReadForHelpNorWhereNoneIsAskedFor) {
    program_.write("curvecore.toml", "unti = 1\n");
    EXPECT_EQ(program_.run({"plan", "--help"}).status, 0);
    EXPECT_EQ(program_.run({"plan", "part.ngc", "-q"}).status, 2);
    EXPECT_EQ(plan({"--config", "none"})["unit_mm"], 1e-6);
}

TEST_F(ConfigFile, SeesTheOptionsOfShortFlagsTogether) {
    program_.write("curvecore.toml", "output = \"ours\"\nquiet = true\n");
    const ProgramResult result = program_.run({"plan", "part.ngc", "-qo", "mine"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_FALSE(program_.exists("ours"));
}

TEST_F(ConfigFile, MayHoldWhatACommandMustBeGiven) {
    program_.write("curvecore.toml",
                   "[choose]\nerror = \"1um\"\nfeed = \"10m/min\"\ndevice = \"up5k\"\n");
    const ProgramResult result = program_.run({"choose", "--radius", "300mm", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out)["requirement"]["device"], "up5k");
}

}  // namespace curvecore::tb::config_file_test
