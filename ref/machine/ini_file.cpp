// SPDX-License-Identifier: Apache-2.0
#include "ref/machine/ini_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::ref {
namespace {

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string upper(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return result;
}

/// Cuts off the comment that may follow.
std::string_view without_comment(std::string_view text) {
    return trim(text.substr(0, text.find_first_of("#;")));
}

std::optional<double> number_in(std::string_view text) {
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    double number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = result.ec == std::errc() && result.ptr == text.data() + text.size();
    return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

IniFile::IniFile(std::string_view text, const std::string& file) : file_(file) {
    std::istringstream stream{std::string(text)};
    TextLines lines(stream);
    bool continued = false;
    while (const std::optional<std::string_view> line = lines.next()) {
        for (const char c : *line) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte < 0x20 && c != '\t') {
                throw InputError(file, lines.number(),
                                 fmt::format("byte 0x{:02x} is not text", byte));
            }
        }
        const std::string_view content = trim(*line);
        if (!continued) {
            read_line(content, lines.number());
        }
        continued = !content.empty() && content.back() == '\\';
    }
}

void IniFile::read_line(std::string_view line, int number) {
    if (upper(line.substr(0, 8)) == "#INCLUDE") {
        throw InputError(file_, number, "#INCLUDE is not supported: put the limits into this file");
    }
    if (line.empty() || line[0] == '#' || line[0] == ';') {
        return;
    }
    if (line[0] == '[') {
        const std::size_t end = line.find(']');
        if (end == std::string_view::npos) {
            throw InputError(file_, number, "a section without its closing bracket");
        }
        section_ = upper(trim(line.substr(1, end - 1)));
        sections_.insert(section_);
        return;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || equals == 0) {
        throw InputError(file_, number, "neither [SECTION] nor NAME = VALUE");
    }
    entries_[{section_, upper(trim(line.substr(0, equals)))}].push_back(
        {std::string(trim(line.substr(equals + 1))), number});
}

std::optional<IniEntry> IniFile::find(const std::string& section, const std::string& name) const {
    const auto found = entries_.find({section, name});
    if (found == entries_.end()) {
        return std::nullopt;
    }
    for (const IniEntry& entry : found->second) {
        if (entry.value != found->second.front().value) {
            throw InputError(file_, entry.line,
                             fmt::format("{} in [{}] differs from line {}", name, section,
                                         found->second.front().line));
        }
    }
    return found->second.front();
}

std::optional<double> IniFile::number(const std::string& section, const std::string& name) const {
    const std::optional<IniEntry> entry = find(section, name);
    if (!entry) {
        return std::nullopt;
    }
    const std::string_view text = without_comment(entry->value);
    if (text.empty()) {
        throw InputError(file_, entry->line, fmt::format("{} without a number", name));
    }
    const std::optional<double> number = number_in(text);
    if (!number) {
        throw InputError(file_, entry->line, fmt::format("{} = {} is not a number", name, text));
    }
    return number;
}

std::map<std::string, double> IniFile::numbers() const {
    std::map<std::string, double> found;
    for (const auto& [name, entries] : entries_) {
        const std::optional<double> number = number_in(without_comment(entries.front().value));
        if (number) found[fmt::format("[{}]{}", name.first, name.second)] = *number;
    }
    return found;
}

double mm_per_unit(const IniFile& ini) {
    const std::optional<IniEntry> units = ini.find("TRAJ", "LINEAR_UNITS");
    if (!units || units->value == "mm" || units->value == "metric") return 1;
    if (units->value == "inch" || units->value == "in" || units->value == "imperial") return 25.4;
    throw InputError(ini.file(), units->line,
                     fmt::format("LINEAR_UNITS = {}: mm or inch", units->value));
}

}  // namespace curvecore::ref
