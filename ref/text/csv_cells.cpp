// SPDX-License-Identifier: Apache-2.0
#include "ref/text/csv_cells.hpp"

#include <algorithm>
#include <charconv>

namespace curvecore::ref {
namespace {

constexpr std::size_t kShownCharacters = 20;
constexpr std::string_view kBlanks = " \t";

}  // namespace

std::string_view trim(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        cells.push_back(trim(line.substr(begin, end - begin)));
        begin = end + 1;
    }
    return cells;
}

std::vector<std::string_view> columns_of(std::string_view line) {
    for (const char separator : {',', ';'}) {
        if (line.find(separator) != std::string_view::npos) return cells_of(line, separator);
    }
    std::vector<std::string_view> cells;
    for (std::size_t begin = line.find_first_not_of(kBlanks); begin < line.size();) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
        cells.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBlanks, end);
    }
    return cells;
}

std::string shown(std::string_view cell) {
    std::string text(cell.substr(0, kShownCharacters));
    for (char& c : text) {
        if (c < 0x20 || c > 0x7e) c = '?';
    }
    return cell.size() > kShownCharacters ? text + ".." : text;
}

std::optional<double> cell_number(std::string_view cell) {
    if (!cell.empty() && cell[0] == '+') cell.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
    return value;
}

}  // namespace curvecore::ref
