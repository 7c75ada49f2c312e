// SPDX-License-Identifier: Apache-2.0
// waves.gtkw arranges every group of signals that it names, for every kind of core: a renamed
// signal would be left out.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {
namespace {

using Counts = std::map<std::string, int>;

/// Signals per group of a save file.
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

INSTANTIATE_TEST_SUITE_P(
    Cores, Waves,
    testing::Values(
        Case{"Default", {}, kParallel},
        Case{"AuxAxes",
             {"--build", "serial", "--set", "AuxAxes=6"},
             with({{"Steps", 0},
                   {"Lines and arcs", 0},
                   {"Network", 11},
                   {"Sampler", 7},
                   {"Positions", 13}})},
        Case{"Splines", {"--set", "Splines=1"}, with({{"Splines", 7}})},
        Case{"Polynomial", {"--set", "Mode=1"}, kParallel},
        Case{"Serial",
             {"--build", "serial"},
             with({{"Steps", 0}, {"Lines and arcs", 0}, {"Network", 11}, {"Sampler", 7}})}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace curvecore::tb
