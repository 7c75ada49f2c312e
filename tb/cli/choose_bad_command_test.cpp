// SPDX-License-Identifier: Apache-2.0
// Invalid command lines of `curvecore choose`: each is refused with status 2 and the reason, and
// leaves nothing behind.
#include <gtest/gtest.h>

#include <algorithm>

#include "tb/cli/device_list.hpp"
#include "tb/cli/program_run.hpp"

namespace curvecore::tb::choose_bad_command_test {

struct BadRequirement {
    const char* name;
    std::vector<std::string> options;  // replace options of the valid requirement, or are added
    std::string message;               // after "curvecore: error: "
};

void PrintTo(const BadRequirement& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadRequirement> kBadRequirementes{
    {"ErrorNegative", {"--error", "-1um"}, "--error must be in [1e-07, 10] mm"},
    {"ErrorZero", {"--error", "0um"}, "--error must be in [1e-07, 10] mm"},
    {"ErrorWithoutUnit", {"--error", "1"}, "--error '1': the unit must be nm, um, mm, m or in"},
    {"ErrorNotANumber", {"--error", "small"}, "--error 'small': not a number"},
    {"ErrorEmpty", {"--error", ""}, "--error '': not a number"},
    {"FeedZero", {"--feed", "0m/min"}, "--feed must be in [0.001, 1e9] mm/min"},
    {"FeedWithoutTime",
     {"--feed", "10mm"},
     "--feed '10mm': the unit must be mm/min, m/min, in/min, mm/s or m/s"},
    {"FeedPerHour",
     {"--feed", "10km/s"},
     "--feed '10km/s': the unit must be mm/min, m/min, in/min, mm/s or m/s"},
    {"FeedNegative", {"--feed", "-10mm/s"}, "--feed must be in [0.001, 1e9] mm/min"},
    {"DeviceUnknown",
     {"--device", "ecp5-12"},
     "--device 'ecp5-12': must be one of " + device_list()},
    {"BoardBesideDevice",
     {"--board", "colorlight_i5"},
     "--device or --board must be given, one of them"},
    {"RadiusZero", {"--radius", "0mm"}, "--radius must be in [0.001, 100000] mm"},
    {"RadiusTooLarge", {"--radius", "1000m"}, "--radius must be in [0.001, 100000] mm"},
    {"LeastRadiusZero", {"--least-radius", "0um"}, "--least-radius must be in [0.0001, 300] mm"},
    {"RadiiEmpty", {"--least-radius", "1m"}, "--least-radius must be in [0.0001, 300] mm"},
    {"LengthNegative", {"--length=-1mm"}, "--length must be in [0.001, 100000] mm"},
    {"TravelEmpty", {"--travel", "mm"}, "--travel 'mm': not a number"},
    {"UnitTooLarge", {"--unit", "1in"}, "--unit must be in [1e-07, 1] mm"},
    {"SampleRateZero", {"--sample-rate", "0Hz"}, "--sample-rate must be in [1, 1e+09] Hz"},
    {"SampleRateAsTime",
     {"--sample-rate", "100us"},
     "--sample-rate '100us': the unit must be Hz, kHz, MHz or GHz"},
    {"ClockTooSlow", {"--clock", "10Hz"}, "--clock must be in [1000, 1e+10] Hz"},
    {"HostZero", {"--host-words", "0"}, "--host-words must be in [1, 1e12] a second"},
    {"HostNotANumber", {"--host-words", "many"}, "--host-words 'many': not a number"},
    {"BuildUnknown",
     {"--build", "folded"},
     "--build 'folded': must be one of parallel, serial, engine"},
    {"BuildOfTheEngine",
     {"--device", "ecp5-25", "--build", "engine"},
     "--device ecp5-25: there are no measured runs of the engine build for it yet"},
    {"BuildNotMeasured",
     {"--build", "parallel"},
     "--device up5k: there are no measured runs of the parallel build for it yet"},
    {"BuildNotMeasuredThere",
     {"--device", "gw2a-18", "--build", "parallel"},
     "--device gw2a-18: there are no measured runs of the parallel build for it yet"},
    {"OptionOfCompare",
     {"--set", "Order=6"},
     "choose has no option '--set'; choose --help-all lists them"},
};

class BadChoose : public testing::TestWithParam<BadRequirement> {};

TEST_P(BadChoose, IsRefused) {
    const ProgramRun program;
    std::vector<std::string> arguments{"choose", "-o", "out"};
    const std::vector<std::string>& options = GetParam().options;
    const std::vector<std::string> good{"--error", "1um",     "--radius", "300mm",
                                        "--feed",  "10m/min", "--device", "up5k"};
    for (std::size_t i = 0; i < good.size(); i += 2) {
        if (good[i] == options[0]) continue;
        arguments.insert(arguments.end(), {good[i], good[i + 1]});
    }
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramResult result = program.run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.substr(0, result.err.find('\n')),
              "curvecore: error: " + GetParam().message);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(program.files(), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Cli, BadChoose, testing::ValuesIn(kBadRequirementes),
                         [](const auto& test) { return test.param.name; });

TEST(BadChooseOther, NoCurves) {
    const ProgramRun program;
    const ProgramResult result = program.run(
        {"choose", "--error", "1um", "--feed", "10m/min", "--device", "up5k", "-o", "out"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(
        result.err,
        "curvecore: error: --radius of arcs or --length of splines, or both, must be given\n");
    EXPECT_EQ(program.files(), std::vector<std::string>{});
}

TEST(BadChooseOther, WithoutAnError) {
    const ProgramResult result =
        ProgramRun().run({"choose", "--feed", "10m/min", "--device", "up5k", "--radius", "1mm"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "curvecore: error: --error is required\n");
}

TEST(BadChooseOther, MachineMissing) {
    const ProgramResult result =
        ProgramRun().run({"choose", "--error", "1um", "--feed", "10m/min", "--device", "up5k",
                          "--radius", "1mm", "--machine", "none.ini"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "none.ini: error: no such file\n");
}

}  // namespace curvecore::tb::choose_bad_command_test
