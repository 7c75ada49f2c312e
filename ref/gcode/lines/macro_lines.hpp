// SPDX-License-Identifier: Apache-2.0
// Statements of Fanuc's macros, which have no other meaning in RS274/NGC.
//
//     WHILE [value] DOn .. ENDn         DOn .. ENDn          loops: read as O-words
//     IF [value] GOTO n                 GOTO n               n: a block that begins with Nn
//     IF [value] THEN block
//     G65 Pn Lm A.. B.. ..              O n, m times, with its #1, #2 .. of these words
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace curvecore::ref {

constexpr std::string_view kDigits = "0123456789";

/// Returns where a line's words begin behind '/' and its number.
std::size_t begin_of_words(const std::string& words);
/// Returns the number of a line, as 10 of N10; nothing: it has none.
std::optional<int> number_of_line(const std::string& words);

/// Returns the line with loops as O-words.
std::string with_o_words(std::string words);

}  // namespace curvecore::ref
