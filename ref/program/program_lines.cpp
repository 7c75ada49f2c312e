// SPDX-License-Identifier: Apache-2.0
#include "ref/program/program_lines.hpp"

#include <fmt/format.h>

namespace curvecore::ref {
namespace {

constexpr std::size_t kLongestLine = 4096;

}  // namespace

std::string words_of(std::string_view text, const Place& place) {
    if (text.size() > kLongestLine) {
        place.refuse(fmt::format("the line is longer than {} characters", kLongestLine));
    }
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

std::optional<ProgramLine> ProgramLines::next() {
    while (!ended_) {
        const std::optional<std::string_view> text = lines_.next();
        if (!text) break;
        const Place place{file_, lines_.number()};
        ProgramLine line{place.line, words_of(*text, place)};
        if (line.words.empty()) continue;
        if (line.words != "%") {
            begun_ = true;
            return line;
        }
        if (begun_ && !framed_) place.refuse("% ends a program that does not begin with %");
        ended_ = begun_;
        framed_ = begun_ = true;
    }
    return std::nullopt;
}

}  // namespace curvecore::ref
