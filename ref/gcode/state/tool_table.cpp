// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/state/tool_table.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "ref/text/text_file.hpp"

namespace curvecore::ref {
namespace {

constexpr std::string_view kWords = "TPXYZABCUVWDIJQ";

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Reads the number of the word whose letter is at `at`, and moves behind it.
double read_number(std::string_view line, std::size_t& at, const Place& place) {
    const char letter = line[at++];
    const std::size_t begin = at < line.size() && line[at] == '+' ? at + 1 : at;
    while (at < line.size() && !is_blank(line[at])) ++at;
    double number = 0;
    const char* const end = line.data() + at;
    const auto read = std::from_chars(line.data() + begin, end, number);
    if (read.ec != std::errc() || read.ptr != end) {
        place.refuse(
            fmt::format("{}{} is no word of a tool table", letter, line.substr(begin, at - begin)));
    }
    return number;
}

}  // namespace

ToolTable::ToolTable(const std::string& file, double unit) : file_(file) {
    std::ifstream text = open_text_file(file);
    TextLines lines(text);
    while (const std::optional<std::string_view> whole = lines.next()) {
        const Place place{file, lines.number()};
        const std::string_view line = whole->substr(0, whole->find(';'));
        std::optional<int> tool;
        Point offset{};
        double diameter = 0;
        bool empty = true;
        for (std::size_t at = 0; at < line.size();) {
            if (is_blank(line[at])) {
                ++at;
                continue;
            }
            empty = false;
            const char letter =
                static_cast<char>(std::toupper(static_cast<unsigned char>(line[at])));
            if (kWords.find(letter) == std::string_view::npos) {
                place.refuse(fmt::format("'{}' is no word of a tool table ({})", line[at], kWords));
            }
            const double number = read_number(line, at, place);
            if (letter == 'T') tool = whole_number('T', number, 0, kLargestTool, place);
            if (letter == 'D') diameter = number * unit;
            const std::size_t axis = kAxisLetters.find(letter);
            if (axis == std::string_view::npos) continue;
            offset[axis] = number * (axis >= 3 && axis < 6 ? 1 : unit);
            if (!(std::abs(offset[axis]) <= kFarthest)) {
                place.refuse(fmt::format("{} is out of range", letter));
            }
        }
        if (empty) continue;
        if (!tool) place.refuse("a tool without its number (T)");
        if (!tools_.try_emplace(*tool, offset).second) {
            place.refuse(fmt::format("T{} for the second time", *tool));
        }
        diameters_[*tool] = diameter;
    }
}

const Point* ToolTable::find(int tool) const {
    const auto found = tools_.find(tool);
    return found == tools_.end() ? nullptr : &found->second;
}

double ToolTable::diameter(int tool) const {
    const auto found = diameters_.find(tool);
    return found == diameters_.end() ? 0 : found->second;
}

}  // namespace curvecore::ref
