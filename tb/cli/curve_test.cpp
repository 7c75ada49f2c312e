// SPDX-License-Identifier: Apache-2.0
// `curvecore curve`: what it says of a table, and its refusals.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {
namespace {

using Arguments = std::vector<std::string>;

class CurveCommand : public testing::Test {
  protected:
    CurveCommand() {
        std::ifstream file(CURVES_DIR "/clothoid.net");
        table_ = {std::istreambuf_iterator<char>(file), {}};
        program_.write("c.net", table_);
    }

    ProgramResult check(const Arguments& more, const char* kappa = "kappa=0.05,0.05,0.05") const {
        Arguments all{"curve",   "check", "c.net", "--row", "T=1,0,0",    "--row",
                      "N=0,1,0", "--row", kappa,   "--row", "sigma=0.001"};
        all.insert(all.end(), more.begin(), more.end());
        return program_.run(all);
    }

    /// The bound that it says, length units.
    double bound(const Arguments& more) const {
        const ProgramResult result = check(more);
        EXPECT_EQ(result.status, 0) << result.err;
        const std::size_t at = result.out.find("\nerror: ");
        return at == std::string::npos ? -1 : std::stod(result.out.substr(at + 8));
    }

    std::string refusal(const Arguments& arguments) const {
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    }

    std::string table_;
    ProgramRun program_;
};

TEST_F(CurveCommand, SaysRowsAndWhatTheEngineNeeds) {
    const ProgramResult result = program_.run({"curve", "check", "c.net", "--set", "CoefBits=30"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("\nx[k]                   28        +-2       6\n"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("\nengine: "), std::string::npos);
    EXPECT_EQ(result.out.find("\nerror: "), std::string::npos) << "no segment is given";
}

TEST_F(CurveCommand, BoundsASegment) {
    const double here = bound({"--steps", "8"});
    EXPECT_GT(here, 1e-3);
    EXPECT_LT(here, 0.1);
    EXPECT_GT(bound({"--steps", "16"}), here);
    EXPECT_GT(bound({"--steps", "8", "--set", "CoefBits=32"}), 8 * here);
    EXPECT_GT(bound({"--steps", "8", "--set", "Order=3"}), 2 * here);
    EXPECT_GT(bound({"--steps", "8", "--step-exponent", "22"}), 2 * here);
}

TEST_F(CurveCommand, NamesARowThatLeavesItsRange) {
    const ProgramResult result = check({}, "kappa=0.3,0.3,0.3");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("c.net:6: error: kappa leaves its range: it needs a fraction of +0, "
                              "not +1, or a shorter step\n"),
              std::string::npos)
        << result.err;
    EXPECT_EQ(result.out.find("\nerror: "), std::string::npos) << "no bound";
    // One that leaves it from step to step: no value that was given does.
    const ProgramResult carried =
        program_.run({"curve", "check", "c.net", "--row", "T=1,0,0", "--row", "N=0,1,0", "--row",
                      "kappa=0.24,0.24,0.24", "--row", "sigma=0.01", "--steps", "8"});
    EXPECT_EQ(carried.status, 1);
    EXPECT_NE(carried.err.find("kappa leaves its range: it needs a fraction of +0, not +1"),
              std::string::npos)
        << carried.err;
    EXPECT_NE(check({}, "kappa=1e300,0,0").err.find("kappa leaves its range: no fraction holds it"),
              std::string::npos);
}

TEST_F(CurveCommand, RefusesWhatIsNoSegment) {
    const auto of = [](const Arguments& more) {
        Arguments all{"curve", "check", "c.net"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    EXPECT_EQ(refusal(of({"--row", "w=1"})),
              "curvecore: error: --row w: clothoid takes kappa, N, T, sigma\n");
    EXPECT_EQ(refusal(of({"--row", "T=1"})),
              "curvecore: error: --row T: expected 3 values, not 1\n");
    EXPECT_EQ(refusal(of({"--row", "T=1,0,0"})),
              "curvecore: error: --row kappa=..: clothoid needs its value\n");
    EXPECT_EQ(refusal(of({"--row", "sigma=much"})),
              "curvecore: error: --row 'much': not a number\n");
    EXPECT_EQ(refusal(of({"--row", "sigma=nan"})), "curvecore: error: --row 'nan': not a number\n");
    EXPECT_EQ(refusal(of({"--row", "sigma=0", "--row", "sigma=0"})),
              "curvecore: error: --row sigma: it has two values\n");
    EXPECT_EQ(refusal(of({"--steps", "0"})), "curvecore: error: --steps must be in [1, 100]\n");
    EXPECT_EQ(refusal(of({"--steps", "4"})), "curvecore: error: --steps requires --row\n");
    EXPECT_EQ(refusal(of({"--set", "Anchor=0"})),
              "curvecore: error: --set Anchor: a table's words depend on Order, CoefBits, "
              "PositionBits, GuardBits, Mode alone\n");
    EXPECT_EQ(refusal({"curve", "draw", "c.net"}),
              "curvecore: error: ACTION 'draw': must be one of check\n");
    EXPECT_EQ(refusal({"curve", "check", "none.net"}).substr(0, 9), "none.net:");
}

TEST_F(CurveCommand, NamesALineThatIsWrong) {
    program_.write("c.net", table_ + "  kapa[k] : +1 = kappa[k].0 + kapa[k]\n");
    EXPECT_EQ(refusal({"curve", "check", "c.net"}), "c.net:23: error: no line before makes kapa\n");
    program_.write("c.net", table_ + "  fine : -2 = 1/2048 sigma*sigma\n");
    const ProgramResult result = program_.run({"curve", "check", "c.net"});
    EXPECT_EQ(result.status, 0) << "others may draw it";
    EXPECT_NE(result.out.find("engine: does not draw it: c.net:23: error: a product over 2^"),
              std::string::npos)
        << result.out << result.err;
}

}  // namespace
}  // namespace curvecore::tb
