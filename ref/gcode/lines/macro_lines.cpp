// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/macro_lines.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace curvecore::ref {
namespace {

constexpr std::size_t kMostFigures = 9;

/// Returns true for the keyword with a number behind it, as "DO1" of "DO".
bool numbered(std::string_view text, std::string_view keyword) {
    return text.size() > keyword.size() && text.substr(0, keyword.size()) == keyword &&
           text.find_first_not_of(kDigits, keyword.size()) == std::string_view::npos;
}

}  // namespace

std::size_t begin_of_words(const std::string& words) {
    const std::size_t begin = words.rfind('/', 0) == 0 ? 1 : 0;
    if (begin == words.size() || words[begin] != 'N') return begin;
    return std::min(words.find_first_not_of(kDigits, begin + 1), words.size());
}

std::optional<int> number_of_line(const std::string& words) {
    const std::size_t end = begin_of_words(words);
    const std::size_t digits = words.find_first_of(kDigits);
    if (end < 2 || digits >= end || end - digits > kMostFigures) return std::nullopt;
    return std::atoi(words.substr(digits, end - digits).c_str());
}

std::string with_o_words(std::string words) {
    const std::size_t begin = begin_of_words(words);
    const std::string_view text = std::string_view(words).substr(begin);
    const auto loop = [](std::string_view number) { return "O<DO" + std::string(number) + ">"; };
    std::string replaced;
    if (numbered(text, "END")) {
        replaced = loop(text.substr(3)) + "ENDWHILE";
    } else if (numbered(text, "DO")) {
        replaced = loop(text.substr(2)) + "WHILE[1]";
    } else if (text.substr(0, 6) == "WHILE[") {
        const std::size_t last = text.rfind("]DO");
        if (last == std::string_view::npos || !numbered(text.substr(last + 1), "DO")) return words;
        replaced = loop(text.substr(last + 3)) + std::string(text.substr(0, last + 1));
    } else {
        return words;
    }
    return words.substr(0, begin) + replaced;
}

}  // namespace curvecore::ref
