// SPDX-License-Identifier: Apache-2.0
// The one form in which input is refused: FILE:LINE: error: reason.
#pragma once

#include <stdexcept>
#include <string>

namespace curvecore::ref {

/// Error whose what() is "FILE:LINE: error: reason", or "FILE: error: reason" if line is 0.
class InputError : public std::runtime_error {
  public:
    InputError(const std::string& file, int line, const std::string& reason)
        : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") +
                             ": error: " + reason) {}
};

}  // namespace curvecore::ref
