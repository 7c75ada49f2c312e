// SPDX-License-Identifier: Apache-2.0
// from_chars of floating point, which the standard library of emscripten 3.1.6 lacks. The
// compiler's option -include puts it before every source.
#pragma once

#include <charconv>
#include <cstdlib>
#include <string>

namespace std {

/// Reads a number of decimal digits, sign, point and exponent, as from_chars does; `fixed` forms
/// have no exponent.
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format format = chars_format::general) {
    const char* const end =
        first +
        string(first, last)
            .find_first_not_of(format == chars_format::fixed ? "-.0123456789" : "-+.0123456789eE");
    const string text(first, end < first ? last : end);
    char* behind = nullptr;
    const double number = text.empty() || text[0] == '+' ? 0 : strtod(text.c_str(), &behind);
    if (behind == nullptr || behind == text.c_str()) return {first, errc::invalid_argument};
    value = number;
    return {first + (behind - text.c_str()), errc()};
}

}  // namespace std
