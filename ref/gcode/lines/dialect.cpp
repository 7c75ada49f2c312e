// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/dialect.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "ref/gcode/lines/code_words.hpp"

namespace curvecore::ref {
namespace {

bool one_of(std::string_view code, std::initializer_list<std::string_view> codes) {
    for (const std::string_view candidate : codes) {
        if (code == candidate) return true;
    }
    return false;
}

/// Returns true for an E behind a blank: in X1e3 it is a power of ten to others.
bool has_extruder(std::string_view text) {
    for (std::size_t i = 1; i < text.size() && text[i] != ';' && text[i] != '('; ++i) {
        const bool blank = text[i - 1] == ' ' || text[i - 1] == '\t';
        if (blank && (text[i] == 'E' || text[i] == 'e')) return true;
    }
    return false;
}

bool for_extruders(const std::vector<CodeWord>& words, std::string_view text) {
    const std::string first = words[0].letter + words[0].number;
    const bool moves = one_of(first, {"G0", "G1", "G00", "G01", "G2", "G3", "G02", "G03", "G92"});
    const bool heats = one_of(first, {"M104", "M109", "M140", "M190"});
    const auto has = [&words](char letter) {
        return std::any_of(words.begin(), words.end(),
                           [letter](const CodeWord& word) { return word.letter == letter; });
    };
    const auto is_output = [](const CodeWord& word) {  // LinuxCNC's M67 E2 Q25 behind a motion
        return word.letter == 'M' && one_of(word.number, {"67", "68"});
    };
    if (std::any_of(words.begin(), words.end(), is_output)) return false;
    return (moves && has('E') && has_extruder(text)) || (heats && has('S')) ||
           one_of(first, {"M82", "M83"});
}

}  // namespace

std::optional<Dialect> DialectFinder::look_at(std::string_view text) {
    const std::string code = bare_code(text);
    if (code.empty()) return std::nullopt;
    ++lines_;
    if (code[0] == '$') return Dialect::kGrbl;
    if (code.find('#') != std::string::npos) {
        if (numbered_) return std::nullopt;  // or a Fanuc's variable
        return Dialect::kLinuxcnc;
    }
    const bool number = code[0] == 'O' || code[0] == ':';
    if (number) {
        if (code.find_first_not_of("0123456789", 1) != std::string::npos || code.size() < 2) {
            return Dialect::kLinuxcnc;
        }
        numbered_ = true;
        return std::nullopt;
    }
    const std::vector<CodeWord> words = code_words(code);
    if (words.empty()) return std::nullopt;
    if (for_extruders(words, text)) return Dialect::kMarlin;
    for (const CodeWord& word : words) {
        bare_point_ = bare_point_ || (word.number.size() > 1 && word.number.back() == '.');
    }
    if (numbered_ && bare_point_) return Dialect::kFanuc;
    return std::nullopt;
}

}  // namespace curvecore::ref
