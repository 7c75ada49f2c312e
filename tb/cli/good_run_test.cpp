// SPDX-License-Identifier: Apache-2.0
// Good runs: the files they write, and options that must not change them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::good_run_test {

using Json = nlohmann::json;
using Files = std::vector<std::string>;

/// Lines, arcs in two planes, a helix, a dwell and a corner.
constexpr char kPart[] =
    "G21 G90 G17 G94 F1200\n"
    "G1 X4 Y1\n"
    "G3 X6 Y3 I0 J2\n"
    "G1 Y5\n"
    "G4 P0.01\n"
    "G2 X8 Y5 I1 J0 Z0.5\n"
    "G18 G3 X10 Z2.5 I0 K2\n"
    "G0 X0 Y0 Z0\n"
    "M2\n";

class GoodRun : public testing::Test {
  protected:
    void SetUp() override { program_.write("part.ngc", kPart); }

    /// Runs the part; every check must hold.
    Json report(std::vector<std::string> options = {}, const std::string& folder = "out") {
        std::vector<std::string> arguments{"run", "part.ngc", "-q", "-o", folder};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "");
        return Json::parse(program_.read(folder + "/report.json"));
    }

    Files rows(const std::string& folder = "out") const {
        std::istringstream text(program_.read(folder + "/samples.csv"));
        Files rows;
        for (std::string line; std::getline(text, line);) {
            if (line[0] != '#') rows.push_back(line);
        }
        return rows;
    }

    ProgramRun program_;
};

TEST_F(GoodRun, WritesEveryFile) {
    report();
    for (const char* name : {"samples.csv", "report.json", "segments.json", "report.html"}) {
        EXPECT_TRUE(program_.exists(std::string("out/") + name)) << name;
    }
    EXPECT_FALSE(program_.exists("out/waves.fst"));
    EXPECT_EQ(program_.files(), (Files{"out", "part.ngc"}));
}

/// The radii of the ends differ by 1.02 um, 0.1 degrees short of a turn: the given centre counts.
TEST_F(GoodRun, NearlyFullArcIsDrawnAboutItsCentre) {
    program_.write("part.ngc", "G21 G90 G61\nG0 X10 Y0\nG3 X10.001 Y-0.02 I-10 J0 F6000\nM2\n");
    const Json found = report({"--sample-period", "1ms"});
    EXPECT_EQ(found.at("deviation").at("max_mm"), 0);
    double worst = 0;
    int samples = 0;
    for (const std::string& row : rows()) {
        if (row[0] == 'k') continue;
        std::istringstream text(row);
        double cell[5];  // k, segment, s, x, y
        for (double& value : cell) {
            text >> value;
            text.ignore();
        }
        if (cell[1] == 0) continue;
        ++samples;
        worst = std::max(worst, std::abs(std::hypot(cell[3], cell[4]) - 10e6));
    }
    EXPECT_GT(samples, 500);
    EXPECT_GT(worst, 1000) << "nm: it ends where the program ends";
    EXPECT_LT(worst, 1021.1);
}

/// Axis A turns without end: words of 32 bits hold six turns at 1 nm (1 degree is 1 mm); limits are
/// checked across the whole turns that the words leave out, also by `plan` and `compare`.
TEST_F(GoodRun, RotaryAxisTurnsWithoutEnd) {
    program_.write("part.ngc",
                   "G21 G90 G94\nG1 X10 A2000 F300\nA-3000 F20000\nG64 G91\n"
                   "X1 A180\nX1 A180\nX1 A180\nG5 X10 I3 J3 P-3 Q3\nM2\n");
    report({"--on", "kernel", "--sample-period", "1ms"});
    for (const std::string& row : rows()) {
        if (row[0] == 'k') continue;
        std::int64_t cell[7];
        std::istringstream text(row);
        for (std::int64_t& value : cell) {
            text >> value;
            text.ignore();
        }
        ASSERT_LT(std::abs(cell[6]), std::int64_t(1) << 31) << row;
    }
    // -3000 + 540 = -2460 degrees are 6 turns and 300 degrees
    const std::string last = rows().back();
    EXPECT_EQ(last.substr(last.rfind(",-300000000") + 1, 10), "-300000000") << last;
    for (const char* command : {"plan", "compare"}) {
        const ProgramResult result = program_.run({command, "part.ngc", "-q", "-o", "more"});
        EXPECT_EQ(result.status, 0) << command << result.err;
    }
}

TEST_F(GoodRun, ReportHasEveryField) {
    const Json json = report();
    for (const char* name : {"input",
                             "unit_mm",
                             "sample_period_s",
                             "core",
                             "build",
                             "parameters",
                             "moves",
                             "segments",
                             "samples",
                             "clocks",
                             "clocks_per_sample",
                             "error",
                             "unrounded",
                             "landing_lsb",
                             "speed",
                             "limits",
                             "time_kept",
                             "rtl_equals_kernel",
                             "underruns",
                             "fault",
                             "duration_s",
                             "simulation_clocks_per_second"}) {
        EXPECT_TRUE(json.contains(name)) << name;
    }
    EXPECT_EQ(json["rtl_equals_kernel"], 0);
    EXPECT_EQ(json["landing_lsb"], 0);
    EXPECT_EQ(json["underruns"], 0);
    EXPECT_EQ(json["fault"], 0);
    EXPECT_EQ(json["stops"]["sampled"], json["stops"]["planned"]);
    EXPECT_LE(json["unrounded"]["max_of_bound"], 1);
    EXPECT_LE(json["speed"]["max_error_lsb"], 0.1);
    EXPECT_EQ(json["path_increment"]["max_error_quanta"], 0);
    for (const char* axis : {"x", "y", "z"}) {
        EXPECT_GT(json["error"]["max_lsb"][axis], 0.1);
        EXPECT_LE(json["error"]["max_lsb"][axis], 0.6);
        EXPECT_LE(json["unrounded"]["max_lsb"][axis], json["unrounded"]["bound_lsb"]);
    }
    for (const char* limit : {"velocity", "acceleration", "jerk"}) {
        EXPECT_GT(json["limits"][limit], 0);
        EXPECT_LE(json["limits"][limit], 1);
    }
}

TEST_F(GoodRun, SamplesBeginAtTheStartAndEndAtTheEnd) {
    const Json json = report();
    const Files all = rows();
    ASSERT_EQ(all.size(), json["samples"].get<std::size_t>() + 2);
    EXPECT_EQ(all[0], "k,segment,s,x,y,z");
    EXPECT_EQ(all[1], "0,0,0,0,0,0");
    EXPECT_EQ(all.back().substr(all.back().size() - 6), ",0,0,0");
}

TEST_F(GoodRun, WritesEveryNthRowOfManySamples) {
    report();
    const Files all = rows();
    const Json json = report({"--rows", "1000"}, "few");
    const Files few = rows("few");
    const std::size_t samples = json["samples"];
    const std::size_t stride = 1 + samples / 1000;
    ASSERT_GT(stride, 2U);
    ASSERT_EQ(few.size(), 3 + (samples - 1) / stride);  // header, first, ..., last
    for (std::size_t i = 1; i + 1 < few.size(); ++i) {
        ASSERT_EQ(few[i], all[1 + (i - 1) * stride]);
    }
    EXPECT_EQ(few.back(), all.back());
    EXPECT_EQ(json["error"], report()["error"]) << "all samples are checked";
}

TEST_F(GoodRun, StallsDoNotChangeTheSamples) {
    report();
    const std::string samples = program_.read("out/samples.csv");
    for (const char* seed : {"1", "2", "3"}) {
        const Json json = report({"--stall", seed}, "stalled");
        EXPECT_GT(json["clocks_per_sample"], 1.3) << "nothing stalled";
        EXPECT_TRUE(program_.read("stalled/samples.csv") == samples) << "seed " << seed;
    }
}

/// The serial build is a curve core alone: it is planned for, and the kernel draws it.
TEST_F(GoodRun, TheSerialBuildIsDrawnByTheKernelAlone) {
    const Json json = report({"--build", "serial", "--on", "kernel"});
    EXPECT_EQ(json["build"], "serial");
    report({"--on", "kernel"}, "parallel");
    EXPECT_EQ(rows("parallel"), rows());
}

TEST_F(GoodRun, OverrideIsSlowerOnTheSamePath) {
    const Json full = report();
    const Json half = report({"--override", "50"}, "half");
    EXPECT_NEAR(half["duration_s"].get<double>() / full["duration_s"].get<double>(), 2, 0.1);
    const auto path = [](const std::string& row) {
        std::istringstream text(row);
        std::string k, segment, s;
        std::getline(std::getline(std::getline(text, k, ','), segment, ','), s, ',');
        return segment + " " + s;
    };
    EXPECT_EQ(path(rows("half").back()), path(rows().back()));
}

TEST_F(GoodRun, SeveralSamplesShareATick) {
    const Json json = report({"--samples-per-tick", "8", "--sample-period", "25us"});
    EXPECT_EQ(json["samples"].get<std::uint64_t>() % 8, 0u);
    EXPECT_LE(json["path_increment"]["max_error_quanta"], 1);
}

TEST_F(GoodRun, EveryUnitHolds) {
    for (const char* unit : {"10nm", "0.1um", "1um"}) {
        const Json json = report({"--unit", unit}, unit);
        EXPECT_EQ(json["landing_lsb"], 0) << unit;
    }
}

TEST_F(GoodRun, TraceWritesWaveformAndItsArrangement) {
    report({"--trace", "--trace-clocks", "3000"});
    EXPECT_GT(std::filesystem::file_size(program_.folder() / "out/waves.fst"), 1000u);
    const std::string arrangement = program_.read("out/waves.gtkw");
    for (const char* group :
         {"-Request", "-Path generator", "-Lines and arcs", "-Sampler", "-Positions"}) {
        EXPECT_NE(arrangement.find(group), std::string::npos) << group;
    }
    report();
    EXPECT_FALSE(program_.exists("out/waves.fst")) << "left from the run before";
}

TEST_F(GoodRun, KeepsWhatElseIsInTheFolder) {
    std::filesystem::create_directory(program_.folder() / "out");
    program_.write("out/notes.txt", "mine");
    report();
    EXPECT_EQ(program_.read("out/notes.txt"), "mine");
}

TEST_F(GoodRun, BadInputKeepsAnOlderResult) {
    report();
    const std::string before = program_.read("out/report.json");
    program_.write("part.ngc", "G1 X1 F100\nG1 X2 X3\n");
    EXPECT_EQ(program_.run({"run", "part.ngc", "-o", "out"}).status, 2);
    EXPECT_EQ(program_.read("out/report.json"), before);
}

TEST_F(GoodRun, InterruptLeavesNothing) {
    program_.write("part.ngc", "G21 G90 F10\nG1 X900\nX-900\nM2\n");  // hours of samples
    const ProgramResult result = program_.run({"run", "part.ngc", "-o", "out"}, 5000);
    EXPECT_EQ(result.status, 130);
    EXPECT_EQ(program_.files(), Files{"part.ngc"});
}

TEST_F(GoodRun, MakesFoldersAbove) {
    report({}, "a/b/out");
    EXPECT_TRUE(program_.exists("a/b/out/report.html"));
}

TEST_F(GoodRun, ReportNeedsNoNetwork) {
    report();
    const std::string page = program_.read("out/report.html");
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_LT(page.size(), 5'000'000u);
}

TEST_F(GoodRun, SummaryNamesTheFigures) {
    const ProgramResult result = program_.run({"run", "part.ngc", "-o", "out"});
    for (const char* name : {"duration", "RTL = kernel", "worst error", "before rounding",
                             "landing", "clocks/sample", "of the limits", "every check held"}) {
        EXPECT_NE(result.out.find(name), std::string::npos) << name;
    }
    EXPECT_EQ(result.err, "") << "a progress bar off a terminal";
    EXPECT_EQ(result.out.substr(result.out.rfind("\nreport") + 1),
              "report                 out/report.html\n");
}

/// The plotted jerk is the one that is checked: its highest bin over its limit is the report's
/// ratio over that window.
TEST_F(GoodRun, JerkAndAccelerationAreDrawnAsTheyAreChecked) {
    program_.write("part.ngc",
                   "G21 G90 F6000 G64 P0.05\nG1 X20\nY15\nX35\nG3 X45 Y25 I0 J10\nM2\n");
    const Json ratios = report()["limits"]["windows"].back();
    const std::string page = program_.read("out/report.html");
    const std::size_t begin = page.find("const D = ") + 10;
    const Json data = Json::parse(page.substr(begin, page.find(";\n", begin) - begin));
    EXPECT_EQ(data["window"]["ms"], ratios["window_s"].get<double>() * 1e3);
    for (const auto& [bins, limit] : {std::pair("jerk", "jerk"), {"total", "acceleration"}}) {
        double most = 0;
        for (const Json& bin : data[bins]) {
            if (!bin.is_null()) most = std::max(most, bin[1].get<double>());
        }
        EXPECT_NEAR(most / data["window"][limit].get<double>(), ratios["path"][limit].get<double>(),
                    1e-3)
            << limit;
        EXPECT_GT(most, 0.3 * data["window"][limit].get<double>()) << "the picture is idle";
    }
}

/// The bar is shown on a terminal, and removed before the first line of the result.
TEST_F(GoodRun, BarIsGoneBeforeTheResult) {
    program_.write("part.ngc", "G21 G90 F60\nG1 X300\nM2\n");
    const ProgramRun shell("/bin/sh");
    shell.write("part.ngc", program_.read("part.ngc"));
    const ProgramResult result = shell.run(
        {"-c", "script -qec '" CURVECORE_PROGRAM " run part.ngc --on kernel -o out' typescript"});
    EXPECT_EQ(result.status, 0) << result.out;
    const std::string erased = "\r\033[K";
    const std::size_t core = result.out.find("core  ");
    ASSERT_NE(core, std::string::npos) << result.out;
    EXPECT_NE(result.out.find(" samples/s"), std::string::npos) << "no bar was shown";
    EXPECT_EQ(result.out.substr(core - erased.size(), erased.size()), erased) << result.out;
}

/// numpy's own reader finds the names and every row.
TEST_F(GoodRun, SamplesAreReadByNumpy) {
    const Json json = report();
    const ProgramRun shell("/bin/sh");
    const std::string file = (program_.folder() / "out/samples.csv").string();
    shell.write("read.py",
                "import numpy, sys\n"
                "file = sys.argv[1]\n"
                "call = next(line for line in open(file) if 'genfromtxt' in line)\n"
                "table = eval(call.lstrip('# '))\n"
                "print(*table.dtype.names, len(table), table['x'][0])\n");
    const ProgramResult result = shell.run({"-c", SYNTH_PYTHON " read.py " + file});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::size_t rows = json["samples"].get<std::size_t>() + 1;
    EXPECT_EQ(result.out, "k segment s x y z " + std::to_string(rows) + " 0.0\n");
}

TEST_F(GoodRun, PlanPredictsWithoutTheRtl) {
    const Json run = report();
    ASSERT_EQ(program_.run({"plan", "part.ngc", "-q", "-o", "plan"}).status, 0);
    const Json plan = Json::parse(program_.read("plan/report.json"));
    EXPECT_EQ(plan["samples"], run["samples"]);
    EXPECT_EQ(plan["duration_s"], run["duration_s"]);
    EXPECT_EQ(plan["unrounded"]["bound_lsb"], run["unrounded"]["bound_lsb"]);
    EXPECT_EQ(program_.read("plan/segments.json"), program_.read("out/segments.json"));
    EXPECT_FALSE(program_.exists("plan/samples.csv"));
}

TEST(Help, IsOnEveryCommand) {
    const ProgramRun program;
    for (const std::vector<std::string>& line : std::vector<std::vector<std::string>>{
             {"--help"}, {"run", "--help"}, {"plan", "--help"}, {"words", "--help"}}) {
        const ProgramResult result = program.run(line);
        EXPECT_EQ(result.status, 0);
        EXPECT_NE(result.out.find("Usage: curvecore"), std::string::npos) << result.out;
    }
    const ProgramResult version = program.run({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out.rfind("curvecore 0.", 0), 0u);
}

}  // namespace curvecore::tb::good_run_test
