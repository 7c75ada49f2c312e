// SPDX-License-Identifier: Apache-2.0
// Bad programs and machine files are refused word for word: tb/cli/bad_input_cases.json.
//
// A case is a program `file` (its `content`, or `base64` bytes, or a `folder`; none: the file is
// missing), sometimes a `machine` file, and the `stderr` that `curvecore plan` must give with FILE
// and MACHINE in place of their paths. Cases of the `stage` "plan" pass the readers.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ref/plan/machine.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/program/input_error.hpp"

namespace curvecore::tb {
namespace {

using Json = nlohmann::json;

std::vector<Json> cases() {
    std::ifstream stream(std::string(DATA_DIR) + "/../cli/bad_input_cases.json");
    return Json::parse(stream).get<std::vector<Json>>();
}

std::string decode_base64(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = letters.find(c);
        if (digit == std::string::npos) {
            break;
        }
        bits = bits << 6 | static_cast<unsigned>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 0xff);
        }
    }
    return bytes;
}

/// Writes a file of a case and returns its path.
std::string write(const std::filesystem::path& folder, const Json& file) {
    const std::filesystem::path path = folder / file.at("file").get<std::string>();
    if (file.contains("folder")) {
        std::filesystem::create_directory(path);
    } else if (file.contains("content") || file.contains("base64")) {
        std::ofstream(path, std::ios::binary)
            << (file.contains("content") ? file["content"].get<std::string>()
                                         : decode_base64(file["base64"]));
    }
    return path.string();
}

std::string with_path(std::string text, const std::string& name, const std::string& path) {
    return text.rfind(name + ":", 0) == 0 ? text.replace(0, name.size(), path) : text;
}

class BadInput : public testing::TestWithParam<Json> {};

TEST_P(BadInput, IsRefusedWithFileLineAndReason) {
    const Json& bad = GetParam();
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("bad_input_" + bad.at("name").get<std::string>() + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    const std::string file = write(folder, bad);
    std::string expected = with_path(bad.at("stderr"), "FILE", file);
    std::string message = "nothing is wrong";
    try {
        if (bad.contains("machine")) {
            const std::string machine = write(folder, bad["machine"]);
            expected = with_path(expected, "MACHINE", machine);
            ref::read_machine(machine);
        }
        ref::read_gcode(file);
    } catch (const ref::InputError& error) {
        message = error.what();
    }
    std::filesystem::remove_all(folder);
    EXPECT_EQ(message, bad.value("stage", "") == "plan" ? "nothing is wrong" : expected);
}

INSTANTIATE_TEST_SUITE_P(Case, BadInput, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.at("name"); });

TEST(BadInputTable, HoldsAtLeastSixtyCases) { EXPECT_GE(cases().size(), 60U); }

}  // namespace
}  // namespace curvecore::tb
