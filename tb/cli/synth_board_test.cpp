// SPDX-License-Identifier: Apache-2.0
// scripts/synth.sh --board with stand-in tools: every table, the result of one, and refusals. The
// test system.Board checks with the real tools that the pins are in the package.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hls/registers/board_facts.h"
#include "ref/curves/table_reader.hpp"
#include "tb/cli/synth_run.hpp"

namespace curvecore::tb::synth_board_test {

using testing::IsNotSubstring;
using testing::IsSubstring;
using Json = nlohmann::json;

const std::vector<std::string> kTools{
    "yosys",   "nextpnr-ecp5", "nextpnr-ice40", "nextpnr-himbaechel-gowin",
    "ecppack", "icepack",      "gowin_pack",    "ecppll",
    "icepll",  "gowin_pll"};

Json table_of(const std::string& board) {
    std::ifstream file(SYNTH_FOLDER "/boards/" + board + ".json");
    return Json::parse(file);
}

TEST(SynthBoard, EveryTableBecomesABitstream) {
    int boards = 0;
    for (const auto& file : std::filesystem::directory_iterator(SYNTH_FOLDER "/boards")) {
        const SynthRun synth(kTools);
        const std::string board = file.path().stem();
        const ProgramResult result = synth.synth({"--board", board});
        EXPECT_EQ(result.status, 0) << board << ": " << result.err;
        const std::string folder = "out/boards/" + board + "/";
        const Json facts = Json::parse(synth.read(folder + "board.json"));
        EXPECT_EQ(synth.read(folder + facts["bitstream"].get<std::string>()), "bits");
        EXPECT_PRED_FORMAT2(
            IsSubstring,
            "to load it: openFPGALoader -b " + table_of(board)["loader"].get<std::string>() + " ",
            result.out);
        EXPECT_EQ(facts["samples_s"].get<double>(),
                  std::round(table_of(board)["clock_hz"].get<double>() /
                             (1 << table_of(board)["parameters"]["PeriodLog2"].get<int>())));
        ++boards;
    }
    EXPECT_GE(boards, 5);
}

TEST(SynthBoard, ConstraintsAndTopFollowFromTheTable) {
    const SynthRun synth(kTools);
    EXPECT_EQ(synth.synth({"--board", "icebreaker"}).status, 0);
    EXPECT_EQ(synth.read("out/boards/icebreaker/board.pcf"),
              "set_frequency clk 12\n"
              "set_io clk 35\nset_io -pullup yes uart_rx 6\nset_io uart_tx 9\n"
              "set_io step[0] 4\nset_io step[1] 2\nset_io step[2] 47\n"
              "set_io direction[0] 3\nset_io direction[1] 48\nset_io direction[2] 46\n"
              "set_io enable 45\nset_io -pullup yes estop 43\n"
              "set_io -pullup yes limit[0] 38\nset_io -pullup yes limit[1] 34\n"
              "set_io -pullup yes limit[2] 31\n");
    const std::string top = synth.read("out/boards/icebreaker/top.v");
    EXPECT_PRED_FORMAT2(IsSubstring, "pll u_pll (.clock_in(clk)", top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".BitClocks(30)", top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".PeriodLog2(12)", top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".ClockHertz(30000000)", top);

    EXPECT_EQ(synth.synth({"--board", "ulx3s_85"}).status, 0);
    const std::string lpf = synth.read("out/boards/ulx3s_85/board.lpf");
    EXPECT_PRED_FORMAT2(IsSubstring, "FREQUENCY PORT \"clk\" 25 MHZ;\n", lpf);
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "LOCATE COMP \"step[1]\" SITE \"A10\";\n"
                        "IOBUF PORT \"step[1]\" IO_TYPE=LVCMOS33 PULLMODE=NONE;\n",
                        lpf);
    EXPECT_PRED_FORMAT2(IsSubstring, "IOBUF PORT \"estop\" IO_TYPE=LVCMOS33 PULLMODE=UP;", lpf);
    EXPECT_PRED_FORMAT2(IsSubstring, "pll u_pll", synth.read("out/boards/ulx3s_85/top.v"));
    EXPECT_EQ(synth.runs("ecppll"), 1);

    EXPECT_EQ(synth.synth({"--board", "tang_nano_9k"}).status, 0);
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "IO_LOC \"limit[2]\" 41;\n"
                        "IO_PORT \"limit[2]\" IO_TYPE=LVCMOS33 PULL_MODE=UP;\n",
                        synth.read("out/boards/tang_nano_9k/board.cst"));
}

constexpr const char* kMoreInputs =
    R"({"pins": {"probe": "P1", "home": ["P2", "P4", "P5"], "encoder_a": ["Q1", "Q2", "Q3"],
                 "encoder_b": ["R1", "R2", "R3"]}, "parameters": {"Encoders": 3}})";

TEST(SynthBoard, InputsThatABoardMayHaveAreThereOrTied) {
    const SynthRun synth(kTools);
    EXPECT_EQ(synth.synth({"--board", "colorlight_i5"}).status, 0);
    const std::string without = synth.read("out/boards/colorlight_i5/top.v");
    EXPECT_PRED_FORMAT2(IsSubstring, ".probe_i(1'b0), .home_i(limit),", without);
    EXPECT_PRED_FORMAT2(IsSubstring, ".encoder_a_i(3'd0), .encoder_b_i(3'd0),", without);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "input probe", without);

    Json table = table_of("colorlight_i5");
    table.merge_patch(Json::parse(kMoreInputs));
    synth.write("mine.json", table.dump());
    EXPECT_EQ(synth.synth({"--board", "mine.json"}).status, 0);
    const std::string top = synth.read("out/boards/mine/top.v");
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "input [2:0] limit, input probe, input [2:0] home, input [2:0] encoder_a, "
                        "input [2:0] encoder_b,",
                        top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".probe_i(probe), .home_i(home),", top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".encoder_a_i(encoder_a), .encoder_b_i(encoder_b),", top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".Encoders(3)", top);
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "LOCATE COMP \"encoder_b[2]\" SITE \"R3\";\n"
                        "IOBUF PORT \"encoder_b[2]\" IO_TYPE=LVCMOS33 PULLMODE=UP;\n",
                        synth.read("out/boards/mine/board.lpf"));
}

TEST(SynthBoard, OutputsOfABoardAreUsedWithTheirParameterAlone) {
    const SynthRun synth(kTools);
    EXPECT_EQ(synth.synth({"--board", "ulx3s_85"}).status, 0);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "pwm", synth.read("out/boards/ulx3s_85/board.lpf"));
    EXPECT_PRED_FORMAT2(IsNotSubstring, "output pwm", synth.read("out/boards/ulx3s_85/top.v"));
    EXPECT_EQ(synth.synth({"--board", "ulx3s_85", "--set", "Outputs=1024"}).status, 0);
    EXPECT_PRED_FORMAT2(IsSubstring, "LOCATE COMP \"pwm\" SITE \"B1\";\n",
                        synth.read("out/boards/ulx3s_85/board.lpf"));
    EXPECT_PRED_FORMAT2(IsSubstring, "output [7:0] outputs, output pwm",
                        synth.read("out/boards/ulx3s_85/top.v"));
}

TEST(SynthBoard, OutputsThatABoardMayHaveAreThereOrOpen) {
    const SynthRun synth(kTools);
    EXPECT_EQ(synth.synth({"--board", "colorlight_i5"}).status, 0);
    EXPECT_PRED_FORMAT2(IsSubstring, ".output_o(), .pwm_o()",
                        synth.read("out/boards/colorlight_i5/top.v"));
    Json table = table_of("colorlight_i5");
    table.merge_patch(Json::parse(
        R"({"pins": {"outputs": ["P1", "P2"], "pwm": "P4"}, "parameters": {"Outputs": 1024}})"));
    synth.write("mine.json", table.dump());
    EXPECT_EQ(synth.synth({"--board", "mine.json"}).status, 0);
    const std::string top = synth.read("out/boards/mine/top.v");
    EXPECT_PRED_FORMAT2(IsSubstring, "output enable, output [1:0] outputs, output pwm", top);
    EXPECT_PRED_FORMAT2(IsSubstring, "assign outputs = switched[1:0];", top);
    EXPECT_PRED_FORMAT2(IsSubstring, ".output_o(switched), .pwm_o(pwm)", top);
    EXPECT_PRED_FORMAT2(IsSubstring,
                        "LOCATE COMP \"outputs[1]\" SITE \"P2\";\n"
                        "IOBUF PORT \"outputs[1]\" IO_TYPE=LVCMOS33 PULLMODE=NONE;\n",
                        synth.read("out/boards/mine/board.lpf"));
}

TEST(SynthBoard, AParameterGivenIsInTheTop) {
    const SynthRun synth(kTools);
    EXPECT_EQ(synth.synth({"--board", "icebreaker", "--set", "Order=4"}).status, 0);
    EXPECT_PRED_FORMAT2(IsSubstring, ".Order(4)", synth.read("out/boards/icebreaker/top.v"));
}

/// A board of the engine beside others' tools, which what makes its programs may use.
ProgramResult engine_board(const SynthRun& synth, int period_log2, unsigned curve = 0) {
    Json table = table_of("colorlight_i5");
    table["parameters"]["PeriodLog2"] = period_log2;
    if (curve != 0) table["parameters"]["Table"] = curve;
    synth.write("engine.json", table.dump());
    return synth.shell("PATH=$PATH:/usr/bin:/bin $SYNTH --board engine.json");
}

TEST(SynthBoard, OfTheEngineComesWithItsPrograms) {
    const SynthRun synth(kTools);
    const ProgramResult result = engine_board(synth, 14);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_PRED_FORMAT2(IsSubstring,
                        ".Build(2), .MultiplierForm(1), .PeriodLog2(14), .ProfileQueueWords(2048), "
                        ".SegmentQueueWords(2048), .ClockHertz(87500000), "
                        ".Program(\"program.hex\"), .Data(\"data.hex\")",
                        synth.read("out/boards/engine/top.v"));
    const std::string program = synth.read("out/boards/engine/program.hex");
    EXPECT_EQ(program.size() % 9, 0U);
    EXPECT_GT(program.size(), 9U * 1024);
    EXPECT_FALSE(synth.read("out/boards/engine/data.hex").empty());
    const Json facts = Json::parse(synth.read("out/boards/engine/board.json"));
    EXPECT_FALSE(facts["parameters"].contains("Program")) << "names of files are no figures";
}

/// Number of instructions of the board's programs: the rest of the store is zero.
std::size_t instructions(const SynthRun& synth) {
    std::istringstream words(synth.read("out/boards/engine/program.hex"));
    return static_cast<std::size_t>(
        std::count_if(std::istream_iterator<std::string>(words), {},
                      [](const std::string& word) { return word != "00000000"; }));
}

TEST(SynthBoard, OfTheEngineDrawsTheTableOfItsNumber) {
    const SynthRun synth(kTools);
    ASSERT_EQ(engine_board(synth, 14).status, 0);
    const std::size_t without = instructions(synth);
    const std::string text = ref::read_curve_table(CURVES_DIR "/series.net").text;
    const std::uint32_t number = curvecore_table_number(text.c_str());
    const ProgramResult with = engine_board(synth, 14, number);
    EXPECT_EQ(with.status, 0) << with.err;
    EXPECT_GT(instructions(synth), without + 40) << "the table's own";
    EXPECT_PRED_FORMAT2(IsSubstring, ".Table(" + std::to_string(number) + ")",
                        synth.read("out/boards/engine/top.v"));
    const ProgramResult unknown = engine_board(synth, 14, 1);
    EXPECT_EQ(unknown.status, 1);
    EXPECT_PRED_FORMAT2(IsSubstring, "Table=1: no table of ref/curves has that number",
                        unknown.err);
}

TEST(SynthBoard, OfTheEngineWithTooFewClocksIsRefused) {
    const SynthRun synth(kTools);
    const ProgramResult result = engine_board(synth, 10);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.rfind("synth: engine: microcode_generator: a sample period has 1024 "
                               "clocks, and the engine needs ",
                               0),
              0U)
        << result.err;
    EXPECT_EQ(synth.exists("log"), false) << "nothing was synthesised";
}

TEST(SynthBoard, WhatItTookIsRecordedAndReplacesWhatStoodThere) {
    const SynthRun synth(kTools);
    for (const char* board : {"icebreaker", "colorlight_i5", "icebreaker"}) {
        EXPECT_EQ(synth.synth({"--board", board, "--record", "placed.json"}).status, 0);
    }
    const Json rows = Json::parse(synth.read("placed.json"));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["board"], "colorlight_i5");
    const Json facts = Json::parse(synth.read("out/boards/colorlight_i5/board.json"));
    for (const char* figure : {"lut4", "ff", "dsp", "bram", "fmax_mhz", "part"}) {
        EXPECT_EQ(rows[0][figure], facts[figure]) << figure;
    }
    EXPECT_EQ(rows[0]["parameters"]["Order"], 6) << "a default is told too";
    const ProgramResult other =
        synth.synth({"--board", "icebreaker", "--set", "Order=4", "--record", "placed.json"});
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(other.err.rfind("synth: --record is of a board of scripts/boards as it is", 0), 0U)
        << other.err;
}

struct BadBoard {
    const char* name;
    const char* change;  // RFC 7396
    const char* message;
};

void PrintTo(const BadBoard& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadBoard> kBadBoards{
    {"PinTwice", R"({"pins": {"estop": "C17"}})", "pin C17 is step[0] and estop"},
    {"PinMissing", R"({"pins": {"estop": null}})", "pins must be clk, uart_rx, uart_tx, "},
    {"AxesWithoutPins", R"({"parameters": {"AuxAxes": 1}})", "step has 3 pins for 4 axes"},
    {"PinUnknown", R"({"pins": {"coolant": "P1"}})", "and may be probe, home, encoder_a, encod"},
    {"HalfAnEncoder", R"({"pins": {"encoder_a": ["P1", "P2", "P4"]}})",
     "encoders have pins encoder_a and encoder_b, and the parameter Encoders"},
    {"EncodersWithoutPins", R"({"parameters": {"Encoders": 3}})", "encoders have pins encoder_a"},
    {"OutputsWithoutPins",
     R"({"pins": {"outputs": null, "pwm": null}, "parameters": {"Outputs": 64}})",
     "outputs have pins outputs, eight"},
    {"NineOutputs", R"({"pins": {"outputs": ["A1", "A2", "A3", "A4", "A5", "A6", "A7", "A8", "A9"]},
                        "parameters": {"Outputs": 64}})",
     "outputs, eight at most"},
    {"HomeOfOneAxis", R"({"pins": {"home": ["P1"]}})", "home has 1 pins for 3 axes"},
    {"UnknownParameter", R"({"parameters": {"Degree": 3}})", "motion_board has no parameter Deg"},
    {"PeriodTooShort", R"({"parameters": {"PeriodLog2": 7}})",
     "Axes (FineBits + 7) + 4 clocks must fit"},
    {"BaudTooFast", R"({"baud": 15000000})", "15000000 baud: a bit has 6 clocks, and not 8"},
    {"BaudOff", R"({"baud": 8300000})", "8300000 baud: 11 clocks a bit are -4.2% off"},
    {"UnknownFamily", R"({"family": "max10"})", "unknown family 'max10': one of ecp5, ice40"},
    {"NoSuchDevice", R"({"family": "gowin"})", "device: there is no 'yosys'"},
    {"UnknownEntry", R"({"colour": "green"})", "'colour': a board has board, part, "},
    {"EntryMissing", R"({"baud": null})", "'baud' is missing"},
};

class SynthBadBoard : public testing::TestWithParam<BadBoard> {};

TEST_P(SynthBadBoard, IsRefusedBeforeAnythingRuns) {
    const SynthRun synth(kTools);
    Json table = table_of("colorlight_i5");
    table.merge_patch(Json::parse(GetParam().change));
    synth.write("mine.json", table.dump());
    const std::string file = (synth.folder() / "mine.json").string();
    const ProgramResult result = synth.synth({"--board", file});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.rfind("synth: " + file + ": ", 0), 0U) << result.err;
    EXPECT_PRED_FORMAT2(IsSubstring, GetParam().message, result.err);
    EXPECT_FALSE(synth.exists("log"));
}

INSTANTIATE_TEST_SUITE_P(All, SynthBadBoard, testing::ValuesIn(kBadBoards),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SynthBoard, PinsAloneLeaveNoBitstreamOfTheBoard) {
    const SynthRun synth(kTools);
    const ProgramResult result = synth.synth({"--board", "icebreaker", "--pins-alone"});
    EXPECT_EQ(result.out, "icebreaker: 14 pins are there\n");
    EXPECT_FALSE(synth.exists("out/boards/icebreaker"));
}

TEST(SynthBoard, OneThatDoesNotFitSaysByHowMuchAndLeavesNothingOld) {
    const SynthRun synth(kTools);
    EXPECT_EQ(synth.synth({"--board", "colorlight_i5"}).status, 0);
    const ProgramResult result =
        synth.synth({"--board", "colorlight_i5", "--set", "Build=0", "--set", "Order=12"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err,
              "synth: colorlight_i5: does not fit LFE5U-25F-6BG381C: 30000 TRELLIS_COMB of "
              "24288\n");
    EXPECT_FALSE(synth.exists("out/boards/colorlight_i5/board.json"));
    EXPECT_FALSE(synth.exists("out/boards/colorlight_i5/board.bit"));
}

TEST(SynthBoard, OneThatIsNearlyFullSaysSoWhenItFails) {
    const SynthRun synth(kTools);
    const ProgramResult result =
        synth.synth({"--board", "colorlight_i5", "--set", "Order=10", "--set", "PeriodLog2=13"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "synth: colorlight_i5: unroutable: Routing design failed, see " +
                              (synth.folder() / "out/boards/colorlight_i5/place.log").string() +
                              "; nearly full: 24000 TRELLIS_COMB of 24288\n");
}

TEST(SynthBoard, APllThatMakesAnotherClockIsAnError) {
    const SynthRun synth(kTools);
    Json table = table_of("ulx3s_85");
    table["clock_hz"] = 71'000'000;
    synth.write("odd.json", table.dump());
    const ProgramResult result = synth.synth({"--board", "odd.json"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "synth: odd: the PLL gives 70 MHz instead of 71\n");

    for (const char* board : {"icebreaker", "tang_nano_9k"}) {
        Json other = table_of(board);
        other["clock_hz"] = 45'800'000;
        synth.write("odd.json", other.dump());
        const ProgramResult refused = synth.synth({"--board", "odd.json"});
        EXPECT_EQ(refused.status, 1) << board;
        EXPECT_EQ(refused.err, "synth: odd: the PLL gives 45.5 MHz instead of 45.8\n");
    }
}

// The placement with seed n reaches 100 + n MHz.
TEST(SynthBoard, TakesTheFirstSeedThatKeepsTheClockOrSaysWhatWasReached) {
    const SynthRun synth(kTools);
    Json table = table_of("colorlight_i5");
    table["oscillator_hz"] = table["clock_hz"] = 102'000'000;
    synth.write("fast.json", table.dump());
    const ProgramResult good = synth.synth({"--board", "fast.json", "--seeds", "5"});
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_EQ(synth.runs("nextpnr-ecp5"), 2);
    EXPECT_EQ(Json::parse(synth.read("out/boards/fast/board.json"))["seed"], 2);

    table["oscillator_hz"] = table["clock_hz"] = 150'000'000;
    synth.write("slow.json", table.dump());
    const ProgramResult bad = synth.synth({"--board", "slow.json", "--seeds", "2"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.err, "synth: slow: 102 MHz is less than its clock of 150 MHz (best of 2)\n");
    EXPECT_FALSE(synth.exists("out/boards/slow/board.json"));
}

}  // namespace curvecore::tb::synth_board_test
