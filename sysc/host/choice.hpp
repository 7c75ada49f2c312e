// SPDX-License-Identifier: Apache-2.0
// One of a list of names on the command line.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "sysc/host/usage_error.hpp"

namespace curvecore::sysc {

/// Index of a name. @throws UsageError that names `option`
template <std::size_t Count>
int choice(const std::string& option, const std::string& text,
           const std::array<std::string_view, Count>& known) {
    const auto found = std::find(known.begin(), known.end(), text);
    if (found == known.end()) {
        throw UsageError(
            fmt::format("{} '{}': must be one of {}", option, text, fmt::join(known, ", ")));
    }
    return static_cast<int>(found - known.begin());
}

}  // namespace curvecore::sysc
