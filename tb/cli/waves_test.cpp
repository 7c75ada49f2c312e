// SPDX-License-Identifier: Apache-2.0
// The file waves.gtkw shows every group of signals that it names, for every kind of core: a renamed
// signal would be left out.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::waves_test {

using Counts = std::map<std::string, int>;

/// Number of signals in each group of a save file.
Counts groups(const std::string& text) {
    std::istringstream lines(text);
    Counts counts;
    std::string group;
    std::string flags;
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == '@') flags = line;
        if (line[0] == '-' && flags == "@800200") group = line.substr(1);
        if (line.rfind("dut.", 0) == 0) ++counts[group];
    }
    return counts;
}

struct Case {
    const char* name;
    std::vector<std::string> options;
    Counts expected;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const Counts kParallel{{"", 2},      {"Request", 5},        {"Queues", 8},  {"Path generator", 7},
                       {"Steps", 7}, {"Lines and arcs", 8}, {"Sampler", 6}, {"Positions", 7}};

Counts with(const Counts& changed) {
    Counts counts = kParallel;
    for (const auto& [group, signals] : changed) {
        counts[group] = signals;
        if (signals == 0) counts.erase(group);
    }
    return counts;
}

class Waves : public testing::TestWithParam<Case> {};

TEST_P(Waves, AreArrangedInFull) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G61 G90 F900\nG1 X0.1\nG3 X0.2 Y0.1 I0 J0.1\nM2\n");
    std::vector<std::string> arguments{"run", "part.ngc", "-q", "-o", "out"};
    arguments.insert(arguments.end(), {"--trace", "--trace-clocks", "500"});
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    const ProgramResult result = program.run(arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(groups(program.read("out/waves.gtkw")), GetParam().expected);
}

/// Eight bytes of the header of an FST file, the highest first.
std::uint64_t header_word(const std::string& file, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < 8; ++i) word = word << 8 | static_cast<unsigned char>(file[at + i]);
    return word;
}

/// The waveform is in picoseconds of the clock that the options give; it opens on the first sample.
TEST(WavesTime, IsThatOfTheClock) {
    for (const auto& [clock, period_ps] : {std::pair("100MHz", 10e3), {"20MHz", 50e3}}) {
        const ProgramRun program;
        program.write("part.ngc", "G21 G61 G90 F900\nG1 X4\nM2\n");
        const ProgramResult result = program.run({"run", "part.ngc", "-q", "-o", "out", "--trace",
                                                  "--trace-clocks", "2000", "--clock", clock});
        ASSERT_EQ(result.status, 0) << result.err;
        const std::string fst = program.read("out/waves.fst");
        constexpr std::size_t kEndTime = 17;
        constexpr std::size_t kTimescale = 73;  // a power of ten, s
        EXPECT_EQ(static_cast<signed char>(fst[kTimescale]), -12);
        EXPECT_NEAR(static_cast<double>(header_word(fst, kEndTime)), 2000 * period_ps, period_ps);
        std::istringstream lines(program.read("out/waves.gtkw"));
        double start = -1;
        double zoom = 0;
        double marker = -1;
        for (std::string line; std::getline(lines, line);) {
            if (line.rfind("[timestart] ", 0) == 0) start = std::stod(line.substr(12));
            if (line[0] != '*') continue;
            std::istringstream(line.substr(1)) >> zoom >> marker;
        }
        EXPECT_GT(start, 0);
        EXPECT_LT(start, marker);
        EXPECT_LT(marker, 2000 * period_ps);
        EXPECT_NEAR(std::exp2(-zoom) * 5, 200 * period_ps, period_ps) << "clocks on the screen";
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cores, Waves,
    testing::Values(Case{"Default", {}, kParallel},
                    Case{"Splines", {"--set", "Splines=1"}, with({{"Splines", 7}})},
                    Case{"Polynomial", {"--set", "Mode=1"}, kParallel},
                    Case{"Engine",
                         {"--build", "engine", "--set", "Splines=1"},
                         with({{"Steps", 0},
                               {"Lines and arcs", 0},
                               {"Sampler", 0},
                               {"Path generator", 5},
                               {"Engine", 11}})}),
    [](const auto& test) { return test.param.name; });

}  // namespace curvecore::tb::waves_test
