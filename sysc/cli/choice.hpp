// SPDX-License-Identifier: Apache-2.0
// Choices: one of a list of names on the command line.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

/// Returns true if two names are equal, ignoring case.
inline bool same_name(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

/// Returns the index of a name. @throws UsageError that names `option`
template <std::size_t Count>
int choice(const std::string& option, const std::string& text,
           const std::array<std::string_view, Count>& known) {
    const auto found = std::find_if(known.begin(), known.end(), [&text](std::string_view name) {
        return same_name(name, text);
    });
    if (found == known.end()) {
        throw UsageError(
            fmt::format("{} '{}': must be one of {}", option, text, fmt::join(known, ", ")));
    }
    return static_cast<int>(found - known.begin());
}

}  // namespace curvecore::sysc
