// SPDX-License-Identifier: Apache-2.0
#include "ref/format/parameter_text.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

namespace curvecore::ref {
namespace {

struct Need {
    int CoreParameters::*value;
    int wanted;
};

/// Reads "Splines=0 Mode=0" of a row.
std::vector<Need> needs_of(const Parameter& row) {
    std::vector<Need> needs;
    std::istringstream words(row.needs);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        needs.push_back(
            {find_parameter(word.substr(0, equals))->value, std::stoi(word.substr(equals + 1))});
    }
    return needs;
}

/// The needs of all rows, in the table's order.
const std::vector<std::vector<Need>>& all_needs() {
    static const std::vector<std::vector<Need>> kNeeds = [] {
        std::vector<std::vector<Need>> needs;
        for (const Parameter& row : kParameters) needs.push_back(needs_of(row));
        return needs;
    }();
    return kNeeds;
}

bool has_needs(const CoreParameters& parameters, const Parameter& row,
               const std::vector<Need>& needs) {
    if (row.builds == ParameterBuilds::kParallelAlone && parameters.build != Build::kParallel) {
        return false;
    }
    for (const Need& need : needs) {
        if (parameters.*need.value != need.wanted) return false;
    }
    return true;
}

/// Returns "--build parallel, Splines=0 and Mode=0".
std::string needs_text(const Parameter& row) {
    std::vector<std::string> needs;
    if (row.builds == ParameterBuilds::kParallelAlone) needs.emplace_back("--build parallel");
    std::istringstream words(row.needs);
    for (std::string word; words >> word;) needs.push_back(word);
    const std::string last = needs.back();
    needs.pop_back();
    return needs.empty() ? last : fmt::format("{} and {}", fmt::join(needs, ", "), last);
}

}  // namespace

std::string range_text(const Parameter& row) {
    if (row.values == ParameterValues::kPowerOfTwo) {
        std::string text = std::to_string(row.low);
        for (int value = 2 * row.low; value <= row.high; value *= 2) {
            text += fmt::format("{}{}", value == row.high ? " or " : ", ", value);
        }
        return fmt::format("{} must be {}", row.name, text);
    }
    if (row.low == 0 && row.high == 1) return fmt::format("{} must be 0 or 1", row.name);
    return fmt::format("{} must be in [{}, {}]", row.name, row.low, row.high);
}

const Parameter* find_parameter(const std::string& name) {
    for (const Parameter& row : kParameters) {
        if (name == row.name) return &row;
    }
    return nullptr;
}

std::string why_not_built(const CoreParameters& parameters) {
    std::size_t i = 0;
    for (const Parameter& row : kParameters) {
        const std::vector<Need>& needs = all_needs()[i++];
        const int value = parameters.*row.value;
        if (!row.holds(value)) return range_text(row);
        if (value != row.default_value && !has_needs(parameters, row, needs)) {
            return fmt::format("{}={} works with {} only", row.name, value, needs_text(row));
        }
    }
    return "";
}

const char* build_name(Build build) { return kBuildNames[static_cast<std::size_t>(build)].data(); }

std::string parameters_text(const CoreParameters& parameters) {
    std::string text;
    for (const Parameter& row : kParameters) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", row.name, parameters.*row.value);
    }
    return text;
}

std::string parameter_names() {
    std::vector<std::string> names;
    for (const Parameter& row : kParameters) names.emplace_back(row.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace curvecore::ref
