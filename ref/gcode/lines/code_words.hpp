// SPDX-License-Identifier: Apache-2.0
// A line as letters with numbers behind them, for readers that see it before it is a block.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace curvecore::ref {

struct CodeWord {
    char letter;
    std::string number;  // as written; empty: there is none
};

/// Returns a line without (..), ;.. and blanks, in upper case, whatever it holds.
std::string bare_code(std::string_view text);

/// Returns its words except N, up to text that is no word, as a check sum.
std::vector<CodeWord> code_words(std::string_view code);

std::string text_of(const std::vector<CodeWord>& words);

}  // namespace curvecore::ref
