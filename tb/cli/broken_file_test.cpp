// SPDX-License-Identifier: Apache-2.0
// JSON files that a user gives, cut off at every place and with every value of another type: each
// refusal names the file, its line and the reason, and nothing is written.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::broken_file_test {

using Json = nlohmann::ordered_json;

struct Kind {
    const char* name;
    std::vector<std::string> arguments;  // that end with the option of the file
    std::string (*text)();
    std::size_t cuts;                 // places to cut it at
    std::vector<std::string> unread;  // keys whose values the program does not read
};

std::string core() {
    return Json{{"core", "spherical"},     {"build", "parallel"},
                {"device", "ecp5-25"},     {"parameters", {{"Order", 4}, {"CoefBits", 30}}},
                {"unit_mm", 1e-5},         {"error_mm", 2e-5},
                {"sample_period_s", 2e-4}, {"clock_hz", 5e7}}
               .dump(2) +
           "\n";
}

std::string board() {
    std::ifstream file(BOARDS "/colorlight_i5.json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string move() {
    const Json joint{
        {"position", {5, 0, 0}}, {"tangent", {1, 0, 0}}, {"curvature", {0, 0, 0}}, {"feed", 10}};
    Json end = joint;
    end["position"] = {20, 5, 0};
    return Json{{"curvecore_join", 1}, {"a", "part.ngc"},
                {"b", "next.ngc"},     {"start", joint},
                {"end", end},          {"fit", "quintic"},
                {"speed", "smooth"},   {"gcode", {{"form", "step"}, {"size_mm", 1}}},
                {"t", {0, 8, 16}},     {"points", {{12, 2, 0}}}}
               .dump(2) +
           "\n";
}

const std::vector<Kind> kKinds{
    {"Core", {"plan", "part.ngc", "-o", "out", "--core"}, core, 12, {}},
    {"Board",
     {"plan", "part.ngc", "-o", "out", "--board"},
     board,
     12,
     {"board", "part", "oscillator_hz", "baud", "pins", "loader", "where", "package", "speed"}},
    {"Join", {"join", "-o", "out", "--load"}, move, 12, {}},
};

class BrokenFile : public testing::TestWithParam<Kind> {
  protected:
    BrokenFile() {
        program_.write("part.ngc", "G21 G90 F600\nG1 X5\nM2\n");
        program_.write("next.ngc", "G21 G90 F600\nG0 X20 Y5\nG1 X25\nM2\n");
    }

    ProgramResult with(const std::string& text) {
        program_.write("file.json", text);
        std::vector<std::string> arguments = GetParam().arguments;
        arguments.insert(arguments.end(), {"file.json", "-q"});
        return program_.run(arguments);
    }

    void refused(const std::string& text, const std::string& what) {
        static const std::regex kMessage("file\\.json:[0-9]+: error: [^\\n]{8,}\n");
        const ProgramResult result = with(text);
        EXPECT_EQ(result.status, 2) << what;
        EXPECT_TRUE(std::regex_match(result.err, kMessage)) << what << ": " << result.err;
        EXPECT_EQ(result.err.find("json.exception"), std::string::npos) << result.err;
        EXPECT_FALSE(program_.exists("out")) << what;
    }

    ProgramRun program_;
};

TEST_P(BrokenFile, IsReadWhole) {
    const ProgramResult result = with(GetParam().text());
    EXPECT_EQ(result.status, 0) << result.err;
}

TEST_P(BrokenFile, CutOffIsRefusedWithItsLine) {
    const std::string text = GetParam().text();
    for (std::size_t cut = 0; cut < GetParam().cuts; ++cut) {
        const std::string part = text.substr(0, cut * (text.size() - 2) / GetParam().cuts);
        refused(part, part);
    }
}

TEST_P(BrokenFile, AValueOfAnotherTypeIsRefusedWithItsLine) {
    const Json whole = Json::parse(GetParam().text());
    const Json flat = whole.flatten();
    for (const auto& item : flat.items()) {
        const std::string& pointer = item.key();
        const auto read = [&](const std::string& key) {
            return pointer.find("/" + key) == std::string::npos;
        };
        const auto& unread = GetParam().unread;
        if (!std::all_of(unread.begin(), unread.end(), read)) continue;
        Json other = whole;
        other[Json::json_pointer(pointer)] = Json{{"surplus", true}};
        refused(other.dump(2), pointer);
    }
}

TEST_P(BrokenFile, AKeyThatNobodyReadsIsRefusedWithItsLine) {
    Json more = Json::parse(GetParam().text());
    more["colour"] = "red";
    refused(more.dump(2), "colour");
}

INSTANTIATE_TEST_SUITE_P(All, BrokenFile, testing::ValuesIn(kKinds),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace curvecore::tb::broken_file_test
