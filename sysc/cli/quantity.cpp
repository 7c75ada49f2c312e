// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/quantity.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

const std::vector<Suffix> kLengths{{"nm", -6}, {"um", -3}, {"mm", 0}, {"m", 3}, {"in", 0, 25.4}};
const std::vector<Suffix> kSpeeds{{"", 0},         {"mm/min", 0}, {"m/min", 3}, {"in/min", 0, 25.4},
                                  {"mm/s", 0, 60}, {"m/s", 3, 60}};
const std::vector<Suffix> kFrequencies{{"Hz", 0}, {"kHz", 3}, {"MHz", 6}, {"GHz", 9}};

/// Names as text: "ns, us, ms or s".
std::string suffix_names(const std::vector<Suffix>& suffixes) {
    std::string text;
    for (std::size_t i = 0; i < suffixes.size(); ++i) {
        if (suffixes[i].name.empty()) continue;
        text += text.empty() ? "" : i + 1 == suffixes.size() ? " or " : ", ";
        text += suffixes[i].name;
    }
    return text;
}

double scaled(double value, const Suffix& suffix) {
    // Division keeps 100us the double nearest to 1e-4.
    const double power = std::pow(10.0, std::abs(suffix.power));
    return suffix.times * (suffix.power < 0 ? value / power : value * power);
}

}  // namespace

double quantity(const std::string& option, const std::string& text,
                const std::vector<Suffix>& suffixes) {
    double value = 0;
    const char* end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, value);
    if (read.ec == std::errc() && read.ptr != end && *read.ptr == '/') {
        double divisor = 0;
        read = std::from_chars(read.ptr + 1, end, divisor);
        value /= divisor;
    }
    if (read.ec != std::errc() || !std::isfinite(value)) {
        throw UsageError(fmt::format("{} '{}': not a number", option, text));
    }
    const std::string_view rest(read.ptr, static_cast<std::size_t>(end - read.ptr));
    for (const Suffix& known : suffixes) {
        if (rest == known.name) return scaled(value, known);
    }
    throw UsageError(
        fmt::format("{} '{}': the unit must be {}", option, text, suffix_names(suffixes)));
}

double plain_number(const std::string& option, const std::string& text) {
    return quantity(option, text, {{"", 0}});
}

double length(const std::string& option, const std::string& text, double low, double high) {
    const double value = quantity(option, text, kLengths);
    if (!(value >= low && value <= high)) {
        throw UsageError(fmt::format("{} must be in [{:g}, {:g}] mm", option, low, high));
    }
    return value;
}

double speed(const std::string& option, const std::string& text) {
    const double value = quantity(option, text, kSpeeds);
    if (!(value >= 1e-3 && value <= 1e9)) {
        throw UsageError(option + " must be in [0.001, 1e9] mm/min");
    }
    return value / 60;
}

double duration(const std::string& option, const std::string& text) {
    return quantity(option, text, {{"ns", -9}, {"us", -6}, {"ms", -3}, {"s", 0}});
}

double frequency(const std::string& option, const std::string& text, double low, double high) {
    const double value = quantity(option, text, kFrequencies);
    if (!(value >= low && value <= high)) {
        throw UsageError(fmt::format("{} must be in [{:g}, {:g}] Hz", option, low, high));
    }
    return value;
}

std::string exact_length(double mm) {
    std::string shortest;
    for (const Suffix& unit : kLengths) {
        const double number = mm / scaled(1, unit);
        const std::string text = fmt::format("{}{}", number, unit.name);
        const bool exact = quantity("", text, kLengths) == mm;
        if (exact && (shortest.empty() || text.size() < shortest.size())) shortest = text;
    }
    return shortest.empty() ? fmt::format("{}mm", mm) : shortest;
}

}  // namespace curvecore::sysc
