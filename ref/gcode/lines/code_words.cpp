// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/code_words.hpp"

#include <algorithm>

namespace curvecore::ref {

std::string bare_code(std::string_view text) {
    std::string code;
    int depth = 0;  // nested comments
    for (const char c : text) {
        if (c == ';' && depth == 0) break;
        if (c == '(') ++depth;
        const bool kept = depth == 0 && static_cast<unsigned char>(c) > ' ' && c != 0x7f;
        if (kept) code += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        if (c == ')') depth = std::max(depth - 1, 0);
    }
    return code;
}

std::vector<CodeWord> code_words(std::string_view code) {
    std::vector<CodeWord> words;
    std::size_t at = !code.empty() && code[0] == '/' ? 1 : 0;
    while (at < code.size() && code[at] >= 'A' && code[at] <= 'Z') {
        const std::size_t begin = ++at;
        const std::size_t end = code.find_first_not_of("+-.0123456789", begin);
        at = end == std::string_view::npos ? code.size() : end;
        if (code[begin - 1] == 'N') continue;
        words.push_back({code[begin - 1], std::string(code.substr(begin, at - begin))});
    }
    return words;
}

std::string text_of(const std::vector<CodeWord>& words) {
    std::string text;
    for (const CodeWord& word : words) text += word.letter + word.number;
    return text;
}

}  // namespace curvecore::ref
