// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/options/readers.hpp"

#include <charconv>
#include <sstream>

namespace curvecore::sysc {

double unit_of(const std::string& option, const std::string& text) {
    return length(option, text, 1e-7, 1);
}

Build build_of(const std::string& option, const std::string& text) {
    return static_cast<Build>(choice(option, text, ref::kBuildNames));
}

std::uint64_t whole(const std::string& option, const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) {
        throw UsageError(fmt::format("{} '{}': not a whole number", option, text));
    }
    return value;
}

std::vector<std::string> list_items(const std::string& option, const std::string& text) {
    std::vector<std::string> items;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    if (items.empty()) throw UsageError(fmt::format("{}: a list is expected", option));
    return items;
}

}  // namespace curvecore::sysc
