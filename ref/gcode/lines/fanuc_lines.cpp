// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/fanuc_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "ref/gcode/lines/code_words.hpp"
#include "ref/gcode/lines/macro_lines.hpp"
#include "ref/gcode/lines/program_lines.hpp"

namespace curvecore::ref {
namespace {

constexpr std::string_view kLengths = "XYZUVWIJKRQ";
constexpr std::string_view kAngles = "ABC";
constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZ+-.0123456789";

bool is_integer(const std::string& number) {
    const std::size_t begin = number.find_first_of("+-") == 0 ? 1 : 0;
    return number.size() > begin && number.size() < begin + 10 &&
           number.find_first_not_of(kDigits, begin) == std::string::npos;
}

bool is_code(const CodeWord& word, char letter, int code) {
    return word.letter == letter && is_integer(word.number) &&
           std::atoi(word.number.c_str()) == code;
}

void scale(CodeWord& word, double unit) {
    word.number = fmt::format("{:.7f}", std::atoi(word.number.c_str()) * unit);
}

/// Splits P of 5 to 8 figures: the number of times, and the program's number.
void part_call(std::vector<CodeWord>& words) {
    for (CodeWord& word : words) {
        if (word.letter != 'P' || !is_integer(word.number) || word.number.size() < 5) continue;
        const std::string times = word.number.substr(0, word.number.size() - 4);
        word.number.erase(0, times.size());
        words.push_back({'L', times});
        return;
    }
}

/// Returns true for Haas' smoothing and limits of look-ahead.
bool is_setting(const CodeWord& word) { return is_code(word, 'G', 187) || is_code(word, 'G', 103); }

/// Puts `#1 = #2 + 1` into the brackets that RS274/NGC needs, alone and behind IF [..] THEN.
void put_brackets(std::string& words) {
    std::size_t begin = begin_of_words(words);
    const std::size_t then = words.find("]THEN", begin);
    if (words.compare(begin, 3, "IF[") == 0 && then != std::string::npos) begin = then + 5;
    const std::size_t equals = words.find('=', begin);
    if (begin == words.size() || words[begin] != '#' || equals == std::string::npos) return;
    words.insert(equals + 1, 1, '[');
    words += ']';
}

/// Drops the rest (P) of G73 G81 G83, which have none in RS274/NGC. @return the warning of it
std::string drop_rest(std::vector<CodeWord>& words) {
    const auto is_drilling = [](const CodeWord& word) {
        return is_code(word, 'G', 73) || is_code(word, 'G', 81) || is_code(word, 'G', 83);
    };
    const auto rest = std::find_if(words.begin(), words.end(),
                                   [](const CodeWord& word) { return word.letter == 'P'; });
    if (rest == words.end() || std::none_of(words.begin(), words.end(), is_drilling)) return "";
    words.erase(rest);
    return "the rest at a hole's bottom (P) of G73 G81 G83 is not drawn: G82 has one";
}

/// Drops the number of a radius that is not used: `G43 H1 D1`. @return true if it was there
bool drop_radius(std::vector<CodeWord>& words) {
    const auto has = [&words](char letter) {
        return std::any_of(words.begin(), words.end(),
                           [letter](const CodeWord& word) { return word.letter == letter; });
    };
    if (!has('H') || !has('D')) return false;
    const auto is_radius = [](const CodeWord& word) { return word.letter == 'D'; };
    words.erase(std::remove_if(words.begin(), words.end(), is_radius), words.end());
    return true;
}

}  // namespace

void FanucLines::read(std::string_view text, ProgramLine& line, const Place& place) {
    line.words = with_o_words(words_of(text, place));
    if (line.words.size() > 1 && line.words[0] == '/' && line.words[1] >= '1' &&
        line.words[1] <= '9') {
        line.words.erase(1, 1);
    }
    const std::size_t begin = line.words.rfind('/', 0) == 0 ? 1 : 0;
    put_brackets(line.words);
    if (line.words.find_first_not_of(kPlain, begin) != std::string::npos) return;  // a macro's
    std::vector<CodeWord> words = code_words(line.words);
    if (!words.empty() && is_setting(words[0])) {
        line.note = "G" + words[0].number;
        line.words.clear();
        return;
    }
    const bool ended = end_cycle(words);
    bool changed = drop_radius(words);
    if (!words.empty() && is_code(words[0], 'G', 65)) return;  // arguments are plain numbers
    bool dwells = false;
    bool cycle = false;
    bool calls = false;
    for (const CodeWord& word : words) {
        if (is_code(word, 'G', 20) || is_code(word, 'G', 21)) inches_ = is_code(word, 'G', 20);
        if (is_code(word, 'G', 90) || is_code(word, 'G', 91)) absolute_ = is_code(word, 'G', 90);
        dwells = dwells || is_code(word, 'G', 4);
        for (int code = 73; code <= 89; ++code) cycle = cycle || is_code(word, 'G', code);
        calls = calls || is_code(word, 'M', 98);
    }
    bool scaled = false;
    for (CodeWord& word : words) {
        if (dwells && (word.letter == 'X' || word.letter == 'U' || word.letter == 'P')) {
            word.letter = 'P';
            if (is_integer(word.number)) scale(word, 1e-3);
        } else if (cycle && word.letter == 'P') {
            if (is_integer(word.number)) scale(word, 1e-3);
        } else if (cycle && word.letter == 'K') {
            word.letter = 'L';  // number of times
        } else if (is_integer(word.number) && std::atoi(word.number.c_str()) != 0) {
            const bool length = kLengths.find(word.letter) != std::string_view::npos;
            const bool angle = kAngles.find(word.letter) != std::string_view::npos;
            if (length || angle) scale(word, length && inches_ ? 1e-4 : 1e-3);
            scaled = scaled || length || angle;
        }
    }
    if (calls) part_call(words);
    if (cycle) line.warning = drop_rest(words);
    if (!dwells && !cycle && add_increments(words)) {
        changed = true;
        line.warning =
            "U V W are increments of X Y Z, as on Fanuc's lathes; their G98 G99 are G94 G95 here, "
            "their G90 G92 G94 cycles that are not read";
    }
    if (!dwells && !calls && !cycle && !scaled && !ended && !changed) return;
    line.words = text_of(words);
    if (scaled && line.warning.empty()) {
        line.warning =
            "an axis' number without a point counts in 0.001 mm or 0.0001 inch, as on a Fanuc; "
            "--dialect linuxcnc takes it as it stands";
    }
}

/// Makes U V W, increments on lathes, X Y Z. @return true if there are any
bool FanucLines::add_increments(std::vector<CodeWord>& words) const {
    constexpr std::string_view kIncrements = "UVW";
    constexpr std::string_view kAxes = "XYZ";
    bool found = false;
    for (CodeWord& word : words) {
        const std::size_t axis = kIncrements.find(word.letter);
        if (axis == std::string_view::npos || word.number.empty()) continue;
        found = true;
        word.letter = kAxes[axis];
        if (!absolute_) continue;
        word.number =
            fmt::format("[#<_{}>+[{}]]", static_cast<char>(word.letter - 'A' + 'a'), word.number);
    }
    return found;
}

bool FanucLines::end_cycle(std::vector<CodeWord>& words) {
    bool ends = false;
    bool moves = false;
    for (const CodeWord& word : words) {
        ends = ends || is_code(word, 'G', 80);
        for (int code = 0; code <= 3; ++code) {
            if (!is_code(word, 'G', code)) continue;
            moves = true;
            motion_ = code == 0 ? "0" : "1";
        }
    }
    if (!ends || moves || motion_.empty()) return false;
    words.push_back({'G', motion_});
    return true;
}

}  // namespace curvecore::ref
