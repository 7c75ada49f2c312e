// SPDX-License-Identifier: Apache-2.0
// The same words give the same samples on every board: kernel, Verilated core, and the system in
// SystemC with either of them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::boards_test {

using Json = nlohmann::json;
using Rows = std::vector<std::string>;
using Arguments = std::vector<std::string>;

class Boards : public testing::Test {
  protected:
    Json draw(const std::string& file, const std::string& board, const Arguments& options,
              int status = 0) {
        Arguments arguments{"run", file, "-q", "-o", board, "--on", board};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, status) << board << ": " << result.err;
        return Json::parse(program_.read(board + "/report.json"));
    }

    Rows rows(const std::string& board) const {
        std::istringstream text(program_.read(board + "/samples.csv"));
        Rows rows;
        for (std::string line; std::getline(text, line);) {
            if (line[0] != '#') rows.push_back(line);
        }
        return rows;
    }

    /// Checks that all boards draw the file alike.
    void compare(const std::string& file, const Arguments& options) {
        const Json kernel = draw(file, "kernel", options);
        const Rows expected = rows("kernel");
        ASSERT_EQ(expected.size(), kernel["samples"].get<std::size_t>() + 2);
        for (const char* board : {"rtl", "systemc", "systemc-rtl"}) {
            const Json report = draw(file, board, options);
            EXPECT_EQ(report["board"], board);
            EXPECT_EQ(report["rtl_equals_kernel"], 0) << board;
            EXPECT_EQ(report["late_samples"], 0) << board;
            EXPECT_TRUE(rows(board) == expected) << board;
        }
    }

    ProgramRun program_;
};

const Arguments kSplines{"--set", "Splines=1", "--sample-period", "500us"};

TEST_F(Boards, DrawArcsAlike) { compare(DATA_DIR "/arcs.ngc", kSplines); }
TEST_F(Boards, DrawSplinesAlike) { compare(DATA_DIR "/splines.ngc", kSplines); }
TEST_F(Boards, DrawAuxiliaryAxesAlike) { compare(DATA_DIR "/aux_axes.ngc", kSplines); }
TEST_F(Boards, DrawSamplesThatShareTicksAlike) {
    Arguments options = kSplines;
    options.insert(options.end(), {"--samples-per-tick", "8", "--override", "70"});
    compare(DATA_DIR "/stops.ngc", options);
}

TEST_F(Boards, OverridesPlanHigherFeeds) {
    program_.write("line.ngc", "G21 G1 F600 X20 Y3\nG2 X40 I10 J0\nG0 X0 Y0\nM2\n");
    const double asked = draw("line.ngc", "kernel", {})["duration_s"];
    const Json doubled = draw("line.ngc", "kernel", {"--override", "200"});
    EXPECT_LT(doubled["duration_s"], 0.6 * asked);
    EXPECT_GT(doubled["duration_s"], 0.5 * asked) << "G0 is as fast as it can be";
    EXPECT_EQ(doubled["override_percent"], 200);
}

/// Lines, arcs and splines at random, many of them shorter than a sample's path.
TEST_F(Boards, DrawARandomProgramAlike) {
    std::mt19937_64 engine(11);
    const auto within = [&engine](double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    };
    std::ostringstream text;
    text << std::fixed << "G21 G91 G17 G94 F6000\n";
    for (int move = 0; move < 120; ++move) {
        const double size = std::pow(10, within(-3, 0.5));
        const double x = size * within(-1, 1);
        const double y = size * within(-1, 1);
        switch (engine() % 3) {
            case 0:
                text << "G1 X" << x << " Y" << y << " Z" << within(-0.1, 0.1) << "\n";
                break;
            case 1:
                text << "G2 X" << x << " Y" << y << " R" << std::hypot(x, y) << "\n";
                break;
            default:
                text << "G5 X" << x << " Y" << y << " I" << y << " J" << x << " P" << -x << " Q"
                     << y << "\n";
        }
    }
    text << "M2\n";
    program_.write("random.ngc", text.str());
    compare("random.ngc", kSplines);
}

/// Negative control of the comparison: another rate of time is detected.
TEST_F(Boards, ComparisonSeesAnotherOverride) {
    draw(DATA_DIR "/arcs.ngc", "kernel", kSplines);
    Arguments slower = kSplines;
    slower.insert(slower.end(), {"--override", "99"});
    draw(DATA_DIR "/arcs.ngc", "systemc", slower);
    EXPECT_FALSE(rows("kernel") == rows("systemc"));
}

/// A chain of moves of 10 um at 20 m/min: its queues would not outlast a stop, so it is slowed, and
/// a host that looks once a millisecond keeps up.
TEST_F(Boards, SystemDrawsAChainOfShortMovesInTime) {
    std::ostringstream text;
    text << "G21 G61 G91 G1 F20000\n";
    for (int move = 0; move < 20000; ++move) text << "X0.01\n";
    text << "M2\n";
    program_.write("chain.ngc", text.str());
    const Json kernel = draw("chain.ngc", "kernel", {});
    ASSERT_EQ(kernel["warnings"].size(), 1u);
    EXPECT_NE(kernel["warnings"][0].get<std::string>().find("short moves are slowed"),
              std::string::npos);
    EXPECT_EQ(draw("chain.ngc", "systemc", {})["late_samples"], 0);
    EXPECT_TRUE(rows("systemc") == rows("kernel"));
}

/// Negative control: the wrong core is found on every board that it draws.
TEST(WrongCore, IsFoundWithinTheSystem) {
    const ProgramRun program(CURVECORE_WRONG_ROUNDING);
    program.write("part.ngc", "G21 G61 G90 F450\nG1 X0.1\nG3 X0.2 Y0.1 I0 J0.1\nM2\n");
    EXPECT_EQ(program.run({"run", "part.ngc", "-o", "out", "--on", "kernel"}).status, 0);
    const ProgramResult result =
        program.run({"run", "part.ngc", "-o", "out", "--on", "systemc-rtl"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.rfind("curvecore: check failed: SystemC system with RTL equals kernel", 0),
              0U)
        << result.err;
}

}  // namespace curvecore::tb::boards_test
