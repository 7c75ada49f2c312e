// SPDX-License-Identifier: Apache-2.0
// Invalid programs and machine files are refused word for word: tb/cli/bad_input_cases.json.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "ref/machine/machine.hpp"
#include "ref/program/program_reader.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/programs/bad_input_case.hpp"

namespace curvecore::tb::bad_input_test {

using Json = nlohmann::json;

const std::string kCases = std::string(DATA_DIR) + "/../cli/bad_input_cases.json";

ref::PointsOptions points_options(const Json& bad) {
    ref::PointsOptions options;
    const auto name = std::find(ref::kFitNames.begin(), ref::kFitNames.end(),
                                bad.value("fit", std::string("bessel")));
    options.fit = static_cast<ref::Fit>(name - ref::kFitNames.begin());
    const auto ends = std::find(ref::kEndsNames.begin(), ref::kEndsNames.end(),
                                bad.value("ends", std::string("natural")));
    options.ends = static_cast<ref::Ends>(ends - ref::kEndsNames.begin());
    return options;
}

class BadInput : public testing::TestWithParam<Json> {};

TEST_P(BadInput, IsRefusedWithFileLineAndReason) {
    const Json& bad = GetParam();
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("bad_input_" + bad.at("name").get<std::string>() + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    const std::string file = write_bad_input(folder, bad);
    std::string expected = with_path(bad.at("stderr"), "FILE", file);
    std::string message = "nothing is wrong";
    try {
        if (bad.contains("machine")) {
            const std::string machine = write_bad_input(folder, bad["machine"]);
            expected = with_path(expected, "MACHINE", machine);
            ref::read_machine(machine);
        }
        ref::read_program(file, points_options(bad));
    } catch (const ref::InputError& error) {
        message = error.what();
    }
    std::filesystem::remove_all(folder);
    EXPECT_EQ(message, bad.value("stage", "") == "plan" ? "nothing is wrong" : expected);
}

INSTANTIATE_TEST_SUITE_P(Case, BadInput, testing::ValuesIn(bad_input_cases(kCases)),
                         [](const auto& tested) { return tested.param.at("name"); });

TEST(BadInputTable, HoldsAtLeastSixtyCases) { EXPECT_GE(bad_input_cases(kCases).size(), 60U); }

}  // namespace curvecore::tb::bad_input_test
