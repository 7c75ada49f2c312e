// SPDX-License-Identifier: Apache-2.0
// `curvecore curve`: what it says of a table, and its refusals.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::curve_test {

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
    EXPECT_NE(result.out.find("; parameter Table="), std::string::npos);
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
    EXPECT_EQ(refusal(of({"--set", "Anchor=0", "--set", "Splines=1"})),
              "curvecore: error: --set: a table is drawn with Anchor=1 and ParameterGuard=0\n");
    EXPECT_EQ(refusal({"curve", "draw", "c.net"}),
              "curvecore: error: ACTION 'draw': must be one of check, run, derive, kernel\n");
    EXPECT_EQ(refusal({"curve", "check", "none.net"}).substr(0, 9), "none.net:");
}

TEST_F(CurveCommand, PrintsTheKernelOfATable) {
    const ProgramResult result = program_.run({"curve", "kernel", "c.net"});
    EXPECT_EQ(result.status, 0) << result.err;
    std::ifstream file(CURVES_DIR "/../../hls/curves/clothoid.hpp");
    std::string kept{std::istreambuf_iterator<char>(file), {}};
    kept.replace(kept.find("clothoid.net"), 12, "c.net");
    EXPECT_EQ(result.out, kept);
    EXPECT_EQ(program_.run({"curve", "kernel", "arc"}).status, 0);
    EXPECT_EQ(refusal({"curve", "kernel", "circle"}).substr(0, 72),
              "curvecore: error: FILE 'circle': it is FILE.net, or one of arc, archimed");
    EXPECT_EQ(refusal({"curve", "kernel", "c.net", "--x", "t"}),
              "curvecore: error: --x --y --z: of run and derive\n");
}

/// A formula that is in no file, from its text through the RTL.
TEST_F(CurveCommand, DrawsAFormula) {
    const Arguments formula{"wave.net", "--x", "20*t",       "--y", "8*sin(w*t)",
                            "--let",    "w=2", "--t=-2,2.5", "-q"};
    Arguments all{"curve", "run"};
    all.insert(all.end(), formula.begin(), formula.end());
    all.insert(all.end(), {"--sample-period", "1ms", "--feed", "3m/min", "--set", "Order=4",
                           "--unit", "100nm", "-o", "out"});
    const ProgramResult result = program_.run(all);
    ASSERT_EQ(result.status, 0) << result.err;
    const auto report = nlohmann::json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["board"], "rtl");
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_LE(report["kinds"]["wave"]["max_of_bound"], 1);
    EXPECT_GT(report["kinds"]["wave"]["samples"], 1000);
    EXPECT_NE(program_.read("out/wave.net").find("\ncurve wave "), std::string::npos);

    // The same by a program: derive says how it names the curve.
    all = {"curve", "derive"};
    all.insert(all.end(), formula.begin(), formula.end());
    const ProgramResult derived = program_.run(all);
    ASSERT_EQ(derived.status, 0) << derived.err;
    program_.write("p.ngc", "G21 G90 G64 F3000\n" + derived.out + "M2\n");
    const ProgramResult again =
        program_.run({"run", "p.ngc", "--curve", "wave.net", "--on", "kernel", "--sample-period",
                      "1ms", "--set", "Order=4", "--unit", "100nm", "-q", "-o", "again"});
    ASSERT_EQ(again.status, 0) << again.err;
    const auto second = nlohmann::json::parse(program_.read("again/report.json"));
    EXPECT_LE(second["kinds"]["wave"]["max_of_bound"], 1);
    EXPECT_GT(second["kinds"]["wave"]["samples"], 1000);
}

TEST_F(CurveCommand, SaysWhatIsNoFormula) {
    const auto of = [&](const Arguments& more) {
        Arguments all{"curve", "run", "f.net", "--t", "0,1"};
        all.insert(all.end(), more.begin(), more.end());
        return refusal(all);
    };
    EXPECT_EQ(of({"--x", "t", "--y", "sin(t"}),
              "curvecore: error: 'sin(t': expected ')', not the end\n");
    EXPECT_EQ(of({"--x", "R*t", "--y", "t"}),
              "curvecore: error: 'R*t': R has no value: --let R=..\n");
    EXPECT_EQ(of({"--x", "t", "--y", "2*t"}),
              "curvecore: error: a straight line: it needs no table\n");
    EXPECT_EQ(of({"--x", "t"}),
              "curvecore: error: --x and --y: the formulas of a curve, and --z "
              "in space\n");
    EXPECT_EQ(of({"--x", "t", "--y", "t^2", "--length", "4mm", "--row", "T=1"}),
              "curvecore: error: --x --y: the formulas say the rows and the length\n");
    EXPECT_EQ(of({"--x", "t^2", "--y", "t^3"}).substr(0, 30), "curvecore: error: near t = 0 t");
    EXPECT_EQ(refusal({"curve", "derive", "f.net", "--t", "0,1", "--x", "t", "--y", "t^2", "--row",
                       "T=1"}),
              "curvecore: error: --x --y: the formulas say the rows and the length\n");
    EXPECT_EQ(refusal({"curve", "check", "c.net", "--x", "t", "--y", "t^2"}),
              "curvecore: error: --x --y --z: of run and derive\n");
    EXPECT_EQ(
        refusal({"curve", "derive", "c.net", "--t", "0,1", "--x", "t", "--y", "t^2"}),
        "curvecore: error: FILE 'c.net': it is there, and not of these formulas: take another "
        "name\n");
    EXPECT_EQ(refusal({"curve", "run", "f.net", "--x", "t", "--y", "t^2", "--t", "1,0"}),
              "curvecore: error: --t: expected FROM,TO, from less to more\n");
}

/// A clothoid from a line into the curvature of a circle.
class NamedCurves : public testing::Test {
  protected:
    NamedCurves() {
        program_.write("p.ngc",
                       "G21 G90 G64\nF3000 G1 X10\n(curve, clothoid, T=1 0 0, N=0 1 0, kappa=0, "
                       "sigma=0.0025, length=40)\nG1 X36.7039 Y19.9525\nM2\n");
    }

    ProgramResult run(const Arguments& more) const {
        Arguments all{"run", "p.ngc", "--sample-period", "1ms", "-q", "-o", "out"};
        all.insert(all.end(), more.begin(), more.end());
        return program_.run(all);
    }
    nlohmann::json json(const char* file) const {
        return nlohmann::json::parse(program_.read(std::string("out/") + file));
    }

    ProgramRun program_;
};

TEST_F(NamedCurves, AreDrawnWithinTheirBound) {
    const ProgramResult result =
        run({"--curve", "clothoid", "--build", "engine", "--on", "kernel"});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto report = json("report.json");
    EXPECT_LT(report["limits"]["planned"]["joints"]["acceleration"], 1e-3) << "tangent joints";
    const auto& kind = report["kinds"]["clothoid"];
    EXPECT_GT(kind["samples"], 500);
    EXPECT_LE(kind["max_of_bound"], 1);
    EXPECT_GT(kind["max_of_bound"], 0.05);
    int segments = 0;
    const auto written = json("segments.json");
    for (const auto& segment : written["segments"]) {
        if (segment["kind"] != "clothoid") continue;
        ++segments;
        EXPECT_NEAR(segment["curvature_end_per_mm"].get<double>() -
                        segment["curvature_start_per_mm"].get<double>(),
                    0.0025 * segment["length_mm"].get<double>(), 1e-8);
        EXPECT_EQ(segment["rows"]["sigma"].size(), 1U);
        EXPECT_EQ(segment["rows"]["T"].size(), 3U);
    }
    EXPECT_GT(segments, 0);
}

/// The RTL of the engine is the same for all tables; its microcode has this one.
TEST_F(NamedCurves, AreDrawnByTheRtlOfTheEngine) {
    const ProgramResult result = run({"--curve", "clothoid", "--build", "engine"});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto report = json("report.json");
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["board"], "rtl");
}

TEST_F(NamedCurves, AreRefusedWhereNothingDrawsThem) {
    const auto refusal = [&](const Arguments& more) {
        const ProgramResult result = run(more);
        EXPECT_EQ(result.status, 2);
        return result.err;
    };
    EXPECT_EQ(refusal({"--curve", "clothoid", "--build", "parallel"}),
              "curvecore: error: --curve: a table is drawn by --build engine\n");
    EXPECT_EQ(refusal({"--curve", "spirals"}).substr(0, 70),
              "curvecore: error: --curve 'spirals': it is FILE.net, or one of arc, ar");
    EXPECT_NE(refusal({"--curve", "spline"}).find("a program draws splines without a table"),
              std::string::npos);
    EXPECT_EQ(refusal({"--curve", "clothoid", "--interpreter", "linuxcnc"}),
              "curvecore: error: --curve or --interpreter: LinuxCNC's does not know the comment\n");
    EXPECT_EQ(refusal({}).find("p.ngc:3: error: a curve 'clothoid'"), 0U);
    EXPECT_EQ(refusal({"--curve", "clothoid", "--on", "kernel", "--set", "CoefBits=20"}),
              "p.ngc:4: error: the words of this core do not draw this clothoid within 0.1 units: "
              "take a larger CoefBits or Order\n");
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

}  // namespace curvecore::tb::curve_test
