// SPDX-License-Identifier: Apache-2.0
// A program's text as lines of words, without comments, blanks and empty lines.
#pragma once

#include <optional>
#include <string>

#include "ref/program/place.hpp"
#include "ref/program/text_file.hpp"

namespace curvecore::ref {

struct ProgramLine {
    int number = 0;  // in its file, from 1
    std::string words;
};

/// A line without comments and blanks, in upper case. @throws InputError: it is not text
std::string words_of(std::string_view text, const Place& place);

class ProgramLines {
  public:
    /// @param text, file outlive this object
    ProgramLines(std::istream& text, const std::string& file) : lines_(text), file_(file) {}

    /// The next line that has words, up to the '%' that ends a program which '%' began.
    /// @throws InputError
    std::optional<ProgramLine> next();

  private:
    TextLines lines_;
    const std::string& file_;
    bool framed_ = false;
    bool begun_ = false;
    bool ended_ = false;
};

}  // namespace curvecore::ref
