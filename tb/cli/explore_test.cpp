// SPDX-License-Identifier: Apache-2.0
// `curvecore explore`: its shortest queues do not starve in `run`, and shorter ones do.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::explore_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

class Explore : public testing::Test {
  protected:
    Json explore(const std::string& file, const Arguments& options, int status = 0) {
        Arguments arguments{"explore", file, "-o", "found"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, status) << result.err;
        table_ = result.out;
        return Json::parse(program_.read("found/explore.json"));
    }

    /// Runs the same system.
    Json run(const std::string& file, const Json& row, const Json& queues) {
        const auto text = [](const Json& value) { return value.dump(); };
        const auto seconds = [](const Json& value) { return value.dump() + "s"; };
        program_.run(
            {"run", file, "-q", "-o", "out", "--on", "systemc", "--system",
             "host=" + seconds(row["host_s"]), "--system", "word=" + seconds(row["word_s"]),
             "--sample-period", seconds(row["sample_period_s"]), "--segment-queue",
             text(queues["segment_queue"]), "--profile-queue", text(queues["profile_queue"])});
        return Json::parse(program_.read("out/report.json"));
    }

    /// Checks that every fate is that of `run`.
    void confirm(const std::string& file, const Json& found) {
        int fits = 0;
        int holds = 0;
        for (const Json& row : found["rows"]) {
            for (const Json& point : row["points"]) {
                if (point["fate"] != "fits" && point["fate"] != "holds") continue;
                const Json report = run(file, row, point);
                EXPECT_EQ(report["starved"] == 0, point["fate"] == "fits") << row << point;
                EXPECT_EQ(report["duration_s"], point["duration_s"]);
                ++(point["fate"] == "fits" ? fits : holds);
            }
        }
        EXPECT_GT(fits, 0);
        EXPECT_GT(holds, 0);
    }

    ProgramRun program_;
    std::string table_;
};

const Arguments kSweep{"--host",          "500ms,2s",  "--word",          "2us",
                       "--segment-queue", "1024,4096", "--profile-queue", "512,1024,4096"};

TEST_F(Explore, FindsWhatRunsOfTheDemoSee) {
    const Json found = explore(DATA_DIR "/demo.ngc", kSweep);
    ASSERT_EQ(found["rows"].size(), 2U);
    confirm(DATA_DIR "/demo.ngc", found);
    EXPECT_NE(table_.find("sample period  word     host"), std::string::npos) << table_;
    const std::string page = program_.read("found/explore.html");
    EXPECT_EQ(page.find("/*DATA*/"), std::string::npos);
    EXPECT_NE(page.find("\"title\":\"demo.ngc\""), std::string::npos);
    EXPECT_EQ(table_.substr(table_.rfind("report")), "report  found/explore.html\n");
}

/// Short lines and arcs at random.
TEST_F(Explore, FindsWhatRunsOfARandomProgramSee) {
    std::mt19937_64 engine(5);
    std::ostringstream text;
    text << "G21 G91 G17 G94 G64 P0.01 F3000\n";
    for (int move = 0; move < 100; ++move) {
        const double x = static_cast<double>(engine() % 400) / 100 - 2;
        const double y = static_cast<double>(engine() % 400) / 100 + 0.5;
        const char* const word = move % 3 == 0 ? "G2" : "G1";
        text << word << " X" << x << " Y" << (move % 2 == 0 ? y : -y);
        if (move % 3 == 0) text << " R" << std::hypot(x, y);
        text << "\n";
    }
    text << "M2\n";
    program_.write("random.ngc", text.str());
    confirm("random.ngc", explore("random.ngc", kSweep));
}

TEST_F(Explore, AnswersAreTheShortestThatFit) {
    const Json found = explore(DATA_DIR "/tilted.ngc", {"--word", "2us,500us"});
    int shorter = 0;
    for (const Json& row : found["rows"]) {
        if (row["answer"].is_null()) continue;
        const auto words = [](const Json& point) {
            return point["segment_queue"].get<int>() + point["profile_queue"].get<int>();
        };
        for (const Json& point : row["points"]) {
            if (words(point) >= words(row["answer"])) continue;
            EXPECT_NE(point["fate"], "fits") << row;
            ++shorter;
        }
    }
    EXPECT_GT(shorter, 2);
}

TEST_F(Explore, ALongerSamplePeriodIsPlannedAnew) {
    const Json found = explore(DATA_DIR "/pulses.ngc", {"--sample-period", "200us,100us", "--host",
                                                        "1ms", "--word", "1us"});
    ASSERT_EQ(found["rows"].size(), 2U);
    EXPECT_EQ(found["rows"][0]["sample_period_s"], 1e-4);
    EXPECT_EQ(found["rows"][1]["sample_period_s"], 2e-4);
    EXPECT_FALSE(found["rows"][1]["answer"].is_null());
}

TEST_F(Explore, SaysWhenNothingFits) {
    const Json found = explore(
        DATA_DIR "/demo.ngc",
        {"--host", "10s", "--word", "1us", "--segment-queue", "512", "--profile-queue", "256"}, 3);
    EXPECT_TRUE(found["rows"][0]["answer"].is_null());
}

TEST_F(Explore, RefusesWrongInput) {
    const auto refusal = [this](const Arguments& options) {
        Arguments arguments{"explore", DATA_DIR "/pulses.ngc", "-o", "found"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_FALSE(program_.exists("found"));
        return result.err;
    };
    EXPECT_EQ(refusal({"--segment-queue", "512,1000"}),
              "curvecore: error: --segment-queue must be a power of two in [64, 65536]\n");
    EXPECT_EQ(refusal({"--host", "1ms,fast"}),
              "curvecore: error: --system host 'fast': not a number\n");
    EXPECT_EQ(refusal({"--word", "1ms,2"}),
              "curvecore: error: --system word '2': the unit must be ns, us, ms or s\n");
    EXPECT_EQ(refusal({"--sample-period", "100us,2s"}),
              "curvecore: error: --sample-period must be in [10ns, 1s]\n");
    EXPECT_EQ(refusal({"--profile-queue", ""}),
              "curvecore: error: --profile-queue: a list is expected\n");
    program_.write("part.ngc", "G21 G90\nG1 X10\nM2\n");
    const ProgramResult result = program_.run({"explore", "part.ngc", "-o", "found"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.rfind("part.ngc:2: error: ", 0), 0U) << result.err;
}

}  // namespace curvecore::tb::explore_test
