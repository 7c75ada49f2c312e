// SPDX-License-Identifier: Apache-2.0
// `curvecore cam`: from a table of radii through the RTL to a surface, and its refusals.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/sample_cam.hpp"

namespace curvecore::tb::cam_test {

using Json = nlohmann::json;

std::string table_text(int n, double dx, int count) {
    std::string text = "x";
    for (int m = 0; m < n; ++m) text += fmt::format(",{:.10g}", 360. * m / n);
    for (const ref::CamSection& section : sample_cam_table(n, dx, count)) {
        text += fmt::format("\n{:g}", section.x);
        for (const double rho : section.rho) text += fmt::format(",{:.6f}", rho);
    }
    return text + "\n";
}

class CamCommand : public testing::Test {
  protected:
    ProgramResult run(std::vector<std::string> more) const {
        more.insert(more.begin(), {"cam", "cam.csv", "-o", "out"});
        return program_.run(more);
    }

    Json figures() const { return Json::parse(program_.read("out/cam.json")); }

    ProgramRun program_;
};

TEST_F(CamCommand, DrawsATableThroughTheRtl) {
    program_.write("cam.csv", table_text(24, 10, 4));
    program_.write("fine.csv", table_text(180, 1, 31));
    const ProgramResult result = run({"--kappa", "2", "--feed", "6m/min", "--against", "fine.csv",
                                      "--sample-period", "1ms", "--set", "AuxAxes=6"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("every check held"), std::string::npos);
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["board"], "rtl");
    const Json cam = figures();
    EXPECT_EQ(cam["sections"], 4);
    EXPECT_NEAR(cam["turns"].get<double>(), 3 + 2, 1e-6) << "three of helix, one on either end";
    EXPECT_LE(cam["worst_piece_mm"].get<double>(), 5e-3 * (1 + 1e-6));
    EXPECT_GT(cam["from_surface"]["of_allowed"].get<double>(), 0.9);
    EXPECT_LE(cam["from_surface"]["of_allowed"].get<double>(), 1);
    // The error of the table of 15 degrees, and that of the pieces on top of it.
    EXPECT_GT(cam["from_truth"]["max_mm"].get<double>(), 10e-3);
    EXPECT_LT(cam["from_truth"]["max_mm"].get<double>(), 30e-3);
    EXPECT_EQ(cam["pieces"].get<std::size_t>() + 1, report["moves"]);
    // The feed is constant except when starting and stopping: five turns of some 46 mm.
    EXPECT_NEAR(cam["duration_s"].get<double>(), 5 * 2 * M_PI * 46 / 100, 1.0);
    for (const char* file : {"cam.ngc", "cam.html", "report.html", "samples.csv"}) {
        EXPECT_TRUE(program_.exists(std::string("out/") + file)) << file;
    }
}

TEST_F(CamCommand, LeavesTheTurnsOutWhereAsked) {
    program_.write("cam.csv", table_text(24, 10, 4));
    const ProgramResult result = run({"--kappa", "2", "--feed", "6m/min", "--ends", "helix", "--on",
                                      "kernel", "--sample-period", "1ms"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NEAR(figures()["turns"].get<double>(), 3, 1e-6);
    EXPECT_EQ(figures()["ends"], "helix");
}

/// Samples stay within the jumps of such surfaces; the report shows the jumps' sizes.
TEST_F(CamCommand, ShowsTheJumpsOfTheSurface) {
    program_.write("cam.csv", table_text(48, 5, 5));
    for (const auto& [surface, least, most] :
         {std::tuple("tamm", 0.02, 0.2), std::tuple("blend", 1e-3, 8e-3),
          std::tuple("catmull-rom", -1.0, 1e-9)}) {
        const ProgramResult result = run({"--kappa", "1", "--surface", surface, "--feed", "6m/min",
                                          "--on", "kernel", "--sample-period", "1ms"});
        EXPECT_EQ(result.status, 0) << result.err;
        const Json cam = figures();
        EXPECT_EQ(cam["surface"], surface);
        EXPECT_GT(cam["jump_mm"]["on_path"].get<double>(), least) << surface;
        EXPECT_LT(cam["jump_mm"]["on_path"].get<double>(), most) << surface;
        EXPECT_LE(cam["from_surface"]["of_allowed"].get<double>(), 1) << surface;
    }
}

TEST_F(CamCommand, TakesTheHelixFromTheCutter) {
    program_.write("cam.csv", table_text(24, 1, 4));
    const ProgramResult result =
        run({"--scallop", "5um", "--cutter", "10mm", "--on", "kernel", "--sample-period", "1ms",
             "--feed", "6m/min", "--delta", "20um"});
    EXPECT_EQ(result.status, 0) << result.err;
    const Json cam = figures();
    EXPECT_LE(cam["scallop_mm"].get<double>(), 5e-3);
    EXPECT_GT(cam["scallop_mm"].get<double>(), 4.5e-3);
    EXPECT_NEAR(cam["pitch_mm"].get<double>(), 0.632, 0.02);
}

TEST_F(CamCommand, WarnsOfADeltaBelowTheTablesOwnError) {
    program_.write("cam.csv", table_text(24, 10, 8));
    const std::vector<std::string> common{"--kappa", "1",      "--feed",          "20m/min",
                                          "--on",    "kernel", "--sample-period", "1ms"};
    EXPECT_NE(run(common).err.find("cam.csv: warning: delta 5 um is below"), std::string::npos);
    std::vector<std::string> rough = common;
    rough.insert(rough.end(), {"--delta", "0.1mm"});
    EXPECT_EQ(run(rough).err, "");
}

struct BadCam {
    const char* name;
    std::string table;
    std::vector<std::string> options;
    const char* message;
};

void PrintTo(const BadCam& bad, std::ostream* out) { *out << bad.name; }

class BadCamInput : public testing::TestWithParam<BadCam> {};

TEST_P(BadCamInput, IsRefused) {
    const BadCam& bad = GetParam();
    const ProgramRun program;
    if (!bad.table.empty()) program.write("cam.csv", bad.table);
    std::vector<std::string> arguments{"cam", "cam.csv", "-o", "out"};
    arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
    const std::vector<std::string> before = program.files();
    const ProgramResult result = program.run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, std::string(bad.message) + "\n");
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(program.files(), before);
}

const char* const kHeader = "# cam\nx,0,90,180,270\n";
const std::vector<std::string> kHelix{"--kappa", "1"};

std::string with_rows(const std::string& rows) { return kHeader + rows; }

const BadCam kBad[] = {
    {"NoTable", "", kHelix, "cam.csv: error: no such file"},
    {"Empty", "# nothing\n\n", kHelix, "cam.csv: error: an empty table"},
    {"NoHeader", "0,40,40,40,40\n", kHelix,
     "cam.csv:1: error: a cam table begins with 'x,0,..' (angles in degrees), not '0'"},
    {"ThreeAngles", "x,0,120,240\n", kHelix,
     "cam.csv:1: error: 3 angles; the section's cubic goes through 4"},
    {"AngleIsNoNumber", "x,0,a,180,270\n", kHelix,
     "cam.csv:1: error: angle 2 = 'a' is not a number"},
    {"UnevenAngles", "x,0,90,170,270\n", kHelix,
     "cam.csv:1: error: angle 3 is 170, and 4 even angles from 0 want 180"},
    {"ClosedTwice", "x,0,90,180,270,360\n", kHelix,
     "cam.csv:1: error: the last angle is 360, which is 0 again: leave that column out"},
    {"OneSection", with_rows("0,40,40,40,40\n"), kHelix,
     "cam.csv:3: error: 1 section; a cam has at least 2"},
    {"NoSection", kHeader, kHelix, "cam.csv:2: error: 0 sections; a cam has at least 2"},
    {"Ragged", with_rows("0,40,40,40,40\n10,40,40,40\n"), kHelix,
     "cam.csv:4: error: 4 cells where line 2 has 5"},
    {"Repeated", with_rows("0,40,40,40,40\n10,40,40,40,40\n10,40,40,40,40\n"), kHelix,
     "cam.csv:5: error: x = 10 is the section of line 4 again"},
    {"Unsorted", with_rows("0,40,40,40,40\n10,40,40,40,40\n5,40,40,40,40\n"), kHelix,
     "cam.csv:5: error: x = 5 comes after 10: sections go up"},
    {"UnevenSections", with_rows("0,40,40,40,40\n10,40,40,40,40\n25,40,40,40,40\n"), kHelix,
     "cam.csv:5: error: x = 25, and sections every 10 mm want 20"},
    {"RadiusOfZero", with_rows("0,40,40,40,40\n10,40,0,40,40\n"), kHelix,
     "cam.csv:4: error: radius 2 is 0: a radius is above 0"},
    {"NegativeRadius", with_rows("0,40,40,-1,40\n"), kHelix,
     "cam.csv:3: error: radius 3 is -1: a radius is above 0"},
    {"RadiusIsNoNumber", with_rows("0,40,nan,40,40\n"), kHelix,
     "cam.csv:3: error: radius 2 = 'nan' is not a number"},
    {"RadiusTooLarge", with_rows("0,40,1e7,40,40\n"), kHelix,
     "cam.csv:3: error: radius 2 = 10000000 is out of range: beyond 1000000 mm"},
    {"TooSteep", with_rows("0,40,40,40,40\n0.001,40,9e5,40,40\n"), kHelix,
     "cam.csv:4: error: the surface is so steep before this section that points of 1e-06 mm do not "
     "keep delta 5 um"},
    {"HalfAnInterval",
     with_rows("0,40,40,40,40\n10,40,40,40,40\n"),
     {"--kappa", "0.25"},
     "curvecore: error: --kappa 0.25: kappa n / 2 = 0.25 x 4 / 2 = 0.5 must be a whole number "
     "above 0"},
    {"NoHelix",
     with_rows("0,40,40,40,40\n"),
     {},
     "curvecore: error: give the helix by --kappa N (half-turns per section) or by --scallop and "
     "--cutter"},
    {"NoCutter",
     with_rows("0,40,40,40,40\n"),
     {"--scallop", "5um"},
     "curvecore: error: --scallop wants the radius of the cutter: --cutter"},
    {"ScallopAboveCutter",
     with_rows("0,40,40,40,40\n"),
     {"--scallop", "5mm", "--cutter", "4mm"},
     "curvecore: error: --scallop must be lower than the cutter's radius"},
    {"NegativeKappa",
     with_rows("0,40,40,40,40\n"),
     {"--kappa", "-2"},
     "curvecore: error: --kappa must be above 0, up to 1e+06"},
    {"GeneratrixOfATensor",
     with_rows("0,40,40,40,40\n"),
     {"--kappa", "1", "--generatrix", "linear"},
     "curvecore: error: --generatrix is for --surface tamm and blend; lagrange has cubics"},
    {"UnknownSurface",
     with_rows("0,40,40,40,40\n"),
     {"--kappa", "1", "--surface", "flat"},
     "curvecore: error: --surface 'flat': must be one of tamm, blend, lagrange, catmull-rom"},
    {"UnknownEnds",
     with_rows("0,40,40,40,40\n"),
     {"--kappa", "1", "--ends", "none"},
     "curvecore: error: --ends 'none': must be one of turn, helix"},
    {"DeltaTooSmall",
     with_rows("0,40,40,40,40\n"),
     {"--kappa", "1", "--delta", "1nm"},
     "curvecore: error: --delta must be in [1e-05, 10] mm"},
    {"TooShortATruth",
     with_rows("0,40,40,40,40\n10,40,40,40,40\n20,40,40,40,40\n"),
     {"--kappa", "1", "--against", "short.csv"},
     "short.csv: error: no such file"},
};

INSTANTIATE_TEST_SUITE_P(Cli, BadCamInput, testing::ValuesIn(kBad),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace curvecore::tb::cam_test
