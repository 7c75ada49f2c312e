// SPDX-License-Identifier: Apache-2.0
// A text file, and its lines whatever ends them (LF, CR LF, CR).
#pragma once

#include <fstream>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace curvecore::ref {

/// @throws InputError when the file is missing, not a regular file or unreadable.
std::ifstream open_text_file(const std::string& file);

/// All of it. @throws InputError, also when it is above 1 GiB.
std::string read_text_file(const std::string& file);

class TextLines {
  public:
    /// A byte order mark at the start is passed over. `text` must outlive this object.
    explicit TextLines(std::istream& text);

    /// Stays until the next one is asked for.
    std::optional<std::string_view> next();
    int number() const { return number_; }  // of the line last returned, from 1

  private:
    std::streambuf& text_;
    std::string line_;
    int number_ = 0;
};

}  // namespace curvecore::ref
