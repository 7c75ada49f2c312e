// SPDX-License-Identifier: Apache-2.0
// Command lines of `curvecore compare` that are refused: status 2, the reason in its words, nothing
// left behind.
#include <gtest/gtest.h>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {
namespace {

struct BadComparison {
    const char* name;
    std::vector<std::string> options;
    std::string message;  // the first line of stderr
};

void PrintTo(const BadComparison& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadComparison> kBadComparisons{
    {"ListEmpty",
     {"--order", ""},
     "curvecore: error: --order '': numbers like 6 or 4,6,8 or "
     "24:36:4 are expected"},
    {"ListWithAGap",
     {"--order", "4,,6"},
     "curvecore: error: --order '4,,6': numbers like 6 or "
     "4,6,8 or 24:36:4 are expected"},
    {"ListEndsWithAComma",
     {"--mode", "0,"},
     "curvecore: error: --mode '0,': numbers like 6 or "
     "4,6,8 or 24:36:4 are expected"},
    {"RangeWithoutEnd",
     {"--coef-bits", "24:"},
     "curvecore: error: --coef-bits '24:': numbers like "
     "6 or 4,6,8 or 24:36:4 are expected"},
    {"NotANumber",
     {"--guard-bits", "ten"},
     "curvecore: error: --guard-bits 'ten': numbers like 6 "
     "or 4,6,8 or 24:36:4 are expected"},
    {"NotWhole",
     {"--coef-bits", "24.5"},
     "curvecore: error: --coef-bits '24.5': numbers like 6 or "
     "4,6,8 or 24:36:4 are expected"},
    {"TooLargeForANumber",
     {"--order", "99999999999"},
     "curvecore: error: --order '99999999999': "
     "numbers like 6 or 4,6,8 or 24:36:4 are "
     "expected"},
    {"RangeBackwards",
     {"--order", "8:4"},
     "curvecore: error: --order '8:4': the range runs backwards"},
    {"RangeBackwardsBySteps",
     {"--coef-bits", "36:24:4"},
     "curvecore: error: --coef-bits '36:24:4': the range runs backwards"},
    {"StepZero",
     {"--order", "4:8:0"},
     "curvecore: error: --order '4:8:0': a step of 1 or more is expected"},
    {"StepNegative",
     {"--order=8:4:-1"},
     "curvecore: error: --order '8:4:-1': a step of 1 or more is expected"},
    {"RangeOfFour",
     {"--order", "4:8:1:1"},
     "curvecore: error: --order '4:8:1:1': a range is first:last or first:last:step"},
    {"OrderTooHigh", {"--order", "4:13"}, "curvecore: error: --order must be in [2, 12]"},
    {"OrderTooLow", {"--order", "1,4"}, "curvecore: error: --order must be in [2, 12]"},
    {"WidthTooNarrow",
     {"--coef-bits", "16:36:4"},
     "curvecore: error: --coef-bits must be in [18, 36]"},
    {"WidthTooWide",
     {"--coef-bits", "24:40:4"},
     "curvecore: error: --coef-bits must be in [18, 36]"},
    {"GuardTooWide", {"--guard-bits", "13"}, "curvecore: error: --guard-bits must be in [2, 12]"},
    {"ModeUnknown", {"--mode", "2"}, "curvecore: error: --mode must be in [0, 1]"},
    {"SchemeUnknown", {"--anchor", "0:2"}, "curvecore: error: --anchor must be in [0, 1]"},
    {"TurnBitsTooMany", {"--turn-bits", "15"}, "curvecore: error: --turn-bits must be in [0, 14]"},
    {"TurnBitsOfPolynomials",
     {"--turn-bits", "0,8"},
     "curvecore: error: --turn-bits above 0 works with --mode 0 only"},
    {"TurnBitsOfSplines",
     {"--turn-bits", "8", "--mode", "0"},
     "curvecore: error: --turn-bits above 0 is for lines and arcs: there are splines"},
    {"ParameterGuardTooMuch",
     {"--parameter-guard", "0:9"},
     "curvecore: error: --parameter-guard must be in [0, 8]"},
    {"ParameterGuardOfArcs",
     {"--parameter-guard", "0,4", "--curves", "arcs"},
     "curvecore: error: --parameter-guard above 0 is for splines: there are none"},
    {"CurvesUnknown",
     {"--curves", "circles"},
     "curvecore: error: --curves 'circles': must be one of all, arcs, splines"},
    {"CurvesWithAFile",
     {"part.ngc", "--curves", "arcs"},
     "curvecore: error: --curves is for a comparison without FILE"},
    {"MachineWithoutAFile",
     {"--machine", "machine.ini"},
     "curvecore: error: --machine is for a comparison with FILE"},
    {"FitWithoutAFile",
     {"--fit", "akima"},
     "curvecore: error: --fit, --parameter and --feed are for points (.csv)"},
    {"LimitZero", {"--limit", "0"}, "curvecore: error: --limit must be in [0.001, 1e6] units"},
    {"LimitNotANumber",
     {"--limit", "1um"},
     "curvecore: error: --limit '1um': not a number of units"},
    {"LimitInfinite", {"--limit", "inf"}, "curvecore: error: --limit 'inf': not a number of units"},
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
     {"--order", "2:12", "--coef-bits", "18:36", "--guard-bits", "2:12", "--mode", "0,1",
      "--anchor", "0,1", "part.ngc", "--samples", "100", "--limit", "1"},
     "curvecore: error: 9196 configurations are asked for, 5000 are the most"},
    {"UnitUnknown",
     {"--unit", "1mm"},
     "curvecore: error: --unit '1mm': must be 1nm, 10nm, 0.1um or 1um"},
    {"OptionOfRun",
     {"--set", "Order=6"},
     "curvecore: error: The following argument was not expected: --set"},
    {"FileMissing", {"none.ngc"}, "none.ngc: error: no such file"},
    {"KindOfFileUnknown",
     {"part.step"},
     "part.step: error: unknown kind of file: .ngc .nc .gcode .tap .csv are read"},
    {"UnknownDevice",
     {"--device", "ecp5-26"},
     "curvecore: error: --device 'ecp5-26': must be one of up5k, hx8k, ecp5-25, ecp5-45, ecp5-85, "
     "gw2a-18, lifcl-40"},
    {"UnknownBuild",
     {"--build", "folded"},
     "curvecore: error: --build 'folded': must be parallel or serial"},
    {"IntervalThree", {"--interval", "3"}, "curvecore: error: --interval must be 1, 2, 4 or 8"},
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

}  // namespace
}  // namespace curvecore::tb
