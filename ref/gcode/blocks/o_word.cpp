// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/o_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ref/gcode/blocks/value_reader.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

using Kind = OWord::Kind;

/// Keywords, longer ones before those that they begin with.
constexpr std::pair<std::string_view, Kind> kKeywords[] = {
    {"SUB", Kind::kSub},
    {"ENDSUB", Kind::kEndsub},
    {"RETURN", Kind::kReturn},
    {"CALL", Kind::kCall},
    {"IF", Kind::kIf},
    {"ELSEIF", Kind::kElseif},
    {"ELSE", Kind::kElse},
    {"ENDIF", Kind::kEndif},
    {"WHILE", Kind::kWhile},
    {"ENDWHILE", Kind::kEndwhile},
    {"DO", Kind::kDo},
    {"REPEAT", Kind::kRepeat},
    {"ENDREPEAT", Kind::kEndrepeat},
    {"BREAK", Kind::kBreak},
    {"CONTINUE", Kind::kContinue},
};

/// Returns the least and the largest number of values.
std::pair<std::size_t, std::size_t> values_of(Kind kind) {
    switch (kind) {
        case Kind::kCall:
            return {0, ProgramParameters::kArguments};
        case Kind::kEndsub:
        case Kind::kReturn:
            return {0, 1};
        case Kind::kIf:
        case Kind::kElseif:
        case Kind::kWhile:
        case Kind::kRepeat:
            return {1, 1};
        default:
            return {0, 0};
    }
}

}  // namespace

std::string OWord::name() const {
    std::string text = "o" + label;
    for (const auto& [keyword, named] : kKeywords) {
        if (named != kind) continue;
        text += ' ';
        for (const char c : keyword) text += static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

std::optional<OWord> read_o_word(const std::string& words, const ProgramParameters& parameters,
                                 const Place& place) {
    ValueReader reader(words, parameters, place);
    reader.take("/");
    if (reader.take("N")) {
        while (reader.peek() >= '0' && reader.peek() <= '9') reader.skip();
    }
    if (reader.peek() != 'O' && reader.peek() != ':') return std::nullopt;
    reader.skip();
    OWord word;
    word.label =
        reader.peek() == '<' ? "<" + reader.name() + ">" : std::to_string(reader.whole_value("O"));
    const auto* const keyword =
        std::find_if(std::begin(kKeywords), std::end(kKeywords),
                     [&reader](const auto& candidate) { return reader.take(candidate.first); });
    if (keyword != std::end(kKeywords)) {
        word.kind = keyword->second;
    } else if (!reader.at_end()) {
        place.refuse(
            fmt::format("{} is no O-word: nothing, sub, call, if, while, do or repeat "
                        "stand behind o{}",
                        reader.rest(), word.label));
    }
    word.arguments = words.size() - reader.rest().size();
    return word;
}

std::optional<OWord> read_o_word_ahead(const std::string& words,
                                       const ProgramParameters& parameters, const Place& place) {
    const std::size_t label = words.find_first_of("O:");
    const bool value = label < words.size() && words.find_first_of("#[", label) == label + 1;
    try {
        return read_o_word(words, parameters, place);
    } catch (const InputError&) {
        if (!value) throw;
        return std::nullopt;
    }
}

std::vector<double> o_word_arguments(const OWord& word, const std::string& words,
                                     const ProgramParameters& parameters, const Place& place) {
    const auto [least, most] = values_of(word.kind);
    const std::string text = words.substr(word.arguments);
    ValueReader reader(text, parameters, place);
    std::vector<double> values;
    while (reader.peek() == '[') {
        if (values.size() == most) {
            place.refuse(fmt::format("{} takes {} value{} at most", word.name(), most,
                                     most == 1 ? "" : "s"));
        }
        values.push_back(reader.value(word.name()));
    }
    if (!reader.at_end()) {
        place.refuse(fmt::format("'{}' behind {}, where only values in brackets may stand",
                                 reader.peek(), word.name()));
    }
    if (values.size() < least) {
        place.refuse(
            fmt::format("{} lacks its value, as in {} [#1 lt 5]", word.name(), word.name()));
    }
    return values;
}

}  // namespace curvecore::ref
