// SPDX-License-Identifier: Apache-2.0
// The file core.json: the answer of `choose` is planned, compared and exported with --core
// unchanged.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::core_file_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

constexpr char kPart[] = "G21 G90 G94 F600\nG1 X10\nG2 X20 Y10 I5 J5\nM2\n";
constexpr char kCore[] =
    R"({"core": "spherical", "build": "parallel", "parameters": {"Order": 4, "CoefBits": 30},
        "unit_mm": 1e-5, "error_mm": 2e-5, "sample_period_s": 2e-4, "clock_hz": 5e7})";

class Core : public testing::Test {
  protected:
    Core() {
        program_.write("part.ngc", kPart);
        program_.write("core.json", kCore);
    }

    Json report(Arguments options) {
        options.insert(options.begin(), {"plan", "part.ngc", "-q", "-o", "out"});
        const ProgramResult result = program_.run(options);
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(program_.read("out/report.json"));
    }

    std::string refusal(const std::string& core) {
        program_.write("core.json", core);
        const ProgramResult result = program_.run({"plan", "part.ngc", "--core", "core.json"});
        EXPECT_EQ(result.status, 2);
        EXPECT_FALSE(program_.exists("part.ngc.out"));
        return result.err;
    }

    ProgramRun program_;
};

TEST_F(Core, IsPlannedAsItIsChosen) {
    const ProgramResult chosen =
        program_.run({"choose", "--error", "1um", "--radius", "300mm", "--feed", "10m/min",
                      "--device", "up5k", "-q", "-o", "answer"});
    ASSERT_EQ(chosen.status, 0) << chosen.err;
    const Json core = Json::parse(program_.read("answer/core.json"));
    const Json planned = report({"--core", "answer/core.json"});
    EXPECT_EQ(planned["parameters"], core["parameters"]);
    EXPECT_EQ(planned["build"], core["build"]);
    EXPECT_EQ(planned["unit_mm"], core["unit_mm"]);
    EXPECT_EQ(planned["sample_period_s"], core["sample_period_s"]);
    EXPECT_EQ(planned["clock_hz"], core["clock_hz"]);
    const double bound = planned["unrounded"]["bound_lsb"];
    EXPECT_LE((bound + 0.5) * core["unit_mm"].get<double>(), core["error_mm"].get<double>());

    const ProgramResult compared = program_.run(
        {"compare", "part.ngc", "--core", "answer/core.json", "--samples", "500", "-q"});
    EXPECT_EQ(compared.status, 0) << compared.err;
    const Json comparison = Json::parse(program_.read("part.ngc.out/compare.json"));
    const Json& rows = comparison["rows"];
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0]["coef_bits"], core["parameters"]["CoefBits"]);
    EXPECT_EQ(comparison["limit"], 0.5) << "1 um in units of 1 um, less the rounding";

    EXPECT_EQ(program_.run({"words", "part.ngc", "--core", "answer/core.json", "-q"}).status, 0);
    EXPECT_EQ(Json::parse(program_.read("part.ngc.out/words.json"))["parameters"],
              core["parameters"]);
}

TEST_F(Core, GivesWayToOptions) {
    const Json plain = report({"--core", "core.json"});
    EXPECT_EQ(plain["parameters"]["Order"], 4);
    EXPECT_EQ(plain["parameters"]["GuardBits"], 10) << "the default";
    EXPECT_EQ(plain["unit_mm"], 1e-5);
    EXPECT_EQ(plain["clock_hz"], 5e7);
    const Json other =
        report({"--core", "core.json", "--set", "Order=5", "--unit", "1nm", "--error", "2nm",
                "--clock", "20MHz", "--sample-period", "50us", "--build", "serial"});
    EXPECT_EQ(other["parameters"]["Order"], 5);
    EXPECT_EQ(other["parameters"]["CoefBits"], 30);
    EXPECT_EQ(other["unit_mm"], 1e-6);
    EXPECT_EQ(other["clock_hz"], 2e7);
    EXPECT_EQ(other["sample_period_s"], 5e-5);
    EXPECT_EQ(other["build"], "serial");
}

TEST_F(Core, DrawsNoSplinesThatItHasNot) {
    program_.write("part.ngc", "G21 G90 G17 G94 F1200\nG5 X20 Y10 I5 J0 P0 Q-5\nM2\n");
    EXPECT_EQ(refusal(kCore), "part.ngc:2: error: a spline, and the core has Splines=0\n");
}

TEST_F(Core, IsRefusedWithAReason) {
    EXPECT_EQ(program_.run({"plan", "part.ngc", "--core", "none.json"}).err,
              "none.json: error: no such file\n");
    EXPECT_EQ(refusal("Order=6"),
              "core.json:1: error: column 1: is no JSON here; curvecore choose -o writes a core\n");
    EXPECT_EQ(refusal("{}"), "core.json:1: error: 'parameters' is missing\n");
    EXPECT_EQ(refusal("{\"parameters\":\n{\"Order\": \"six\"}}"),
              "core.json:2: error: 'Order': not a number\n");
    EXPECT_EQ(refusal(R"({"parameters": {"Order": 5.5}})"),
              "core.json:1: error: 'Order': 5.5 is no whole number\n");
    EXPECT_EQ(refusal(R"({"parameters": {"Width": 6}})")
                  .rfind("core.json:1: error: Width is no parameter: there are Order, ", 0),
              0U);
    EXPECT_EQ(refusal(R"({"parameters": {}, "clok_hz": 1e6})")
                  .rfind("core.json:1: error: 'clok_hz': a core has core, build, ", 0),
              0U);
    EXPECT_EQ(refusal(R"({"parameters": {"Order": 13}})"),
              "core.json:1: error: Order must be in [2, 12]\n");
    EXPECT_EQ(refusal(R"({"build": "serial", "parameters": {"Splines": 1, "Anchor": 0}})"),
              "core.json:1: error: Anchor=0 works with --build parallel and Splines=1 only\n");
    EXPECT_EQ(refusal(R"({"build": "folded", "parameters": {}})"),
              "core.json:1: error: build must be one of parallel, serial, engine\n");
    EXPECT_EQ(refusal(R"({"parameters": {}, "unit_mm": 0})"),
              "core.json:1: error: unit_mm must be above 0\n");
}

}  // namespace curvecore::tb::core_file_test
