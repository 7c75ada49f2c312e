// SPDX-License-Identifier: Apache-2.0
// Readers: each turns the text of an option into its value, or throws a UsageError that names the
// option. length(), speed() and others of sysc/cli/quantity.hpp are readers, too.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "sysc/cli/choice.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

constexpr double kAboveZero = std::numeric_limits<double>::min();
constexpr double kGreatest = std::numeric_limits<double>::max();

/// Reads as `read` does a number from `low` to `high`; `range` says which: "in [0, 10s]".
template <class Read>
auto within(Read read, double low, double high, const char* range) {
    return [=](const std::string& option, const std::string& text) {
        const double value = read(option, text);
        if (!(value >= low && value <= high)) {
            throw UsageError(fmt::format("{} must be {}", option, range));
        }
        return value;
    };
}

/// Reads as `read`, length() or frequency(), does from `low` to `high`.
template <class Read>
auto in_range(Read read, double low, double high) {
    return [=](const std::string& option, const std::string& text) {
        return read(option, text, low, high);
    };
}

/// Reads a length unit, mm.
double unit_of(const std::string& option, const std::string& text);
Build build_of(const std::string& option, const std::string& text);
std::uint64_t whole(const std::string& option, const std::string& text);

/// Reads a whole number from `low` to `high`.
inline auto whole_in(int low, int high) {
    return [=](const std::string& option, const std::string& text) {
        const std::uint64_t number = whole(option, text);
        if (number >= std::uint64_t(low) && number <= std::uint64_t(high)) {
            return static_cast<int>(number);
        }
        throw UsageError(fmt::format("{} must be a whole number in [{}, {}]", option, low, high));
    };
}

/// Reads a power of two from `low` to `high`.
inline auto power_of_two_in(int low, int high) {
    return [=](const std::string& option, const std::string& text) {
        const std::uint64_t number = whole(option, text);
        const bool inside = number >= std::uint64_t(low) && number <= std::uint64_t(high);
        if (inside && (number & (number - 1)) == 0) return static_cast<int>(number);
        throw UsageError(fmt::format("{} must be a power of two in [{}, {}]", option, low, high));
    };
}

/// Reads one of the names, which are those of the Enum's values.
template <class Enum, std::size_t Count>
auto one_of(const std::array<std::string_view, Count>& names) {
    return [&names](const std::string& option, const std::string& text) {
        return static_cast<Enum>(choice(option, text, names));
    };
}

/// Returns the items of a list, which commas part.
std::vector<std::string> list_items(const std::string& option, const std::string& text);

/// Reads each item of a list as `read` does, or one value alone if `several` is false.
template <class Read>
auto list_of(Read read, bool several = true) {
    return [=](const std::string& option, const std::string& text) {
        std::vector<decltype(read(option, text))> values;
        for (const std::string& item : several ? list_items(option, text) : std::vector{text}) {
            values.push_back(read(option, item));
        }
        return values;
    };
}

}  // namespace curvecore::sysc
