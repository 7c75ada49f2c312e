// SPDX-License-Identifier: Apache-2.0
// `curvecore words`: the memory files for $readmemh contain the plan.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::words_test {

using Json = nlohmann::json;

/// Words of a memory file: hexadecimal digits, comments from // to the end of the line.
std::vector<std::string> memory(const std::string& text) {
    std::istringstream lines(text);
    std::vector<std::string> words;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream rest(line.substr(0, line.find("//")));
        for (std::string word; rest >> word;) words.push_back(word);
    }
    return words;
}

class Words : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Words, AreThoseOfThePlan) {
    const ProgramRun program;
    program.write("part.ngc",
                  "G21 G90 F900\nG1 X5 A3\nG3 X7 Y2 I0 J2 A1\nG5 X9 Y6 I0 J3 P-2 Q0\nM2\n");
    for (const char* command : {"words", "plan"}) {
        std::vector<std::string> arguments{command, "part.ngc", "-q", "-o", command};
        arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
        const ProgramResult result = program.run(arguments);
        ASSERT_EQ(result.status, 0) << result.err;
    }
    const Json json = Json::parse(program.read("words/words.json"));
    const Json plan = Json::parse(program.read("plan/segments.json"));
    std::vector<std::string> planned;
    for (const Json& segment : plan["segments"]) {
        for (const Json& word : segment["words"]) planned.push_back(word);
    }
    const std::vector<std::string> segments = memory(program.read("words/segments.hex"));
    const std::vector<std::string> profile = memory(program.read("words/profile.hex"));
    const std::size_t each = json["segments"]["words_each"];
    EXPECT_EQ(segments, planned);
    EXPECT_EQ(segments.size(), json["segments"]["count"].get<std::size_t>() * each);
    EXPECT_EQ(segments.size(), json["segments"]["words"]);
    EXPECT_EQ(profile.size(), json["profile"]["words"]);
    const double unit = json["unit_mm"];
    const double mm = std::ldexp(json["path_quanta"].get<double>(), -16) * unit;
    const auto bits = 48.0 * static_cast<double>(segments.size() + profile.size());
    EXPECT_NEAR(json["bits_per_mm"].get<double>(), bits / mm, 1e-6 * bits / mm);
    for (const std::string& word : segments) EXPECT_EQ(word.size(), 12u);

    // Lengths of segments and of pieces sum to the path; only the last piece is final.
    const auto value = [](const std::string& word) { return std::stoull(word, nullptr, 16); };
    constexpr std::uint64_t kField = (std::uint64_t{1} << 44) - 1;  // the tag is above
    std::uint64_t path = 0;
    for (std::size_t i = 0; i < segments.size(); i += each) {
        path += value(segments[i]) & kField;
    }
    std::uint64_t travelled = 0;
    std::size_t pieces = 0;
    std::size_t branches = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const std::uint64_t tag = value(profile[i]) >> 44;
        if (tag == 8) {
            EXPECT_EQ((value(profile[i]) >> 31) & 1, i + 5 == profile.size() ? 1u : 0u);
        }
        if (tag == 9) travelled += value(profile[i]) & kField;
        pieces += tag == 8 ? 1 : 0;
        branches += tag == 13 ? 1 : 0;
    }
    EXPECT_EQ(pieces, json["profile"]["count"]);
    EXPECT_EQ(branches, json["profile"]["branches"]);
    EXPECT_GT(branches, 0u);
    EXPECT_EQ(path, json["path_quanta"]);
    EXPECT_EQ(travelled, path);
}

INSTANTIATE_TEST_SUITE_P(
    Configurations, Words,
    testing::Values(std::vector<std::string>{}, std::vector<std::string>{"--set", "AuxAxes=6"},
                    std::vector<std::string>{"--set", "CoefBits=30", "--set", "GuardBits=7"},
                    std::vector<std::string>{"--unit", "1um", "--set", "CoefBits=24", "--set",
                                             "PositionBits=20"}),
    [](const auto& tested) { return name_of(tested.param); });

/// The queues hold enough for a stop; PlannedBranches of tb/model checks how much.
TEST(WordsOfShortQueues, AreFewer) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 F30000\nG1 X50\nG3 X50 Y20 I0 J10\nG1 X0\nM2\n");
    const auto words = [&](const std::string& queue) {
        const ProgramResult result =
            program.run({"words", "part.ngc", "-q", "-o", queue, "--profile-queue", queue});
        EXPECT_EQ(result.status, 0) << result.err;
        const Json json = Json::parse(program.read(queue + "/words.json"));
        EXPECT_EQ(json["queue_words"]["profile"], std::stoi(queue));
        return json;
    };
    const Json few = words("256");
    const Json many = words("4096");
    EXPECT_LT(few["profile"]["words"], many["profile"]["words"]);
    EXPECT_GE(few["samples"], many["samples"]);
}

/// Digest by FNV-1a, 64 bits.
std::uint64_t digest(const std::vector<std::string>& words) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::string& word : words) {
        for (const char c : word) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    }
    return hash;
}

TEST(ProfileWords, OfStopBranchesAreLeftOutOnDemand) {
    const ProgramRun program;
    program.write("part.ngc", "G21 G90 F9000\nG1 X50\nG3 X50 Y20 I0 J10\nM2\n");
    const auto profile = [&](const char* holds) {
        const ProgramResult result =
            program.run({"words", "part.ngc", "-q", "-o", holds, "--holds", holds});
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(program.read(std::string(holds) + "/words.json"))["profile"];
    };
    const Json with = profile("branches");
    const Json without = profile("bounds");
    EXPECT_GT(with["branches"], 10);
    EXPECT_EQ(without["branches"], 0);
    EXPECT_EQ(without["words"], 5 * without["count"].get<int>());
    EXPECT_LT(3 * without["words"].get<int>(), with["words"].get<int>());
    const ProgramResult refused = program.run({"words", "part.ngc", "--holds", "never"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("--holds"), std::string::npos) << refused.err;
}

// A driver depends on these words. A change of their format increments hls::kWordsVersion; a change
// of the plan alone updates the digests here.
TEST(WordsOfTheDemo, AreThoseOfTheirVersion) {
    const ProgramRun program;
    const ProgramResult result = program.run(
        {"words", std::string(DATA_DIR) + "/lines.ngc", "--path", "exact", "-q", "-o", "words"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(Json::parse(program.read("words/words.json"))["words_version"], 6);
    EXPECT_EQ(digest(memory(program.read("words/segments.hex"))), 11842910594935852400u);
    EXPECT_EQ(digest(memory(program.read("words/profile.hex"))), 9939064203233427678u);
}

}  // namespace curvecore::tb::words_test
