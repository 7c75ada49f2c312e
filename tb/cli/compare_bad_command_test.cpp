// SPDX-License-Identifier: Apache-2.0
// Invalid command lines of `curvecore compare`: each is refused with status 2 and the reason, and
// leaves nothing behind.
#include <gtest/gtest.h>

#include "ref/format/parameter_text.hpp"
#include "tb/cli/device_list.hpp"
#include "tb/cli/program_run.hpp"

namespace curvecore::tb::compare_bad_command_test {

struct BadComparison {
    const char* name;
    std::vector<std::string> options;
    std::string message;  // the first line of stderr
};

void PrintTo(const BadComparison& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadComparison> kBadComparisons{
    {"ListEmpty",
     {"--set", "Order="},
     "curvecore: error: --set Order '': numbers like 6 or 4,6,8 or "
     "24:36:4 are expected"},
    {"ListWithAGap",
     {"--set", "Order=4,,6"},
     "curvecore: error: --set Order '4,,6': numbers like 6 or "
     "4,6,8 or 24:36:4 are expected"},
    {"ListEndsWithAComma",
     {"--set", "Mode=0,"},
     "curvecore: error: --set Mode '0,': numbers like 6 or "
     "4,6,8 or 24:36:4 are expected"},
    {"RangeWithoutEnd",
     {"--set", "CoefBits=24:"},
     "curvecore: error: --set CoefBits '24:': numbers like "
     "6 or 4,6,8 or 24:36:4 are expected"},
    {"NotANumber",
     {"--set", "GuardBits=ten"},
     "curvecore: error: --set GuardBits 'ten': numbers like 6 "
     "or 4,6,8 or 24:36:4 are expected"},
    {"NotWhole",
     {"--set", "CoefBits=24.5"},
     "curvecore: error: --set CoefBits '24.5': numbers like 6 or "
     "4,6,8 or 24:36:4 are expected"},
    {"TooLargeForANumber",
     {"--set", "Order=99999999999"},
     "curvecore: error: --set Order '99999999999': "
     "numbers like 6 or 4,6,8 or 24:36:4 are "
     "expected"},
    {"RangeBackwards",
     {"--set", "Order=8:4"},
     "curvecore: error: --set Order '8:4': the range runs backwards"},
    {"RangeBackwardsBySteps",
     {"--set", "CoefBits=36:24:4"},
     "curvecore: error: --set CoefBits '36:24:4': the range runs backwards"},
    {"StepZero",
     {"--set", "Order=4:8:0"},
     "curvecore: error: --set Order '4:8:0': a step of 1 or more is expected"},
    {"StepNegative",
     {"--set", "Order=8:4:-1"},
     "curvecore: error: --set Order '8:4:-1': a step of 1 or more is expected"},
    {"RangeOfFour",
     {"--set", "Order=4:8:1:1"},
     "curvecore: error: --set Order '4:8:1:1': a range is first:last or first:last:step"},
    {"OrderTooHigh", {"--set", "Order=4:13"}, "curvecore: error: --set Order must be in [2, 12]"},
    {"OrderTooLow", {"--set", "Order=1,4"}, "curvecore: error: --set Order must be in [2, 12]"},
    {"WidthTooNarrow",
     {"--set", "CoefBits=16:36:4"},
     "curvecore: error: --set CoefBits must be in [18, 36]"},
    {"WidthTooWide",
     {"--set", "CoefBits=24:40:4"},
     "curvecore: error: --set CoefBits must be in [18, 36]"},
    {"GuardTooWide",
     {"--set", "GuardBits=13"},
     "curvecore: error: --set GuardBits must be in [2, 12]"},
    {"ModeUnknown", {"--set", "Mode=2"}, "curvecore: error: --set Mode must be in [0, 1]"},
    {"SchemeUnknown", {"--set", "Anchor=0:2"}, "curvecore: error: --set Anchor must be in [0, 1]"},
    {"ParameterGuardTooMuch",
     {"--set", "ParameterGuard=0:9"},
     "curvecore: error: --set ParameterGuard must be in [0, 8]"},
    {"ParameterGuardOfArcs",
     {"--set", "ParameterGuard=0,4", "--curves", "arcs"},
     "curvecore: error: there are no splines, and ParameterGuard=4 works with --build parallel and "
     "Splines=1 only"},
    {"AnchorOfTheSerialBuild",
     {"--set", "Anchor=0", "--build", "serial"},
     "curvecore: error: there are splines, and Anchor=0 works with --build parallel and Splines=1 "
     "only"},
    {"SplinesOfTheCurves",
     {"--set", "Splines=0"},
     "curvecore: error: --set Splines: follows the curves"},
    {"CurvesUnknown",
     {"--curves", "circles"},
     "curvecore: error: --curves 'circles': must be one of all, arcs, splines, papers"},
    {"CurvesWithAFile",
     {"part.ngc", "--curves", "arcs"},
     "curvecore: error: --curves is for a comparison without FILE"},
    {"SchemeOfNoName",
     {"--scheme", "anchored,euler"},
     "curvecore: error: --scheme 'euler': must be of anchored, propagated, paper, rk4, scalar"},
    {"SchemeTwice",
     {"--scheme", "rk4,rk4"},
     "curvecore: error: --scheme 'rk4,rk4': rk4 is there twice"},
    {"SchemeEmpty",
     {"--scheme", "rk4,,paper"},
     "curvecore: error: --scheme '': must be of anchored, propagated, paper, rk4, scalar"},
    {"SchemeOfArcs",
     {"--scheme", "rk4"},
     "curvecore: error: --scheme rk4 draws splines only: --curves splines or papers"},
    {"SchemeAndAnchor",
     {"--curves", "papers", "--scheme", "rk4", "--set", "Anchor=0"},
     "curvecore: error: --set Anchor: follows --scheme"},
    {"TickOfNone",
     {"--tick", "10ms"},
     "curvecore: error: --tick is for --scheme paper, rk4 and scalar"},
    {"TickOfOurSteps",
     {"--scheme", "anchored", "--tick", "10ms"},
     "curvecore: error: --tick and --feed are for --scheme paper, rk4 and scalar"},
    {"TickZero",
     {"--curves", "papers", "--scheme", "rk4", "--tick", "0ms"},
     "curvecore: error: --tick must be in [1us, 10s]"},
    {"TickNegative",
     {"--curves", "papers", "--scheme", "rk4", "--tick", "-1ms"},
     "curvecore: error: --tick must be in [1us, 10s]"},
    {"TickWithoutUnit",
     {"--curves", "papers", "--scheme", "rk4", "--tick", "10"},
     "curvecore: error: --tick '10': the unit must be us, ms or s"},
    {"FeedZero",
     {"--curves", "papers", "--scheme", "rk4", "--feed", "1.5m/min,0m/min"},
     "curvecore: error: --feed must be in [0.001, 1e9] mm/min"},
    {"TicksTooMany",
     {"--curves", "papers", "--scheme", "rk4", "--tick", "1us", "--feed", "1.5m/min"},
     "curvecore: error: --tick 0.001ms at --feed 1.5m/min: 5.7e+07 ticks, 1e+07 are the most"},
    {"MachineWithoutAFile",
     {"--machine", "machine.ini"},
     "curvecore: error: --machine is for a comparison with FILE"},
    {"FitWithoutAFile",
     {"--fit", "akima"},
     "curvecore: error: --fit but for arcs, --parametrisation and --feed are for points (.csv)"},
    {"ErrorBelowTheRounding",
     {"--error", "0nm"},
     "curvecore: error: --error must be in [1e-07, 1000] mm"},
    {"ErrorInfinite", {"--error", "infnm"}, "curvecore: error: --error 'infnm': not a number"},
    {"SegmentsZero", {"--segments", "0"}, "curvecore: error: --segments must be in [1, 1000]"},
    {"SegmentsList",
     {"--segments", "2,4"},
     "curvecore: error: --segments '2,4': one number is expected"},
    {"SamplesTooFew",
     {"--samples", "99"},
     "curvecore: error: --samples must be in [100, 10000000]"},
    {"SamplesNotANumber",
     {"--samples", "1e6"},
     "curvecore: error: --samples '1e6': numbers like 6 "
     "or 4,6,8 or 24:36:4 are expected"},
    {"TooMany",
     {"--set", "Order=2:12", "--set", "CoefBits=18:36", "--set", "GuardBits=2:12", "--set",
      "Mode=0,1", "--set", "Anchor=0,1", "part.ngc", "--samples", "100"},
     "curvecore: error: 9196 configurations are asked for, 5000 are the most"},
    {"UnitTooLarge", {"--unit", "1in"}, "curvecore: error: --unit must be in [1e-07, 1] mm"},
    {"OptionOfRun",
     {"--stall", "1"},
     "curvecore: error: compare has no option '--stall'; compare --help-all lists them"},
    {"SetUnknown",
     {"--set", "Width=36"},
     "curvecore: error: --set Width: unknown parameter; there are " + ref::parameter_names()},
    {"FileMissing", {"none.ngc"}, "none.ngc: error: no such file"},
    {"KindOfFileUnknown",
     {"part.step"},
     "part.step: error: unknown kind of file: .ngc .nc .gcode .tap .ncf .cnc .eia .mpf .txt .gco "
     ".gc .g .iso .din are read as G-code, .csv as points; - reads standard input"},
    {"UnknownDevice",
     {"--device", "ecp5-26"},
     "curvecore: error: --device 'ecp5-26': must be one of " + device_list()},
    {"DeviceTwice",
     {"--device", "up5k,ecp5-25,up5k"},
     "curvecore: error: --device 'up5k,ecp5-25,up5k': up5k is there twice"},
    {"DeviceEmpty", {"--device", ""}, "curvecore: error: --device '': a name is expected"},
    {"UnknownBuild",
     {"--build", "folded"},
     "curvecore: error: --build 'folded': must be one of parallel, serial, engine"},
    {"IntervalThree",
     {"--set", "SampleInterval=3"},
     "curvecore: error: --set SampleInterval must be 1, 2, 4 or 8"},
    {"NothingMoves", {"still.ngc"}, "still.ngc: error: the program has no moves"},
    {"BeyondTheTravel",
     {"far.ngc"},
     "far.ngc:2: error: X = 3000 mm is beyond the machine's travel -1000 .. 1000 mm"},
};

class BadCompare : public testing::TestWithParam<BadComparison> {};

TEST_P(BadCompare, IsRefused) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 G94 F600\nG1 X10\nM2\n");
    program.write("still.ngc", "G21 G90 G94 F600\nM2\n");
    program.write("far.ngc", "G21 G90 G94 F600\nG1 X3000\nM2\n");
    const std::vector<std::string> before = program.files();
    std::vector<std::string> arguments{"compare", "-o", "out"};
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    const ProgramResult result = program.run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.substr(0, result.err.find('\n')), GetParam().message);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(program.files(), before);
}

INSTANTIATE_TEST_SUITE_P(Cli, BadCompare, testing::ValuesIn(kBadComparisons),
                         [](const auto& test) { return test.param.name; });

}  // namespace curvecore::tb::compare_bad_command_test
