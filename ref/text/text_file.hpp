// SPDX-License-Identifier: Apache-2.0
// A text file, and its lines with any line end (LF, CR LF, CR).
#pragma once

#include <fstream>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace curvecore::ref {

/// @throws InputError if the file is missing, not a regular file or unreadable
std::ifstream open_text_file(const std::string& file);

/// Reads all of it. @throws InputError, also above 1 GiB
std::string read_text_file(const std::string& file);

class TextLines {
  public:
    /// Reads lines; a byte order mark at the start is skipped. `text` must outlive this object.
    explicit TextLines(std::istream& text);

    /// Returns the next line, valid until the next call.
    std::optional<std::string_view> next();
    int number() const { return number_; }  // number of the last line, from 1

  private:
    std::streambuf& text_;
    std::string line_;
    int number_ = 0;
};

}  // namespace curvecore::ref
