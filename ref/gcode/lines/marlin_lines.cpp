// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/marlin_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace curvecore::ref {
namespace {

constexpr double kFirstFeed = 1500;  // mm/min

bool holds(std::initializer_list<int> codes, int code) {
    return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// Returns true for codes at which the machine waits: heaters, empty queues, users, probes.
bool waits(char letter, int code) {
    return letter == 'T' || (letter == 'G' && !holds({10, 11}, code)) ||
           holds({0, 1, 109, 116, 190, 191, 226, 303, 400, 600}, code);
}

double number_of(const CodeWord& word, const Place& place) {
    char* end = nullptr;
    const double number = std::strtod(word.number.c_str(), &end);
    if (end != word.number.c_str() + word.number.size() || word.number.empty() ||
        !(std::abs(number) <= 1e9)) {
        place.refuse(fmt::format("{}{} is not a number", word.letter, word.number));
    }
    return number;
}

bool is_name(char c) { return (c >= 'A' && c <= 'Z') || c == '_'; }

std::string first_name(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    constexpr std::size_t kLongest = 40;
    return std::string(
        text.substr(begin, std::min(text.find_first_of(" \t;", begin) - begin, kLongest)));
}

/// Prints a number without an exponent.
std::string text_of(double number) { return fmt::format("{:.9f}", number); }

}  // namespace

void MarlinLines::read(std::string_view text, ProgramLine& line, const Place& place) {
    const std::string code = bare_code(text);
    if (code.size() > 1 && is_name(code[0]) && is_name(code[1])) {
        line.note = first_name(text);  // a firmware's own command, as START_PRINT
        line.waits = true;
        return;
    }
    std::vector<CodeWord> words = code_words(code);
    if (words.empty()) {
        if (!code.empty() && code[0] != '*' && code[0] != 'N' && code[0] != '/') {
            place.refuse(fmt::format("'{}' where a command should begin", code[0]));
        }
        return;
    }
    switch (words[0].letter) {
        case 'M':
            return read_m(std::move(words), line);
        case 'T':
            line.note = "T" + words[0].number;
            line.waits = true;
            return;
        case 'G':
            return read_g(std::move(words), line, place);
        default:
            line.words = moved(std::move(words), place);  // the motion in force
    }
}

void MarlinLines::read_m(std::vector<CodeWord> words, ProgramLine& line) {
    const int code = std::atoi(words[0].number.c_str());
    if (code == 82 || code == 83) e_relative_ = code == 83;
    if (holds({2, 3, 4, 5, 7, 8, 9, 30}, code)) {
        const auto other = [](const CodeWord& word) {
            return word.letter != 'S' || word.number.empty();
        };
        words.erase(std::remove_if(words.begin() + 1, words.end(), other), words.end());
        line.words = text_of(words);
        return;
    }
    line.note = "M" + words[0].number;
    line.waits = waits('M', code);
}

void MarlinLines::read_g(std::vector<CodeWord> words, ProgramLine& line, const Place& place) {
    const std::string number = words[0].number;
    const int code = std::atoi(number.c_str());
    const bool tenths = number.find('.') != std::string::npos;
    if (holds({10, 11, 12, 26, 27, 29, 30, 31, 32, 33, 34, 35, 42, 76, 80, 425}, code)) {
        line.note = "G" + number;
        line.waits = waits('G', code);
    } else if (tenths || holds({17, 18, 19, 53, 54, 55, 56, 57, 58, 59, 93, 94}, code)) {
        line.words = text_of(words);
    } else if (holds({0, 1, 2, 3, 5}, code)) {
        if (code == 0) words[0].number = "1";
        line.words = moved(std::move(words), place);
    } else if (code == 4) {
        line.words = dwell(words, place);
    } else if (code == 20 || code == 21) {
        unit_ = code == 20 ? 25.4 : 1;
        line.words = text_of(words);
    } else if (code == 28) {
        std::string axes;
        for (const CodeWord& word : words) {
            if (word.letter >= 'X' && word.letter <= 'Z') axes += std::string(1, word.letter) + "0";
        }
        line.words = "G28" + (axes.empty() ? "X0Y0Z0" : axes);
    } else if (code == 90 || code == 91) {
        relative_ = e_relative_ = code == 91;
        line.words = text_of(words);
    } else if (code == 92) {
        line.words = redefined(words, place);
    } else {
        place.refuse(
            fmt::format("G{} is not known of Marlin (--dialect linuxcnc, if the program "
                        "is not for a printer)",
                        number));
    }
}

double MarlinLines::extruder(const CodeWord& word, const Place& place) const {
    return number_of(word, place) * unit_;
}

std::string MarlinLines::moved(std::vector<CodeWord> words, const Place& place) {
    for (CodeWord& word : words) {
        if (word.letter == 'F') feed_given_ = true;
        if (word.letter != 'E') continue;
        const double before = e_;
        const double given = extruder(word, place);
        e_ = e_relative_ ? e_ + given : given;
        word = {'A', text_of(relative_ ? e_ - before : zero_ + e_)};
    }
    if (!feed_given_ && words.size() > 1) {
        feed_given_ = true;
        words.push_back({'F', text_of(kFirstFeed / unit_)});
    }
    return text_of(words);
}

std::string MarlinLines::redefined(const std::vector<CodeWord>& words, const Place& place) {
    std::vector<CodeWord> others;
    for (const CodeWord& word : words) {
        CodeWord named = word;
        if (named.number.empty()) named.number = "0";  // G92 XYZ
        if (word.letter != 'E') {
            others.push_back(named);
            continue;
        }
        const double given = extruder(named, place);
        zero_ += e_ - given;
        e_ = given;
    }
    if (words.size() == 1) {
        zero_ += e_;
        e_ = 0;
        return "G92X0Y0Z0";
    }
    return others.size() == 1 ? "" : text_of(others);
}

std::string MarlinLines::dwell(const std::vector<CodeWord>& words, const Place& place) {
    double seconds = 0;
    for (const CodeWord& word : words) {
        if (word.letter == 'S') seconds = number_of(word, place);
        if (word.letter == 'P') seconds = number_of(word, place) / 1000;
    }
    return "G4P" + text_of(seconds);
}

}  // namespace curvecore::ref
