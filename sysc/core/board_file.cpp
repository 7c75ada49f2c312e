// SPDX-License-Identifier: Apache-2.0
#include "sysc/core/board_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <regex>

#include "ref/text/text_file.hpp"
#include "sysc/cli/shipped_files.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/formats/json_file.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kExtension = ".json";
/// Keys of a board's table (scripts/synthesis/boards.py); not all are read here.
constexpr std::array<std::string_view, 11> kBoardKeys{
    "board", "part",       "family", "device", "oscillator_hz", "clock_hz",
    "baud",  "parameters", "pins",   "loader", "where"};

/// Name of the file of a board of this name; a file's name is returned as given.
std::string file_of(const std::string& name) {
    if (fs::path(name).extension() == kExtension) return name;
    const fs::path folder = shipped_files().folder / "scripts/boards";
    const fs::path file = folder / (name + kExtension);
    std::error_code error;
    if (fs::exists(file, error)) return file.string();
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    throw UsageError(fmt::format("--board: there is no '{}': {}, or a file (.json)", name,
                                 fmt::join(names, ", ")));
}

/// Defaults of a module's parameters, for values that a board's file does not give.
std::map<std::string, int> defaults_of(const fs::path& module) {
    const std::string text = ref::read_text_file(module.string());
    static const std::regex kParameter(R"(parameter int (\w+)\s*=\s*(\d+))");
    std::map<std::string, int> values;
    for (std::sregex_iterator at(text.begin(), text.end(), kParameter), end; at != end; ++at) {
        values[(*at)[1]] = std::stoi((*at)[2]);
    }
    return values;
}

BoardFile board_of(const Json& json, std::map<std::string, int> values) {
    check_keys(json, kBoardKeys, "a board");
    for (const auto& [parameter, value] : member(json, "parameters").items()) {
        if (values.count(parameter) == 0) {
            throw JsonFlaw{parameter, "motion_board has no parameter " + parameter};
        }
        values[parameter] = whole_number(value, parameter);
    }
    if (values.at("Build") != 0 && values.at("Build") != 2) {
        throw JsonFlaw{"Build", "Build must be 0 (parallel) or 2 (engine)"};
    }
    BoardFile board;
    board.core.parameters = core_of_board(values);
    const std::string reason = ref::why_not_built(board.core.parameters);
    if (!reason.empty()) throw JsonFlaw{reason.substr(0, reason.find_first_of(" =")), reason};
    const double clock_hz = number(member(json, "clock_hz"), "clock_hz");
    if (!(clock_hz > 0)) throw JsonFlaw{"clock_hz", "clock_hz must be above 0"};
    board.device = device_of_board(json);
    board.core.clock_hz = clock_hz;
    board.core.sample_period_s = std::exp2(values.at("PeriodLog2")) / clock_hz;
    board.segment_queue_words = values.at("SegmentQueueWords");
    board.profile_queue_words = values.at("ProfileQueueWords");
    return board;
}

}  // namespace

std::string device_of_board(const Json& board) {
    if (!board.contains("device")) return "";
    const auto text = [](const Json& inside, const char* key) {
        const Json& value = member(inside, key, "device");
        if (!value.is_string()) throw JsonFlaw{key, fmt::format("'{}': not a text", key)};
        return value.get<std::string>();
    };
    const Json& device = board.at("device");
    const std::string family = text(board, "family");
    if (family == "ice40") return text(device, "size");
    std::string name = family == "ecp5" ? family + "-" + text(device, "size") : text(device, "die");
    while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) == 0) {
        name.pop_back();
    }
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return name;
}

CoreParameters core_of_board(const std::map<std::string, int>& values) {
    CoreParameters core;
    core.build = static_cast<Build>(values.at("Build"));
    for (const auto& [parameter, value] : values) {
        const ref::Parameter* const row = ref::find_parameter(parameter);
        if (row != nullptr) core.*row->value = value;
    }
    return core;
}

BoardFile read_board_file(const std::string& name) {
    const std::string file = file_of(name);
    const std::map<std::string, int> defaults =
        defaults_of(shipped_files().folder / "rtl/motion_board.sv");
    return read_json(ref::read_text_file(file), file, "scripts/boards has such files",
                     [&](const Json& json) { return board_of(json, defaults); });
}

}  // namespace curvecore::sysc
