// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/program_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace curvecore::ref {
namespace {

constexpr std::size_t kLongestLine = 4096;
constexpr int kLinesToRecognise = 200;  // lines that have words
constexpr std::size_t kMostLinesAhead = 10000;

}  // namespace

std::string words_of(std::string_view text, const Place& place) {
    if (text.size() > kLongestLine) {
        place.refuse(fmt::format("the line is longer than {} characters", kLongestLine));
    }
    std::string words;
    int comments = 0;  // in each other
    bool rest = false;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte < 0x20 && c != '\t') || byte == 0x7f) {
            place.refuse(fmt::format("byte 0x{:02x} is not text", byte));
        }
        if (rest) {
            continue;
        }
        if (c == '(') {
            ++comments;
        } else if (comments > 0) {
            if (c == ')') --comments;
        } else if (c == ';') {
            rest = true;
        } else if (byte >= 0x80) {
            place.refuse(fmt::format("byte 0x{:02x} outside a comment", byte));
        } else if (c != ' ' && c != '\t') {
            words += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
    }
    if (comments > 0) {
        place.refuse("a comment without its closing parenthesis");
    }
    return words;
}

std::optional<std::string> curve_comment(std::string_view text) {
    constexpr std::string_view kWord = "curve";
    int comments = 0;  // in each other
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == ')') comments = std::max(0, comments - 1);
        if (text[at] == ';' && comments == 0) break;
        if (text[at] != '(' || ++comments > 1) continue;
        const std::size_t first = text.find_first_not_of(" \t", at + 1);
        const std::string_view rest = first < text.size() ? text.substr(first) : "";
        const bool named = rest.size() > kWord.size() &&
                           std::equal(kWord.begin(), kWord.end(), rest.begin(), [](char a, char b) {
                               return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b);
                           });
        const std::size_t comma = named ? rest.find_first_not_of(" \t", kWord.size()) : rest.size();
        if (comma >= rest.size() || rest[comma] != ',') continue;
        return std::string(rest.substr(comma + 1, rest.find(')') - comma - 1));
    }
    return {};
}

ProgramLines::ProgramLines(std::istream& text, const std::string& file,
                           std::optional<Dialect> dialect)
    : lines_(text), file_(file) {
    if (dialect) {
        dialect_ = *dialect;
    } else {
        recognise();
    }
    reader_ = lines_in(dialect_);
}

void ProgramLines::recognise() {
    DialectFinder finder;
    while (finder.lines() < kLinesToRecognise && first_.size() < kMostLinesAhead) {
        const std::optional<std::string_view> text = lines_.next();
        if (!text) return;
        first_.emplace_back(*text);
        if (const std::optional<Dialect> found = finder.look_at(*text)) {
            dialect_ = *found;
            return;
        }
    }
}

std::optional<std::string_view> ProgramLines::next_text() {
    ++number_;
    if (first_.empty()) return lines_.next();
    text_ = std::move(first_.front());
    first_.pop_front();
    return text_;
}

std::optional<ProgramLine> ProgramLines::next() {
    while (!ended_) {
        const std::optional<std::string_view> text = next_text();
        if (!text) break;
        ProgramLine line;
        line.number = number_;
        const Place place{file_, line.number};
        line.curve = curve_comment(*text);
        reader_->read(*text, line, place);
        if (line.words.empty() && line.note.empty() && !line.curve) continue;
        const bool begins = !begun_ && line.words[0] == '%';  // alone, or with the program's name
        begun_ = true;
        if (begins) continue;
        if (line.words != "%") return line;
        ended_ = true;
    }
    return std::nullopt;
}

}  // namespace curvecore::ref
