// SPDX-License-Identifier: Apache-2.0
#include "tb/command/quantity.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "tb/command/usage_error.hpp"

namespace curvecore::tb {

std::string suffix_names(const std::vector<Suffix>& suffixes) {
    std::string text;
    for (std::size_t i = 0; i < suffixes.size(); ++i) {
        text += text.empty() ? "" : i + 1 == suffixes.size() ? " or " : ", ";
        text += suffixes[i].first;
    }
    return text;
}

double quantity(const std::string& option, const std::string& text,
                const std::vector<Suffix>& suffixes) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || !std::isfinite(value)) {
        throw UsageError(fmt::format("{} '{}': not a number", option, text));
    }
    const std::string_view suffix(result.ptr, static_cast<std::size_t>(end - result.ptr));
    for (const Suffix& known : suffixes) {
        // By division, 100us is the double nearest to 1e-4.
        if (suffix != known.first) continue;
        const double power = std::pow(10.0, std::abs(known.second));
        return known.second < 0 ? value / power : value * power;
    }
    throw UsageError(
        fmt::format("{} '{}': the unit must be {}", option, text, suffix_names(suffixes)));
}

}  // namespace curvecore::tb
