// SPDX-License-Identifier: Apache-2.0
// Programs with splines between lines and arcs: planned, and run through the RTL.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/cli/program_run.hpp"
#include "tb/support/judge/curve_distance.hpp"

namespace curvecore::tb::spline_commands_test {

using Json = nlohmann::json;

class SplineCommands : public testing::Test {
  protected:
    void SetUp() override {
        program_.write("part.ngc",
                       "G21 G90 G17 G94 F1200\n"
                       "G1 X10\n"
                       "G5 X20 Y10 I5 J0 P0 Q-5\n"
                       "G3 X10 Y20 I-10 J0\n"
                       "M2\n");
    }

    ProgramRun program_;
};

TEST_F(SplineCommands, PlanSaysWhatEverySegmentIs) {
    const ProgramResult result = program_.run({"plan", "part.ngc", "-q", "-o", "out"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    int splines = 0;
    const Json plan = Json::parse(program_.read("out/segments.json"));
    for (const Json& segment : plan["segments"]) {
        const std::vector<std::string> kinds{"line", "spline", "arc"};
        EXPECT_EQ(segment["kind"], kinds.at(segment["move"]));
        if (segment["kind"] != "spline") {
            EXPECT_FALSE(segment.contains("lambda"));
            continue;
        }
        ++splines;
        // Results of preparing the frame: the unit tangent, and the sharpest place within.
        const Json tangent = segment["tangent_end"];
        EXPECT_NEAR(std::hypot(tangent[0].get<double>(), tangent[1], tangent[2]), 1, 1e-6);
        const double least = segment["least_radius_mm"];
        EXPECT_LE(least, (1 + 1e-6) / segment["curvature_start_per_mm"].get<double>());
        EXPECT_LE(least, (1 + 1e-6) / segment["curvature_end_per_mm"].get<double>());
        EXPECT_LE(segment["least_radius_at_mm"], segment["length_mm"]);
        // r(beta) = start + 2^lambda ((a beta + b) beta + c) beta, in units of 1 nm.
        const double beta = segment["beta"];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double a = segment["a"][axis];
            const double b = segment["b"][axis];
            const double c = segment["c"][axis];
            const double start = segment["start_mm"][axis];
            const double end =
                start + std::ldexp(((a * beta + b) * beta + c) * beta, segment["lambda"]) * 1e-6;
            EXPECT_NEAR(segment["end_mm"][axis].get<double>(), end, 1e-9);
        }
    }
    EXPECT_GT(splines, 0);
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["core"], "curve");
    EXPECT_LE(report["unrounded"]["bound_lsb"], 0.1);
    EXPECT_TRUE(program_.exists("out/report.html"));
}

/// Worst figures of a run of the part with these options.
class SplineRuns : public SplineCommands,
                   public testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(SplineRuns, HoldEveryBoundWithLinesAndArcs) {
    std::vector<std::string> arguments{"run", "part.ngc", "-q", "-o", "out"};
    arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
    const ProgramResult result = program_.run(arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["core"], "curve");
    EXPECT_EQ(report["parameters"]["Splines"], 1);
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["landing_lsb"], 0);
    for (const char* axis : {"x", "y", "z"}) {
        EXPECT_LE(report["error"]["max_lsb"][axis], 0.6);
        EXPECT_LE(report["unrounded"]["max_lsb"][axis], report["unrounded"]["bound_lsb"]);
    }
    EXPECT_GT(report["error"]["max_lsb"]["x"], 0.4);
    for (const char* kind : {"line", "arc", "spline"}) {
        const Json& worst = report["kinds"].at(kind);
        EXPECT_GT(worst["samples"], 100) << kind;
        EXPECT_GT(worst["unrounded_max_lsb"], 1e-4) << kind;
        EXPECT_LE(worst["unrounded_max_lsb"], worst["bound_lsb"]) << kind;
        EXPECT_LE(worst["max_of_bound"], 1) << kind;
        EXPECT_LE(worst["speed_max_error_lsb"], 0.1) << kind;
    }
}

INSTANTIATE_TEST_SUITE_P(Cores, SplineRuns,
                         testing::Values(std::vector<std::string>{"--stall", "3"},
                                         std::vector<std::string>{"--on", "kernel", "--set",
                                                                  "Mode=1"}),
                         [](const auto& tested) { return name_of(tested.param); });

TEST_F(SplineCommands, RunFasterWithMoreEffort) {
    program_.write("fast.ngc",
                   "G21 G90 G17 G94 F30000\n"
                   "G1 X10\n"
                   "G5 X20 Y10 I5 J0 P0 Q-5\n"
                   "G3 X10 Y20 I-10 J0\n"
                   "M2\n");
    const ProgramResult by_rules =
        program_.run({"run", "fast.ngc", "-q", "-o", "rules", "--effort", "rules"});
    ASSERT_EQ(by_rules.status, 0) << by_rules.err;
    const ProgramResult result =
        program_.run({"run", "fast.ngc", "-q", "-o", "optimum", "--effort", "optimum"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json rules = Json::parse(program_.read("rules/report.json"));
    const Json optimum = Json::parse(program_.read("optimum/report.json"));
    EXPECT_EQ(optimum["effort"], "optimum");
    EXPECT_EQ(optimum["rtl_equals_kernel"], 0);
    EXPECT_EQ(optimum["landing_lsb"], 0);
    EXPECT_LT(optimum["duration_s"], 0.9 * rules["duration_s"].get<double>());
}

const char* const kCorners =
    "G21 G64 P0.05 F3000\nG1 X10\nG1 Y10\nG1 X5\nG3 X0 Y5 J-5\nG1 Y0\nM2\n";

/// The part is drawn within the program's tolerance, without a stop at any corner.
TEST_F(SplineCommands, DrawWhatG64Allows) {
    program_.write("part.ngc", kCorners);
    const ProgramResult result = program_.run({"run", "part.ngc", "-o", "out"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "5 moves within 50 um: 2 corners", result.out);
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["stops"]["planned"], 1);
    EXPECT_NEAR(report["deviation"]["share_of_P"], 1, 1e-9);
    EXPECT_NEAR(report["deviation"]["max_mm"], 0.05, 1e-9);
    EXPECT_EQ(report["deviation"]["line"], 2);
    ASSERT_EQ(program_.run({"run", "part.ngc", "-o", "exact", "--path", "exact"}).status, 0);
    const Json exact = Json::parse(program_.read("exact/report.json"));
    EXPECT_EQ(exact["stops"]["planned"], 3);
    EXPECT_EQ(exact["deviation"]["max_mm"], 0);
    EXPECT_EQ(exact["moves"], 5);
}

/// The exact path is planned beside a short program alone: that of a long one takes longer than
/// what is drawn.
TEST_F(SplineCommands, PlanTheExactPathOfShortPrograms) {
    for (const int chords : {1000, 1001}) {
        std::string text = "G21 G64 P0.01 F3000\nG1\n";
        for (int n = 1; n <= chords; ++n) {
            text += fmt::format("X{:.3f} Y{:.3f}\n", 0.02 * n, std::sin(0.02 * n));
        }
        program_.write("part.ngc", text + "M2\n");
        const ProgramResult result = program_.run({"plan", "part.ngc", "-o", "out"});
        ASSERT_EQ(result.status, 0) << result.err;
        const Json exact = Json::parse(program_.read("out/report.json"))["deviation"]["exact"];
        if (chords == 1000) {
            EXPECT_EQ(exact["moves"], 1000);
        } else {
            EXPECT_TRUE(exact.is_null());
        }
        EXPECT_EQ(result.out.find("so many moves; --path exact") != std::string::npos,
                  chords > 1000);
    }
}

/// A core without splines takes half of the tolerance for arcs.
TEST_F(SplineCommands, DrawWhatG64AllowsByArcs) {
    program_.write("part.ngc", kCorners);
    const ProgramResult result =
        program_.run({"run", "part.ngc", "-o", "out", "--set", "Splines=0"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "the core draws no splines", result.out);
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["core"], "spherical");
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_FALSE(report["kinds"].contains("spline"));
    EXPECT_LE(report["deviation"]["share_of_P"], 1 + 1e-9);
    EXPECT_GT(report["deviation"]["share_of_P"], 0.5);
}

/// The core of arcs alone draws splines for boards without them.
TEST_F(SplineCommands, RunAsArcs) {
    const ProgramResult result = program_.run({"run", "part.ngc", "-o", "out", "--fit", "arcs",
                                               "--tolerance", "2um", "--set", "Splines=0"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "arcs and lines, off by ", result.out);
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "as chords ", result.out);
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["core"], "spherical");
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_FALSE(report["kinds"].contains("spline"));
    const Json& arcs = report["as_arcs"];
    EXPECT_EQ(arcs["splines"], 1);
    EXPECT_LE(arcs["deviation_mm"], 2e-3);
    EXPECT_GE(arcs["deviation_mm"], 0.5e-3);
    const Json& forms = arcs["forms"];
    EXPECT_EQ(forms["arcs"]["moves"], report["moves"]);
    EXPECT_EQ(forms["arcs"]["moves"], 2 + arcs["pieces"].get<int>());
    EXPECT_EQ(forms["splines"]["moves"], 3);
    EXPECT_GT(forms["chords"]["words"], forms["arcs"]["words"]);
    EXPECT_GT(forms["chords"]["words"], forms["splines"]["words"]);
    // A program without splines is unchanged.
    program_.write("line.ngc", "G21 G1 X10 F1200\nM2\n");
    ASSERT_EQ(program_.run({"plan", "line.ngc", "-q", "-o", "line", "--fit", "arcs"}).status, 0);
    EXPECT_FALSE(Json::parse(program_.read("line/report.json")).contains("as_arcs"));
}

/// Samples of the arcs are compared with the spline itself.
TEST_F(SplineCommands, ArcsStayWithinTheToleranceOfTheSpline) {
    program_.write("curve.ngc", "G21 G1 Z0 F1200\nG5 X20 Y10 I5 J0 P0 Q-5\nM2\n");
    ref::RationalBezier curve;
    curve.points = {{0, 0, 0, 1}, {5, 0, 0, 1}, {20, 5, 0, 1}, {20, 10, 0, 1}};
    const CurveDistance distance(curve);
    for (const double tolerance : {1e-3, 2e-2}) {
        const std::string text = std::to_string(tolerance) + "mm";
        ASSERT_EQ(program_
                      .run({"run", "curve.ngc", "-q", "-o", "out", "--on", "kernel", "--fit",
                            "arcs", "--tolerance", text})
                      .status,
                  0);
        std::istringstream samples(program_.read("out/samples.csv"));
        double worst = 0;
        int count = 0;
        for (std::string line; std::getline(samples, line);) {
            long k = 0, segment = 0, s = 0, x = 0, y = 0;
            if (std::sscanf(line.c_str(), "%ld,%ld,%ld,%ld,%ld", &k, &segment, &s, &x, &y) != 5) {
                continue;
            }
            if (count++ % 7 != 0) continue;
            const ref::Vec3 point(static_cast<double>(x) * 1e-6, static_cast<double>(y) * 1e-6, 0);
            worst = std::max(worst, distance.of(point));
        }
        EXPECT_GT(count, 1000);
        EXPECT_LE(worst, tolerance + 1e-6);
        EXPECT_GT(worst, 0.2 * tolerance);
    }
}

TEST_F(SplineCommands, RunsWithAFineParameter) {
    const ProgramResult result = program_.run({"run", "part.ngc", "-q", "-o", "out", "--set",
                                               "Order=4", "--set", "CoefBits=28", "--set", "Mode=1",
                                               "--set", "ParameterGuard=4", "--on", "kernel"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["parameters"]["ParameterGuard"], 4);
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["landing_lsb"], 0);
    EXPECT_LE(report["unrounded"]["max_of_bound"], 1);
    EXPECT_GT(report["unrounded"]["max_of_bound"], 0.1);
}

/// The scheme of the paper: no bound is derived for its splines, and the reports say so.
class CarriedStates : public SplineCommands,
                      public testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(CarriedStates, RunAndSayThatSplinesHaveNoBound) {
    std::vector<std::string> arguments{"run", "part.ngc", "-o", "out", "--set", "Anchor=0"};
    arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
    const ProgramResult result = program_.run(arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string none = "no bound is derived for splines with Anchor=0";
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "part.ngc: warning: " + none, result.err);
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "; none is derived for splines with Anchor=0",
                        result.out);
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["parameters"]["Anchor"], 0);
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["landing_lsb"], 0);
    EXPECT_EQ(report["unrounded"]["bounded"], false);
    const Json& spline = report["kinds"]["spline"];
    EXPECT_TRUE(spline["bound_lsb"].is_null() && spline["max_of_bound"].is_null());
    EXPECT_LE(report["kinds"]["arc"]["max_of_bound"], 1);
    // Errors with 36 bits and half a segment: still far below a unit, and other words than with
    // Anchor 1.
    EXPECT_LE(spline["unrounded_max_lsb"], 0.5);
    program_.run({"run", "part.ngc", "-q", "-o", "anchored", "--on", "kernel"});
    const Json anchored = Json::parse(program_.read("anchored/report.json"));
    EXPECT_EQ(anchored["unrounded"]["bounded"], true);
    EXPECT_NE(spline["unrounded_max_lsb"], anchored["kinds"]["spline"]["unrounded_max_lsb"]);
}

INSTANTIATE_TEST_SUITE_P(Boards, CarriedStates,
                         testing::Values(std::vector<std::string>{"--on", "kernel"},
                                         std::vector<std::string>{"--on", "kernel", "--set",
                                                                  "Mode=1"}),
                         [](const auto& tested) { return name_of(tested.param); });
INSTANTIATE_TEST_SUITE_P(Long, CarriedStates,
                         testing::Values(std::vector<std::string>{"--stall", "5"}),
                         [](const auto& tested) { return name_of(tested.param); });

TEST_F(SplineCommands, OfCarriedStatesArePlannedAndMadeIntoWords) {
    for (const char* command : {"plan", "words"}) {
        const ProgramResult result =
            program_.run({command, "part.ngc", "-o", command, "--set", "Anchor=0"});
        EXPECT_EQ(result.status, 0) << result.err;
    }
    const Json plan = Json::parse(program_.read("plan/segments.json"));
    for (const Json& segment : plan["segments"]) {
        EXPECT_EQ(segment["bound_lsb"].is_null(), segment["kind"] == "spline");
    }
    const Json words = Json::parse(program_.read("words/words.json"));
    EXPECT_EQ(words["parameters"]["Anchor"], 0);
}

TEST_F(SplineCommands, NoSplinesAreForACoreWithout) {
    const ProgramResult result =
        program_.run({"run", "part.ngc", "-o", "out", "--set", "Splines=0"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "part.ngc:3: error: a spline, and the core has Splines=0\n");
    EXPECT_FALSE(program_.exists("out"));
}

}  // namespace curvecore::tb::spline_commands_test
