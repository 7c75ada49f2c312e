// SPDX-License-Identifier: Apache-2.0
// `curvecore compare`: its files, and figures that would be wrong if kernel, plan or truth were.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::compare_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// Lines, an arc, a helix and two splines; A turns with the arc.
constexpr char kPart[] =
    "G21 G90 G17 G94 F1200\n"
    "G1 X10\n"
    "G5 X20 Y10 I5 J0 P0 Q-5\n"
    "G3 X10 Y20 I-10 J0 Z1 A20\n"
    "G5 X0 Y0 I-3 J2 P3 Q9\n"
    "M2\n";

class Compare : public testing::Test {
  protected:
    /// Runs compare; every check must hold.
    Json compare(const Arguments& options, const std::string& folder = "out") {
        Arguments arguments{"compare", "-q", "-o", folder};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "");
        return Json::parse(program_.read(folder + "/compare.json"));
    }

    /// Worst value of the first three axes.
    static double worst(const Json& row, const char* part) {
        double worst = 0;
        for (const char* axis : {"x", "y", "z"}) {
            worst = std::max(worst, row.at(part).at(axis).at("worst").get<double>());
        }
        return worst;
    }

    ProgramRun program_;
};

/// Blocks are counted; of Artix-7 there are no clocks.
TEST_F(Compare, KnowsNoClockWhereNothingIsPlaced) {
    program_.write("part.ngc", kPart);
    const Arguments options{"part.ngc",  "--device", "xc7a35t", "--build",        "serial",
                            "--samples", "200",      "--set",   "CoefBits=18,36", "--set",
                            "Order=6",   "--set",    "Mode=0"};
    const Json json = compare(options);
    EXPECT_EQ(json["estimate"]["lut"], "LUT6");
    EXPECT_EQ(json["rows"][0]["estimate"]["dsp"], 1);
    EXPECT_EQ(json["rows"][1]["estimate"]["dsp"], 5);
    EXPECT_EQ(json["rows"][1]["estimate"]["ram"], 5);
    for (const Json& row : json["rows"]) EXPECT_TRUE(row["estimate"]["mhz"].is_null());
    EXPECT_NE(program_.read("out/compare.csv").find(",5,5,,"), std::string::npos);
    Arguments table{"compare", "-o", "again"};
    table.insert(table.end(), options.begin(), options.end());
    const std::string text = program_.run(table).out;
    EXPECT_NE(text.find("~LUT6"), std::string::npos) << text;
    EXPECT_NE(text.find("cells of Yosys, not placed"), std::string::npos) << text;
}

/// The smallest configuration that keeps the error, in either build, on each device.
TEST_F(Compare, AnswersWhichConfigurationToTake) {
    program_.write("part.ngc", kPart);
    Arguments arguments{
        "part.ngc", "--samples", "500", "--error", "10nm", "--device", "ecp5-25,up5k,gw2a-18,hx8k"};
    const Json json = compare(arguments);
    ASSERT_EQ(json["answers"].size(), 4U);
    const auto parameters = [&](const Json& row, const Json& core) {
        return row["order"] == core["Order"] && row["coef_bits"] == core["CoefBits"] &&
               row["mode"] == core["Mode"];
    };
    for (const Json& answer : json["answers"]) {
        std::size_t keep = 0;
        for (const Json& row : json["rows"]) keep += row["bound"] <= 9.5 ? 1 : 0;
        EXPECT_EQ(answer["keep"], keep);
        EXPECT_GT(keep, 10U);
        EXPECT_LT(keep, json["rows"].size()) << "some rows do not";
        EXPECT_LE(answer["core"]["error_mm"], 10e-6);
        const auto& core = answer["core"]["parameters"];
        const auto row = std::find_if(json["rows"].begin(), json["rows"].end(),
                                      [&](const Json& one) { return parameters(one, core); });
        ASSERT_NE(row, json["rows"].end());
        EXPECT_LE((*row)["bound"], 9.5);
        EXPECT_EQ((*row)["limit"], 9.5);
        EXPECT_EQ(answer["core"]["build"], "serial") << "the smallest";
    }
    EXPECT_FALSE(program_.exists("out/core.json")) << "of one device alone";
    arguments.back() = "up5k";
    arguments.insert(arguments.end(), {"-o", "one"});
    arguments.insert(arguments.begin(), "compare");
    const ProgramResult result = program_.run(arguments);
    EXPECT_NE(result.out.find("\nup5k: take Order="), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(" configurations keep 10 nm, and this is the smallest\n"),
              std::string::npos);
    EXPECT_EQ(
        program_.run({"plan", "part.ngc", "--core", "one/core.json", "-q", "-o", "plan"}).status,
        0);
    // Nothing is fine enough; nothing of the parallel build fits.
    arguments = {"compare", "part.ngc", "--samples", "200",
                 "-o",      "none",     "--set",     "CoefBits=18,20"};
    EXPECT_NE(
        program_.run(arguments).out.find("ecp5-85: 0 of 12 configurations keep 0.6 nm: take "),
        std::string::npos);
    arguments = {"compare", "part.ngc", "--samples", "200",      "-o",       "none",
                 "--set",   "Order=8",  "--set",     "Mode=0",   "--set",    "CoefBits=36",
                 "--error", "10nm",     "--build",   "parallel", "--device", "ecp5-25"};
    EXPECT_NE(program_.run(arguments).out.find("and none of them fits: take a larger device\n"),
              std::string::npos)
        << program_.run(arguments).out;
}

/// The core whose size is compared is the one that core.json names.
TEST_F(Compare, AnswersWithACoreOfSplinesAloneWhereNothingElseIsDrawn) {
    const auto core = [this](const Arguments& options) {
        Arguments all{"--set",   "Order=6", "--set",    "CoefBits=24", "--set",     "Mode=0",
                      "--error", "1um",     "--device", "ecp5-85",     "--samples", "200"};
        all.insert(all.end(), options.begin(), options.end());
        compare(all);
        return Json::parse(program_.read("out/core.json"))["core"];
    };
    EXPECT_EQ(core({"--curves", "splines", "--build", "parallel"}), "spline");
    EXPECT_EQ(core({"--curves", "splines", "--build", "serial"}), "curve");
    EXPECT_EQ(core({"--curves", "all", "--build", "parallel"}), "curve");
    EXPECT_EQ(core({"--curves", "arcs", "--build", "parallel"}), "spherical");
}

TEST_F(Compare, WritesARowForEveryCombination) {
    program_.write("part.ngc", kPart);
    const Json json = compare({"part.ngc", "--set", "Order=4,6", "--set", "CoefBits=28:36:4",
                               "--set", "GuardBits=8,10", "--set", "Mode=0,1", "--set",
                               "Anchor=0,1", "--samples", "2000"});
    EXPECT_EQ(program_.files(), (Arguments{"out", "part.ngc"}));
    EXPECT_EQ(json["rows"].size(), 48U);
    EXPECT_EQ(json["finished"], json["asked"]);
    EXPECT_EQ(json["interrupted"], false);
    EXPECT_GT(json["samples"], 1990);
    for (const Json& row : json["rows"]) {
        EXPECT_EQ(row["landing"], 0);
        EXPECT_GT(row["segments"], 4);
        EXPECT_GE(row["steps"], row["segments"]);
        EXPECT_EQ(row["missing_bits"], 0);
        EXPECT_GT(worst(row, "output"), 0.4);
        for (const char* part : {"output", "unrounded"}) {
            for (const char* figure : {"x", "y", "z", "a", "along", "across"}) {
                const Json& errors = row[part][figure];
                EXPECT_GE(errors["worst"], errors["p999"]) << part << ' ' << figure;
                EXPECT_GE(errors["p999"], errors["rms"]) << part << ' ' << figure;
                EXPECT_GT(errors["rms"], 0) << part << ' ' << figure;
            }
        }
        if (row["anchor"] == 0) {
            EXPECT_TRUE(row["bound"].is_null());
            continue;
        }
        EXPECT_LE(worst(row, "unrounded"), row["bound"].get<double>());
        EXPECT_LE(row["max_of_bound"], 1);
        EXPECT_GT(row["max_of_bound"], 0.2);
        EXPECT_LE(row["bound"], row["limit"]);
        EXPECT_GT(row["bound_of_seen"], 1);
    }
    const std::string csv = program_.read("out/compare.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 49);
    const std::string page = program_.read("out/report.html");
    EXPECT_EQ(page.find("/*DATA*/"), std::string::npos);
    EXPECT_NE(page.find("\"title\":\"part.ngc\""), std::string::npos);
}

TEST_F(Compare, EstimatesWhatRowsCostOnADevice) {
    const auto rows = [this](const std::string& build, const std::string& interval) {
        return compare({"--curves", "arcs", "--set", "Order=6", "--set", "CoefBits=18,36", "--set",
                        "Mode=0", "--samples", "500", "--device", "ecp5-25", "--build", build,
                        "--set", "SampleInterval=" + interval});
    };
    const Json four = rows("parallel", "4")["rows"];
    EXPECT_EQ(four[0]["estimate"]["dsp"], 6);  // 3 axes, passes of 4 and 2, one block each
    EXPECT_EQ(four[1]["estimate"]["dsp"], 24);
    EXPECT_LT(four[0]["estimate"]["lut4"], four[1]["estimate"]["lut4"]);
    const Json one = rows("parallel", "1");
    EXPECT_EQ(one["rows"][1]["estimate"]["dsp"], 72);
    EXPECT_GT(one["rows"][1]["estimate"]["of_device"], 1);
    EXPECT_EQ(one["estimate"]["device"], "ecp5-25");
    EXPECT_EQ(rows("serial", "1")["rows"][1]["estimate"]["dsp"], 4);
}

TEST_F(Compare, SaysWhereNothingIsKnownOfADevice) {
    const auto printed = [this](const std::string& build) {
        return program_
            .run({"compare", "--curves", "arcs", "--set", "Order=6", "--set", "CoefBits=20",
                  "--set", "Mode=0", "--samples", "100", "--device", "gw2a-18", "--build", build,
                  "-o", build})
            .out;
    };
    const std::string parallel = printed("parallel");
    const std::string serial = printed("serial");
    EXPECT_NE(parallel.find("no estimates: no measured runs of the parallel build for gw2a-18"),
              std::string::npos)
        << parallel;
    EXPECT_EQ(serial.find("no estimates"), std::string::npos) << serial;
    EXPECT_NE(serial.find("~ estimated, serial build on gw2a-18"), std::string::npos) << serial;
}

TEST_F(Compare, ErrorFallsWithWidthToTheFloor) {
    const Json json = compare({"--set", "Order=8", "--set", "CoefBits=20:36:4", "--set", "Mode=0",
                               "--set", "GuardBits=12", "--samples", "4000"});
    const Json& rows = json["rows"];
    ASSERT_EQ(rows.size(), 5U);
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        // Four bits are worth a factor of 16, except for the doublings of the limit; the last two
        // rows have the requested limit, and are at the floor.
        EXPECT_GT(worst(rows[i], "unrounded"),
                  (i + 2 < rows.size() ? 6 : 0.99) * worst(rows[i + 1], "unrounded"));
        EXPECT_GE(rows[i]["limit"], rows[i + 1]["limit"]);
        EXPECT_LT(rows[i]["multiplier_bits"], rows[i + 1]["multiplier_bits"]);
    }
    EXPECT_GT(worst(rows[0], "output"), 20);
    EXPECT_FALSE(rows[0]["refused"].is_null());
    EXPECT_GT(rows[0]["limit"], 10);
    EXPECT_LE(rows[0]["segments"], json["most_segments"]);
    EXPECT_TRUE(rows[4]["refused"].is_null());
    EXPECT_EQ(rows[4]["limit"], 0.1);
    EXPECT_GT(worst(rows[4], "output"), 0.45);
    EXPECT_LT(worst(rows[4], "output"), 0.6);
    EXPECT_NEAR(rows[4]["output"]["x"]["rms"].get<double>(), 0.2887, 0.02);  // 1 / sqrt 12
}

TEST_F(Compare, AFineParameterNeedsFewerSegments) {
    const Json rows =
        compare({"--curves", "splines", "--set", "Order=4", "--set", "CoefBits=32", "--set",
                 "Mode=1", "--set", "ParameterGuard=0,4", "--samples", "4000"})["rows"];
    ASSERT_EQ(rows.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(rows[i]["parameter_guard"], 4 * i);
        EXPECT_LE(rows[i]["max_of_bound"], 1);
        EXPECT_EQ(rows[i]["landing"], 0);
        EXPECT_EQ(rows[i]["missing_bits"], 0);
    }
    EXPECT_LT(rows[1]["segments"], rows[0]["segments"]);
}

TEST_F(Compare, RefusalsSayWhy) {
    program_.write("part.ngc", kPart);
    const Json rows = compare({"part.ngc", "--set", "Order=6", "--set", "CoefBits=18", "--set",
                               "Mode=1", "--samples", "500"})["rows"];
    EXPECT_EQ(rows[0]["refused"].get<std::string>().rfind(
                  "line 3: this spline cannot stay within 0.1 units of the exact curve in ", 0),
              0U)
        << rows[0]["refused"];
}

TEST_F(Compare, HoldsTheBoundOfAxesFasterThanThePath) {
    const Json rows = compare({DATA_DIR "/aux_axes.ngc", "--set", "Order=3,6", "--set",
                               "CoefBits=18:24", "--samples", "2000"})["rows"];
    for (const Json& row : rows) {
        EXPECT_LE(row["max_of_bound"], 1) << row["coef_bits"];
        EXPECT_EQ(row["landing"], 0);
    }
}

TEST_F(Compare, PropagationIsWorseOnLongChains) {
    const Json rows =
        compare({"--curves", "splines", "--set", "Order=6", "--set", "CoefBits=36", "--set",
                 "Mode=0,1", "--set", "Anchor=1,0", "--samples", "4000"})["rows"];
    ASSERT_EQ(rows.size(), 4U);
    for (std::size_t i = 0; i < 4; i += 2) {
        EXPECT_EQ(rows[i]["anchor"], 1);
        EXPECT_EQ(rows[i + 1]["anchor"], 0);
        EXPECT_EQ(rows[i]["segments"], rows[i + 1]["segments"]);
        EXPECT_GT(worst(rows[i + 1], "unrounded"), 5 * worst(rows[i], "unrounded"));
        // The error is along the path.
        EXPECT_GT(rows[i + 1]["unrounded"]["along"]["worst"].get<double>(),
                  5 * rows[i + 1]["unrounded"]["across"]["worst"].get<double>());
    }
}

TEST_F(Compare, RangesFitTheirWordsAndShrinkWithTheOrder) {
    const Json rows = compare({"--set", "Order=8", "--set", "CoefBits=36", "--set", "Mode=0",
                               "--samples", "1000"})["rows"];
    const Json& ranges = rows[0]["ranges"];
    for (const auto& [curve, rows_of_table] : ranges.items()) {
        for (const auto& [name, row] : rows_of_table.items()) {
            for (std::size_t i = 0; i < row["low"].size(); ++i) {
                if (row["low"][i].is_null()) continue;
                EXPECT_GE(row["spare_bits"][i], 0) << curve << name << ' ' << i;
                EXPECT_GE(row["low"][i], -row["word"].get<double>()) << curve << name << ' ' << i;
                EXPECT_LT(row["high"][i], row["word"].get<double>()) << curve << name << ' ' << i;
            }
        }
    }
    const Json& spline = ranges["spline"];
    EXPECT_GE(spline["phi"]["low"][0], 1);
    EXPECT_LT(spline["phi"]["high"][0], 2);
    EXPECT_LE(spline["v"]["high"][0], 1);
    EXPECT_GT(spline["v"]["high"][0], 0.5);
    EXPECT_LT(spline["R"]["high"][0], -2.99);
    for (const auto& [curve, name] :
         {std::pair{"arc", "T"}, {"arc", "N"}, {"spline", "q"}, {"spline", "x"}}) {
        const Json& spare = ranges[curve][name]["spare_bits"];
        EXPECT_GT(spare[8].get<int>(), spare[2].get<int>() + 4) << name;
    }
}

TEST_F(Compare, ThreadsDoNotChangeTheRows) {
    const Arguments options{"--set", "Order=4,6", "--set", "CoefBits=24,36", "--samples", "3000"};
    EXPECT_EQ(compare(options)["rows"], compare(options, "again")["rows"]);
}

TEST_F(Compare, PrintsATableLineForEveryRow) {
    const ProgramResult result = program_.run(
        {"compare", "-o", "out", "--curves", "arcs", "--set", "Order=6", "--samples", "500"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "") << "the bar is for terminals";
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 10 + 2 + 1 + 2)
        << "an empty line and the answer";
    EXPECT_NE(result.out.find("planned for "), std::string::npos);
}

TEST_F(Compare, InterruptedKeepsFinishedRows) {
    const Arguments samples{"--samples", "1000000"};
    Arguments arguments{"compare", "-q",
                        "-o",      "out",
                        "--set",   "Order=6:12",
                        "--set",   "CoefBits=30:36",
                        "--set",   "GuardBits=6:12"};
    arguments.insert(arguments.end(), samples.begin(), samples.end());
    ProgramResult result;
    for (int wait_ms = 500; wait_ms <= 16000 && !program_.exists("out"); wait_ms *= 2) {
        result = program_.run(arguments, wait_ms);
        EXPECT_EQ(result.status, 130);
    }
    ASSERT_TRUE(program_.exists("out/compare.json"));
    EXPECT_EQ(program_.files(), Arguments{"out"});
    EXPECT_FALSE(program_.exists("out/core.json")) << "the rest may have a smaller one";
    const Json json = Json::parse(program_.read("out/compare.json"));
    EXPECT_EQ(json["answers"].size(), 0U);
    const int finished = json["finished"];
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_EQ(json["asked"], 7 * 7 * 7 * 2);
    EXPECT_EQ(json["rows"].size(), static_cast<std::size_t>(finished));
    EXPECT_GT(finished, 0);
    EXPECT_LT(finished, 7 * 7 * 7 * 2);
    EXPECT_EQ(result.err, "curvecore: interrupted: " + std::to_string(finished) +
                              " of 686 configurations are in out\n");
    const Json& row = json["rows"][0];
    Arguments alone;
    for (const auto& [field, name] : {std::pair{"order", "Order="},
                                      {"coef_bits", "CoefBits="},
                                      {"guard_bits", "GuardBits="},
                                      {"mode", "Mode="}}) {
        alone.insert(alone.end(), {"--set", name + row[field].dump()});
    }
    alone.insert(alone.end(), samples.begin(), samples.end());
    EXPECT_EQ(compare(alone, "whole")["rows"][0], row);
}

TEST_F(Compare, InterruptedAtOnceWritesNothing) {
    const ProgramResult result =
        program_.run({"compare", "-q", "-o", "out", "--samples", "10000000"}, 1000);
    EXPECT_EQ(result.status, 130);
    EXPECT_EQ(result.err, "curvecore: interrupted: no configuration is finished\n");
    EXPECT_EQ(program_.files(), Arguments{});
}

}  // namespace curvecore::tb::compare_test
