// SPDX-License-Identifier: Apache-2.0
// A program's text as lines of words, without comments, blanks and empty lines.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "ref/gcode/lines/dialect_lines.hpp"
#include "ref/text/place.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::ref {

/// Returns a line without comments and blanks, in upper case. @throws InputError: it is not text
std::string words_of(std::string_view text, const Place& place);

/// Returns what a line's first comment (curve, ..) has behind its comma; none: there is none.
std::optional<std::string> curve_comment(std::string_view text);

class ProgramLines {
  public:
    /// @param text, file outlive this object
    /// @param dialect none: recognised from the first lines
    ProgramLines(std::istream& text, const std::string& file, std::optional<Dialect> dialect);

    /// Returns the next line that has words, a curve or a note, up to the '%' that ends the
    /// program; one more '%' may begin it. @throws InputError
    std::optional<ProgramLine> next();
    Dialect dialect() const { return dialect_; }
    /// Number of the last line that was taken from the text, from 1.
    int number() const { return number_; }

  private:
    void recognise();
    std::optional<std::string_view> next_text();

    TextLines lines_;
    const std::string& file_;
    Dialect dialect_ = Dialect::kLinuxcnc;
    std::unique_ptr<DialectLines> reader_;
    std::deque<std::string> first_;  // lines that were read to recognise the dialect
    std::string text_;
    int number_ = 0;
    bool begun_ = false;
    bool ended_ = false;
};

}  // namespace curvecore::ref
