// SPDX-License-Identifier: Apache-2.0
#include "ref/program/block.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr std::size_t kLongestLine = 4096;
constexpr double kLargestNumber = 1e9;
constexpr int kMostFigures = 100;  // no number so short leaves a double's range
constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

/// The line without comments and blanks, in upper case.
std::string strip(std::string_view text, const Place& place) {
    std::string words;
    bool comment = false;
    bool rest = false;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte < 0x20 && c != '\t') || byte == 0x7f) {
            place.refuse(fmt::format("byte 0x{:02x} is not text", byte));
        }
        if (rest) {
            continue;
        }
        if (comment) {
            if (c == '(') {
                place.refuse("a comment inside a comment");
            }
            comment = c != ')';
        } else if (c == '(') {
            comment = true;
        } else if (c == ';') {
            rest = true;
        } else if (byte >= 0x80) {
            place.refuse(fmt::format("byte 0x{:02x} outside a comment", byte));
        } else if (c != ' ' && c != '\t') {
            words += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
    }
    if (comment) {
        place.refuse("a comment without its closing parenthesis");
    }
    return words;
}

/// What stands where a word should begin.
[[noreturn]] void refuse_character(char c, const Place& place) {
    switch (c) {
        case '#':
            place.refuse("parameters (#) belong to LinuxCNC's interpreter: give plain numbers");
        case '[':
        case ']':
            place.refuse("expressions ([ ]) belong to LinuxCNC's interpreter: give plain numbers");
        case '@':
        case '^':
            place.refuse(fmt::format("polar coordinates ({}) are not supported", c));
        case '%':
            place.refuse("% must stand alone on its line");
        default:
            place.refuse(fmt::format("'{}' where a word should begin", c));
    }
}

/// Reads the number at words[at] and moves `at` behind it.
double read_number(char letter, const std::string& words, std::size_t& at, const Place& place) {
    const std::size_t begin = at;
    if (at < words.size() && (words[at] == '+' || words[at] == '-')) {
        ++at;
    }
    const std::size_t digits = at;
    int points = 0;
    int figures = 0;
    for (; at < words.size() && (is_digit(words[at]) || words[at] == '.'); ++at) {
        (words[at] == '.' ? points : figures) += 1;
    }
    if (points > 1) {
        place.refuse(fmt::format("{}{} is not a number", letter, words.substr(begin, at - begin)));
    }
    if (figures == 0) {
        if (at < words.size() && (words[at] == '#' || words[at] == '[')) {
            refuse_character(words[at], place);
        }
        const std::size_t name_end = words.find_first_not_of(kAlphabet, at);
        if (name_end != std::string::npos && name_end > at && words[name_end] == '[') {
            refuse_character('[', place);  // a function, as in XSIN[30]
        }
        place.refuse(fmt::format("{} without a number", letter));
    }
    double number = 0;
    std::from_chars(words.data() + digits, words.data() + at, number, std::chars_format::fixed);
    if (figures > kMostFigures || number > kLargestNumber) {
        place.refuse(fmt::format("the number of {} is out of range", letter));
    }
    return words[begin] == '-' ? -number : number;
}

/// Codes are whole numbers, or tenths for G.
int code_of(char letter, double number, const Place& place) {
    const double scaled = letter == 'G' ? number * 10 : number;
    if (number < 0 || number > 999 || std::abs(scaled - std::round(scaled)) > 1e-6) {
        place.refuse(fmt::format("{}{:.10g} is not a code", letter, number));
    }
    return static_cast<int>(std::lround(scaled));
}

}  // namespace

Block::Block(std::string_view text, const Place& place) {
    if (text.size() > kLongestLine) {
        place.refuse(fmt::format("the line is longer than {} characters", kLongestLine));
    }
    const std::string words = strip(text, place);
    if (words == "%") {
        percent = true;
        return;
    }
    std::size_t at = !words.empty() && words[0] == '/' ? 1 : 0;
    while (at < words.size()) {
        const char letter = words[at];
        if (!is_letter(letter)) {
            refuse_character(letter, place);
        }
        if (letter == 'O') {
            place.refuse("subroutines and O-words belong to LinuxCNC's interpreter");
        }
        if (letter == 'E') {
            place.refuse("unknown word E (numbers have no exponent; an extruder may be A)");
        }
        ++at;
        add_word(letter, read_number(letter, words, at, place), place);
    }
}

void Block::add_word(char letter, double number, const Place& place) {
    if (letter == 'G') {
        g.push_back(code_of(letter, number, place));
        return;
    }
    if (letter == 'M') {
        m.push_back(code_of(letter, number, place));
        return;
    }
    if (has(letter)) {
        place.refuse(fmt::format("{} twice in one block", letter));
    }
    if (letter == 'N') {
        used_.set('N' - 'A');  // line numbers are for people
    }
    given_.set(letter - 'A');
    value_[letter - 'A'] = number;
}

bool Block::has_any(std::string_view letters) const {
    for (const char letter : letters) {
        if (has(letter)) {
            return true;
        }
    }
    return false;
}

double Block::use(char letter) {
    used_.set(letter - 'A');
    return value_[letter - 'A'];
}

char Block::unused() const {
    const std::bitset<26> left = given_ & ~used_;
    for (int i = 0; i < 26; ++i) {
        if (left[i]) {
            return static_cast<char>('A' + i);
        }
    }
    return 0;
}

int whole_number(char letter, double value, int least, int most, const Place& place) {
    if (value < least || value > most || std::floor(value) != value) {
        place.refuse(fmt::format("{} must be a whole number from {} to {}, not {:g}", letter, least,
                                 most, value));
    }
    return static_cast<int>(value);
}

std::string g_name(int tenths) {
    return tenths % 10 == 0 ? fmt::format("G{}", tenths / 10)
                            : fmt::format("G{}.{}", tenths / 10, tenths % 10);
}

}  // namespace curvecore::ref
