// SPDX-License-Identifier: Apache-2.0
// A line as letters with numbers behind them, for those who look at it before it is a block.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace curvecore::ref {

struct CodeWord {
    char letter;
    std::string number;  // as it is written; empty: there is none
};

/// A line without (..), ;.. and blanks, in upper case, whatever stands in it.
std::string bare_code(std::string_view text);

/// Its words but N, up to what is no word, as a check sum.
std::vector<CodeWord> code_words(std::string_view code);

std::string text_of(const std::vector<CodeWord>& words);

}  // namespace curvecore::ref
