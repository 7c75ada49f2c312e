// SPDX-License-Identifier: Apache-2.0
// `curvecore compare --scheme`: rows of the papers' schemes beside ours, in every file.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::compare_scheme_test {

using Json = nlohmann::json;
using testing::IsSubstring;
using Arguments = std::vector<std::string>;

/// The gentle spline of the papers' table, and a parabola of 0.3 mm radius, 20 mm deep.
constexpr char kTwo[] =
    "G21 G90 G17 G94 F1500\n"
    "G5 X40 Y20 I15 J0 P-10 Q-10\n"
    "G0 X-3.4641016 Y20\n"
    "M2\n";

class CompareScheme : public testing::Test {
  protected:
    ProgramResult compare(const Arguments& options) const {
        Arguments arguments{"compare", "-o", "out", "--samples", "1000"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return program_.run(arguments);
    }

    ProgramRun program_;
};

TEST_F(CompareScheme, ShowsBlowUpsAsResultsInAllThatIsWritten) {
    const ProgramResult result =
        compare({"--curves", "papers", "--scheme", "anchored,propagated,paper,rk4,scalar", "--tick",
                 "10ms", "--feed", "1.5m/min,2m/min"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "3 of 8 curves blow up", result.out);
    EXPECT_PRED_FORMAT2(IsSubstring, "\ngentle 2D ", result.out);
    const Json json = Json::parse(program_.read("out/compare.json"));
    ASSERT_EQ(json["rows"].size(), 10U);
    EXPECT_EQ(json["curves"][4], "hairpin 0.3");
    EXPECT_EQ(json["held"], true);
    const Json& anchored = json["rows"][0];
    EXPECT_EQ(anchored["scheme"], "anchored");
    EXPECT_LE(anchored["max_of_bound"], 1);
    const Json& runge_kutta = json["rows"][4];
    EXPECT_EQ(runge_kutta["scheme"], "rk4");
    EXPECT_EQ(runge_kutta["tick_s"], 0.01);
    EXPECT_EQ(runge_kutta["feed_mm_s"], 25);
    EXPECT_EQ(runge_kutta["blow_ups"], 3);
    EXPECT_FALSE(runge_kutta.contains("output"));
    EXPECT_NEAR(runge_kutta["by_curve_mm"][0].get<double>(), 1e-9, 0.05e-9);
    EXPECT_TRUE(runge_kutta["by_curve_mm"][6].is_null());
    const std::string csv = program_.read("out/compare.csv");
    EXPECT_PRED_FORMAT2(IsSubstring, ",rk4,0.01,25,3,1e-06\n", csv);
    EXPECT_PRED_FORMAT2(IsSubstring, "\"scheme\":\"rk4\"", program_.read("out/report.html"));
}

TEST_F(CompareScheme, TakesAProgramOfSplines) {
    program_.write("part.ngc", "G21 G90 G17 G94 F1500\nG5 X40 Y20 I15 J0 P-10 Q-10\nM2\n");
    const ProgramResult result =
        compare({"part.ngc", "--scheme", "rk4,scalar", "--tick", "10ms,1ms", "--feed", "90m/h"});
    EXPECT_EQ(result.status, 2) << "m/h is no unit of --feed";
    ASSERT_EQ(compare({"part.ngc", "--scheme", "rk4", "--tick", "10ms,1ms"}).status, 0);
    const Json rows = Json::parse(program_.read("out/compare.json"))["rows"];
    ASSERT_EQ(rows.size(), 4U);
    const auto worst = [&](std::size_t row) { return rows[row]["by_curve_mm"][0].get<double>(); };
    EXPECT_NEAR(worst(0), 1e-9, 0.05e-9);
    EXPECT_LT(worst(2), 1e-12) << "at a tenth of the tick";
    EXPECT_EQ(rows[0]["multiplier_bits"], 0);
}

TEST_F(CompareScheme, ThatDrawsNoArcsRefusesThem) {
    program_.write("part.ngc", kTwo);
    const ProgramResult result = compare({"part.ngc", "--scheme", "anchored,scalar"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "part.ngc:3: error: no spline, and --scheme scalar draws nothing else\n");
    EXPECT_FALSE(program_.exists("out"));
    EXPECT_EQ(compare({"part.ngc", "--scheme", "anchored,propagated", "-q"}).status, 0)
        << "these two draw whatever the core draws";
}

}  // namespace curvecore::tb::compare_scheme_test
