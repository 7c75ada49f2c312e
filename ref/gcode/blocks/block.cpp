// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/gcode/blocks/value_reader.hpp"

namespace curvecore::ref {
namespace {

constexpr double kLargestNumber = 1e9;

/// Reports a character that cannot begin a word.
[[noreturn]] void refuse_character(char c, const Place& place) {
    switch (c) {
        case '%':
            place.refuse("% must stand alone on its line");
        default:
            place.refuse(fmt::format("'{}' where a word should begin", c));
    }
}

/// Returns a code, a whole number or, for G, tenths.
int code_of(char letter, double number, const Place& place) {
    const std::optional<int> code =
        letter == 'G' ? near_whole(number * 10, 1e-3) : near_whole(number);
    if (!code || *code < 0 || number > 999) {
        place.refuse(fmt::format("{}{:.10g} is not a code", letter, number));
    }
    return *code;
}

}  // namespace

Block::Block(const std::string& words, const Place& place, ProgramParameters& parameters) {
    ValueReader reader(words, parameters, place);
    reader.take("/");
    while (!reader.at_end()) {
        const char letter = reader.peek();
        if (letter == '#') {
            read_assignment(reader, parameters);
            continue;
        }
        if (letter == '@' || letter == '^') {
            std::optional<double>& polar = letter == '@' ? polar_radius : polar_angle;
            if (polar) place.refuse(fmt::format("{} twice in one block", letter));
            reader.skip();
            polar = reader.value(std::string(1, letter));
            continue;
        }
        if (!is_letter(letter)) refuse_character(letter, place);
        if (letter == 'O') place.refuse("an O-word begins its line");
        reader.skip();
        add_word(letter, reader.value(std::string(1, letter)), place);
    }
    assign(parameters, place);
}

void Block::read_assignment(ValueReader& reader, ProgramParameters& parameters) {
    reader.skip();
    Assignment assignment{0, "", 0};
    if (reader.peek() == '<') {
        assignment.name = reader.name();
        try {
            parameters.declare(assignment.name);
        } catch (const ParameterError& error) {
            reader.refuse(error.what());
        }
    } else {
        assignment.number = reader.whole_value("#");
    }
    if (!reader.take("=")) reader.refuse("a parameter that begins a word wants =, as in #1=5");
    assignment.value = reader.value("=");
    assignments_.push_back(assignment);
}

void Block::assign(ProgramParameters& parameters, const Place& place) const {
    try {
        for (const Assignment& assignment : assignments_) {
            if (assignment.name.empty()) {
                parameters.assign(assignment.number, assignment.value);
            } else {
                parameters.assign(assignment.name, assignment.value);
            }
        }
    } catch (const ParameterError& error) {
        place.refuse(error.what());
    }
}

void Block::add_word(char letter, double number, const Place& place) {
    if (!(std::abs(number) <= kLargestNumber)) {
        place.refuse(fmt::format("the number of {} is out of range", letter));
    }
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
        used_.set('N' - 'A');  // line numbers have no meaning
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

void Block::give(char letter, double number) {
    given_.set(letter - 'A');
    value_[letter - 'A'] = number;
}

double Block::take(char letter) {
    given_.reset(letter - 'A');
    return value_[letter - 'A'];
}

std::optional<int> Block::take_m(std::initializer_list<int> codes) {
    const auto found = std::find_first_of(m.begin(), m.end(), codes.begin(), codes.end());
    if (found == m.end()) return std::nullopt;
    const int code = *found;
    m.erase(found);
    return code;
}

bool Block::take_g(int code) {
    const auto found = std::find(g.begin(), g.end(), code);
    if (found == g.end()) return false;
    g.erase(found);
    return true;
}

void Block::check_all_used(const Place& place) const {
    const std::bitset<26> left = given_ & ~used_;
    for (int i = 0; i < 26; ++i) {
        if (!left[i]) continue;
        const char letter = static_cast<char>('A' + i);
        place.refuse(fmt::format("{} has no use in this block{}", letter,
                                 letter == 'E' ? ": numbers have no exponent, an extruder is read "
                                                 "by --dialect marlin"
                                               : ""));
    }
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
