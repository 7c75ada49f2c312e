// SPDX-License-Identifier: Apache-2.0
// Programs with splines: planned, written as words, and refused by `run` while no core draws them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {
namespace {

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

TEST_F(SplineCommands, RunIsRefusedByLine) {
    const ProgramResult result = program_.run({"run", "part.ngc", "-o", "out"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err,
              "part.ngc:3: error: none of the compiled cores draws splines yet: plan and words "
              "take this program, run does not\n");
    EXPECT_FALSE(program_.exists("out"));
}

}  // namespace
}  // namespace curvecore::tb
