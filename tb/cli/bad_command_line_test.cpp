// SPDX-License-Identifier: Apache-2.0
// Invalid command lines: each is refused with status 2 and the reason, and leaves nothing behind.
#include <gtest/gtest.h>

#include "ref/format/parameter_text.hpp"
#include "tb/cli/device_list.hpp"
#include "tb/cli/program_run.hpp"

namespace curvecore::tb::bad_command_line_test {

struct BadCommandLine {
    const char* name;
    std::vector<std::string> arguments;
    std::string message;  // the first line of stderr
};

void PrintTo(const BadCommandLine& line, std::ostream* out) { *out << line.name; }

std::vector<std::string> with(std::vector<std::string> more,
                              std::vector<std::string> base = {"plan", "part.ngc", "-o", "out"}) {
    base.insert(base.end(), more.begin(), more.end());
    return base;
}

std::vector<std::string> run_with(std::vector<std::string> more) {
    return with(std::move(more), {"run", "part.ngc", "-o", "out"});
}

const std::vector<BadCommandLine> kBadCommandLines{
    {"UnknownCommand",
     {"draw", "part.ngc"},
     "curvecore: error: there is no command 'draw'; there are run, plan, words, "
     "vectors, cam, join, compare, choose, stream, home, board, explore, curve, "
     "completion"},
    {"NoFile", {"plan", "-o", "out"}, "curvecore: error: FILE is required"},
    {"OutputWithoutName",
     {"plan", "part.ngc", "-o"},
     "curvecore: error: --output: 1 required DIR missing"},
    {"UnknownOption", with({"--fast"}),
     "curvecore: error: plan has no option '--fast'; plan --help-all lists them"},
    {"TwoFiles", with({"other.ngc"}),
     "curvecore: error: The following argument was not expected: other.ngc"},
    {"StallWithoutRun", with({"--stall", "1"}),
     "curvecore: error: plan has no option '--stall'; plan --help-all lists them"},
    {"UnitWithoutUnit", with({"--unit", "1"}),
     "curvecore: error: --unit '1': the unit must be nm, um, mm, m or in"},
    {"UnitTooLarge", with({"--unit", "1in"}), "curvecore: error: --unit must be in [1e-07, 1] mm"},
    {"UnitOfNothing", with({"--unit", "1/0um"}), "curvecore: error: --unit '1/0um': not a number"},
    {"PeriodWithoutUnit", with({"--sample-period", "100"}),
     "curvecore: error: --sample-period '100': the unit must be ns, us, ms or s"},
    {"PeriodOfAnotherUnit", with({"--sample-period", "100kHz"}),
     "curvecore: error: --sample-period '100kHz': the unit must be ns, us, ms or s"},
    {"PeriodNotANumber", with({"--sample-period", "fast"}),
     "curvecore: error: --sample-period 'fast': not a number"},
    {"PeriodZero", with({"--sample-period", "0us"}),
     "curvecore: error: --sample-period must be in [10ns, 1s]"},
    {"PeriodNegative", with({"--sample-period=-1us"}),
     "curvecore: error: --sample-period must be in [10ns, 1s]"},
    {"PeriodInfinite", with({"--sample-period", "infs"}),
     "curvecore: error: --sample-period 'infs': not a number"},
    {"PeriodTooLong", with({"--sample-period", "2s"}),
     "curvecore: error: --sample-period must be in [10ns, 1s]"},
    {"SamplesPerTickZero", with({"--samples-per-tick", "0"}),
     "curvecore: error: --samples-per-tick must be a power of two in [1, 32768]"},
    {"SamplesPerTickThree", with({"--samples-per-tick", "3"}),
     "curvecore: error: --samples-per-tick must be a power of two in [1, 32768]"},
    {"SamplesPerTickNotWhole", with({"--samples-per-tick", "1.5"}),
     "curvecore: error: --samples-per-tick '1.5': not a whole number"},
    {"SamplesPerTickTooMany", with({"--samples-per-tick", "65536"}),
     "curvecore: error: --samples-per-tick must be a power of two in [1, 32768]"},
    {"SegmentQueueOdd", with({"--segment-queue", "1000"}),
     "curvecore: error: --segment-queue must be a power of two in [64, 65536]"},
    {"ProfileQueueTooLong", with({"--profile-queue", "8192"}),
     "curvecore: error: --profile-queue must be a power of two in [16, 4096]"},
    {"ClockZero", with({"--clock", "0MHz"}),
     "curvecore: error: --clock must be in [1000, 1e+10] Hz"},
    {"ClockWithoutUnit", with({"--clock", "100"}),
     "curvecore: error: --clock '100': the unit must be Hz, kHz, MHz or GHz"},
    {"ClockNotANumber", with({"--clock", "nanHz"}),
     "curvecore: error: --clock 'nanHz': not a number"},
    {"SystemElsewhere", run_with({"--on", "kernel", "--system", "host=1ms"}),
     "curvecore: error: --system is for --on systemc and systemc-rtl"},
    {"SystemBlockUnknown", run_with({"--on", "systemc", "--system", "steps=fast"}),
     "curvecore: error: --system steps 'fast': must be one of kernel, rtl, pins"},
    {"SystemInterpolatorHasNoPins", run_with({"--on", "systemc", "--system", "interpolator=pins"}),
     "curvecore: error: --system interpolator 'pins': must be one of kernel, rtl"},
    {"SystemTimeOfAnotherUnit", run_with({"--on", "systemc", "--system", "word=1us,host=2m"}),
     "curvecore: error: --system host '2m': the unit must be ns, us, ms or s"},
    {"SystemDampingNone", run_with({"--on", "systemc", "--system", "damping=0"}),
     "curvecore: error: --system damping must be in [0.01, 10]"},
    {"SystemStepsNotBuiltIn",
     run_with({"--on", "systemc", "--system", "steps=rtl", "--sample-period", "500us"}),
     "curvecore: error: --system steps=rtl: 3 axes at 2^15 clocks a sample are not built in; there "
     "are 3 axes at 2^8, 3 axes at 2^13, 9 axes at 2^13 (--sample-period times --clock)"},
    {"SystemPinsNotBuiltIn",
     run_with({"--on", "systemc", "--system", "steps=pins", "--sample-period", "500us"}),
     "curvecore: error: --system steps=pins: 3 axes at 2^15 clocks a sample are not built in; "
     "there "
     "are 3 axes at 2^8, 3 axes at 2^13 (--sample-period times --clock)"},
    {"SystemPulseTooLong", run_with({"--on", "systemc", "--system", "steplen=1ms"}),
     "curvecore: error: --system: a pin's time of 1000 us is beyond the 32767 clocks that the step "
     "generator counts"},
    {"ErrorBelowTheRounding", with({"--error", "0.5nm"}),
     "curvecore: error: --error 0.5nm: must be in [0.501, 1000000] units of 1nm; half a unit is "
     "lost "
     "by rounding"},
    {"ErrorWithoutUnit", with({"--error", "1"}),
     "curvecore: error: --error '1': the unit must be nm, um, mm, m or in"},
    {"DeviceUnknown", with({"--device", "ecp6"}),
     "curvecore: error: --device 'ecp6': must be one of " + device_list()},
    {"DeviceWithoutClock", with({"--device", "xc7a35t"}),
     "curvecore: error: --device xc7a35t: its cells are counted, nothing is placed for it, so that "
     "its clock is not known: say --clock"},
    {"BuildUnknown", with({"--build", "folded"}),
     "curvecore: error: --build 'folded': must be one of parallel, serial, engine"},
    {"SetUnknown", with({"--set", "Width=36"}),
     "curvecore: error: --set Width: unknown parameter; there are " + ref::parameter_names()},
    {"SetWithoutValue", with({"--set", "Order"}),
     "curvecore: error: --set Order: Name=Value is expected"},
    {"SetNotANumber", with({"--set", "Order=six"}),
     "curvecore: error: --set Order 'six': numbers like 6 or 4,6,8 or 24:36:4 are expected"},
    {"SetAList", with({"--set", "Order=4,6"}),
     "curvecore: error: --set Order=4,6: one value is expected; compare takes lists"},
    {"SetEmpty", with({"--set", "Order="}),
     "curvecore: error: --set Order '': numbers like 6 or 4,6,8 or 24:36:4 are expected"},
    {"SetOrderTooLow", with({"--set", "Order=1"}),
     "curvecore: error: --set Order must be in [2, 12]"},
    {"SetOrderTooHigh", with({"--set", "Order=13"}),
     "curvecore: error: --set Order must be in [2, 12]"},
    {"SetCoefBitsTooMany", with({"--set", "CoefBits=37"}),
     "curvecore: error: --set CoefBits must be in [18, 36]"},
    {"SetPositionBitsTooFew", with({"--set", "PositionBits=15"}),
     "curvecore: error: --set PositionBits must be in [16, 32]"},
    {"SetGuardBitsTooMany", with({"--set", "GuardBits=13"}),
     "curvecore: error: --set GuardBits must be in [2, 12]"},
    {"SetSplinesTooMany", with({"--set", "Splines=2"}),
     "curvecore: error: --set Splines must be in [0, 1]"},
    {"SetAuxAxesTooMany", with({"--set", "AuxAxes=7"}),
     "curvecore: error: --set AuxAxes must be in [0, 6]"},
    {"SetModeUnknown", with({"--set", "Mode=2"}), "curvecore: error: --set Mode must be in [0, 1]"},
    {"SetIntervalThree", with({"--set", "SampleInterval=3"}),
     "curvecore: error: --set SampleInterval must be 1, 2, 4 or 8"},
    {"SetParameterGuardTooMuch", with({"--set", "ParameterGuard=9"}),
     "curvecore: error: --set ParameterGuard must be in [0, 8]"},
    {"SetParameterGuardOfTheSerialBuild", with({"--set", "ParameterGuard=4", "--build", "serial"}),
     "curvecore: error: ParameterGuard=4 works with --build parallel and Splines=1 only"},
    {"SetParameterGuardWithoutSplines", with({"--set", "ParameterGuard=4"}),
     "part.ngc: error: no spline, and ParameterGuard=4 works with --build parallel and Splines=1 "
     "only"},
    {"SetAnchorOfTheEngine", with({"--set", "Anchor=0", "--build", "engine"}),
     "curvecore: error: Anchor=0 works with --build parallel and Splines=1 only"},
    {"DeviceOfTheEngine", with({"--device", "ecp5-25", "--build", "engine"}),
     "curvecore: error: --device ecp5-25: there are no measured runs of the engine build for it "
     "yet: say --clock"},
    {"SetAnchorOfTheSerialBuild", with({"--set", "Anchor=0", "--build", "serial"}),
     "curvecore: error: Anchor=0 works with --build parallel and Splines=1 only"},
    {"SetSecondIsBad", with({"--set", "Order=4", "--set", "GuardBits=1"}),
     "curvecore: error: --set GuardBits must be in [2, 12]"},
    {"SerialBuildOnRtl", run_with({"--build", "serial"}),
     "curvecore: error: --build serial: a curve core alone, which no motion has inside: take "
     "--build engine, or --on kernel"},
    {"SerialBuildInASystem", run_with({"--build", "serial", "--on", "systemc"}),
     "curvecore: error: --build serial: a curve core alone, which no motion has inside: take "
     "--build engine, or --on kernel"},
    {"BoardUnknown", run_with({"--on", "paper"}),
     "curvecore: error: --on 'paper': must be one of kernel, rtl, systemc, systemc-rtl"},
    {"StallOnTheKernel", run_with({"--on", "kernel", "--stall", "1"}),
     "curvecore: error: --stall is for --on rtl and systemc-rtl"},
    {"TraceOnTheKernel", run_with({"--on", "kernel", "--trace"}),
     "curvecore: error: --trace is for --on rtl, systemc and systemc-rtl"},
    {"OverrideZero", run_with({"--override", "0"}),
     "curvecore: error: --override must be in [1, 200] percent"},
    {"OverrideTooHigh", run_with({"--override", "201"}),
     "curvecore: error: --override must be in [1, 200] percent"},
    {"OverrideNotANumber", run_with({"--override", "half"}),
     "curvecore: error: --override 'half': not a number"},
    {"SeedNotWhole", run_with({"--stall", "x"}),
     "curvecore: error: --stall 'x': not a whole number"},
    {"RowsZero", run_with({"--rows", "0"}), "curvecore: error: --rows must be at least 1"},
    {"PathUnknown", with({"--path", "smooth"}),
     "curvecore: error: --path 'smooth': must be one of program, exact"},
    {"TraceClocksNotWhole", run_with({"--trace", "--trace-clocks", "many"}),
     "curvecore: error: --trace-clocks 'many': not a whole number"},
    {"MachineMissing", with({"--machine", "none.ini"}), "none.ini: error: no such file"},
    {"KindOfFileUnknown",
     {"plan", "part.step", "-o", "out"},
     "part.step: error: unknown kind of file: .ngc .nc .gcode .tap .ncf .cnc .eia .mpf .txt .gco "
     ".gc .g .iso .din are read as G-code, .csv as points; - reads standard input"},
    {"FitUnknown", with({"--fit", "cubic"}),
     "curvecore: error: --fit 'cubic': must be one of bessel, akima, natural, clamped, hermite, "
     "moments, quintic, c2, arcs"},
    {"EffortUnknown", with({"--effort", "most"}),
     "curvecore: error: --effort 'most': must be one of rules, optimum"},
    {"ToleranceWithoutArcs", with({"--tolerance", "1um"}),
     "curvecore: error: --tolerance is for --fit arcs"},
    {"ToleranceOfArcsZero", with({"--fit", "arcs", "--tolerance", "0um"}),
     "curvecore: error: --tolerance must be in [1e-06, 10] mm"},
    {"EndsUnknown", with({"--ends", "free"}),
     "curvecore: error: --ends 'free': must be one of natural, slope, second, closed"},
    {"EndsWithoutC2", with({"--ends", "closed"}), "curvecore: error: --ends is for --fit c2"},
    {"ParametrisationUnknown", with({"--parametrisation", "time"}),
     "curvecore: error: --parametrisation 'time': must be one of chord, centripetal, uniform"},
    {"FitOfAProgram", with({"--fit", "akima"}),
     "curvecore: error: --fit but for arcs, --parametrisation and --feed are for points (.csv)"},
    {"FeedOfAProgram", with({"--feed", "500"}),
     "curvecore: error: --fit but for arcs, --parametrisation and --feed are for points (.csv)"},
    {"FeedZero", with({"--feed", "0"}), "curvecore: error: --feed must be in [0.001, 1e9] mm/min"},
    {"FeedWithAnotherUnit", with({"--feed", "10mm"}),
     "curvecore: error: --feed '10mm': the unit must be mm/min, m/min, in/min, mm/s or m/s"},
    {"OutputIsAFile",
     {"plan", "part.ngc", "-o", "part.ngc"},
     "part.ngc: error: exists and is not a folder"},
    {"OutputBelowAFile",
     {"run", "part.ngc", "-o", "part.ngc/out"},
     "part.ngc/out: error: part.ngc is not a folder"},
    {"OutputNotWritable",
     {"words", "part.ngc", "-o", "/proc/out"},
     "/proc/out: error: cannot be made: No such file or directory"},
    {"VectorsThatAreStalled",
     {"vectors", "part.ngc", "--stall", "1"},
     "curvecore: error: vectors has no option '--stall'; vectors --help-all lists them"},
};

class BadCommand : public testing::TestWithParam<BadCommandLine> {};

TEST_P(BadCommand, IsRefused) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 G94 F600\nG1 X10\nM2\n");
    const ProgramResult result = program.run(GetParam().arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.substr(0, result.err.find('\n')), GetParam().message);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(program.files(), std::vector<std::string>{"part.ngc"});
}

INSTANTIATE_TEST_SUITE_P(Cli, BadCommand, testing::ValuesIn(kBadCommandLines),
                         [](const auto& test) { return test.param.name; });

}  // namespace curvecore::tb::bad_command_line_test
