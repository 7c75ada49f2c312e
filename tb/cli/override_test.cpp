// SPDX-License-Identifier: Apache-2.0
// Overrides: every program is drawn to its end at any, on every board, with and without stop
// branches. Below 100 % time is scaled, and the host has to send words for the time that has
// passed; above 100 % feeds are planned higher.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::override_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Board {
    const char* name;
    Arguments options;
    std::vector<int> percents = {};  // of the long form, all when left out
};

void PrintTo(const Board& board, std::ostream* out) { *out << board.name; }

/// Returns the system's clock: few enough clocks a sample that a Verilated core is no slower than
/// one alone, and enough for the steps.
Arguments clock_for(const Board& board, const std::string& file) {
    if (std::string(board.name).find("SystemC") != 0) return {};
    const std::set<std::string> fast{"aux_axes.ngc", "butterfly.ngc", "demo.ngc", "helix.ngc"};
    return {"--clock", fast.count(file) != 0 ? "1280kHz" : "256kHz"};
}

Arguments operator+(Arguments all, const Arguments& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

const std::vector<int> kSome{7, 30, 50, 85, 99, 120, 150, 200};
const Arguments kSplines{"--set", "Splines=1"};
const std::vector<Board> kBoards{
    {"Kernel", {"--on", "kernel"}},
    {"Parallel", {"--build", "parallel"}},
    {"SystemC", kSplines + Arguments{"--on", "systemc"}, kSome},
    {"SystemCWithRtl", kSplines + Arguments{"--on", "systemc-rtl"}, kSome},
};
/// A sample takes 2,000 clocks.
const Board kEngine{"Engine", {"--build", "engine"}, {50, 99, 150}};

/// Programs at overrides on one board.
class OverrideRun {
  public:
    explicit OverrideRun(Board board) : board_(std::move(board)) {}

    /// Checks runs at `percents`: the number of samples follows the rate of time or the feeds, but
    /// is never lower than limits allow.
    void draw(const std::string& file, const std::vector<int>& percents,
              const Arguments& all_holds = {"branches"}) {
        for (const std::string& holds : all_holds) {
            const auto full = static_cast<double>(samples(file, holds, 100));
            for (const int percent : percents) {
                const auto drawn = static_cast<double>(samples(file, holds, percent));
                const double scaled = full * 100 / percent;
                EXPECT_GE(drawn, 0.99 * scaled) << file << " " << percent << " %";
                EXPECT_LE(drawn, 1.01 * std::max(scaled, full)) << file << " " << percent << " %";
            }
        }
    }

  private:
    /// Number of samples of a run whose checks all held.
    std::uint64_t samples(const std::string& file, const std::string& holds, int percent) {
        const Arguments arguments = Arguments{"run",
                                              std::string(DATA_DIR "/") + file,
                                              "-q",
                                              "-o",
                                              "out",
                                              "--no-segments",
                                              "--rows",
                                              "1",
                                              "--sample-period",
                                              "1ms",
                                              "--holds",
                                              holds,
                                              "--override",
                                              std::to_string(percent)} +
                                    board_.options + clock_for(board_, file);
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 0) << file << " " << holds << " " << percent << " %\n"
                                    << result.err;
        if (result.status != 0) return 0;
        return Json::parse(program_.read("out/report.json"))["samples"];
    }

    Board board_;
    ProgramRun program_;
};

class Override : public testing::TestWithParam<Board> {};

/// The program's words fill the profile queue long before it ends.
TEST_P(Override, DrawsAProgramThatFillsTheQueue) {
    OverrideRun(GetParam()).draw("stops.ngc", {10});
}

INSTANTIATE_TEST_SUITE_P(Cli, Override, testing::ValuesIn(kBoards),
                         [](const auto& test) { return test.param.name; });

/// More programs, on the fastest board.
class KernelOverride : public testing::TestWithParam<Board> {};

TEST_P(KernelOverride, DrawsProgramsThatFillTheQueue) {
    OverrideRun kernel(GetParam());
    kernel.draw("stops.ngc", {1, 50, 120});
    kernel.draw("arcs.ngc", {3, 50});
    kernel.draw("corner_chain.ngc", {90});
}

INSTANTIATE_TEST_SUITE_P(Cli, KernelOverride, testing::Values(kBoards.front()),
                         [](const auto& test) { return test.param.name; });

/// All programs at all overrides, on slower boards at some, 99 % too: hours.
class LongOverride : public testing::TestWithParam<std::tuple<Board, std::string>> {};

TEST_P(LongOverride, DrawsAProgramAtEveryPercent) {
    const auto& [board, program] = GetParam();
    std::vector<int> percents = board.percents;
    for (int percent = 1; board.percents.empty() && percent <= 200; ++percent) {
        percents.push_back(percent);
    }
    OverrideRun(board).draw(program, percents, {"branches", "bounds"});
}

std::vector<Board> long_boards() {
    std::vector<Board> all = kBoards;
    all.push_back(kEngine);
    return all;
}

std::vector<std::string> programs() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(DATA_DIR)) {
        const std::string name = entry.path().filename();
        if (entry.path().extension() == ".ngc" || name == "points.csv") names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string board_and_program(const testing::TestParamInfo<LongOverride::ParamType>& test) {
    const auto& [board, program] = test.param;
    return board.name + ("_" + program.substr(0, program.find('.')));
}

INSTANTIATE_TEST_SUITE_P(Long, LongOverride,
                         testing::Combine(testing::ValuesIn(long_boards()),
                                          testing::ValuesIn(programs())),
                         board_and_program);

}  // namespace curvecore::tb::override_test
