// SPDX-License-Identifier: Apache-2.0
#include "sysc/core/core_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "ref/text/text_file.hpp"
#include "sysc/formats/json_file.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 8> kCoreKeys{
    "core", "build", "device", "unit_mm", "parameters", "error_mm", "clock_hz", "sample_period_s"};

/// Reads a value that must be a number above 0 if it is present.
std::optional<double> positive(const Json& json, const char* name) {
    if (!json.contains(name) || json[name].is_null()) return std::nullopt;
    const double value = number(json[name], name);
    if (!(value > 0)) throw JsonFlaw{name, fmt::format("{} must be above 0", name)};
    return value;
}

std::string text_of(const Json& json, const char* name, const char* otherwise) {
    if (!json.contains(name)) return otherwise;
    if (!json[name].is_string()) throw JsonFlaw{name, fmt::format("'{}': not a text", name)};
    return json[name];
}

CoreParameters parameters_of(const Json& json) {
    CoreParameters parameters;
    const std::string build = text_of(json, "build", "parallel");
    const auto* const found = std::find(ref::kBuildNames.begin(), ref::kBuildNames.end(), build);
    if (found == ref::kBuildNames.end()) {
        throw JsonFlaw{"build",
                       fmt::format("build must be one of {}", fmt::join(ref::kBuildNames, ", "))};
    }
    parameters.build = static_cast<Build>(found - ref::kBuildNames.begin());
    for (const auto& [name, value] : member(json, "parameters").items()) {
        const ref::Parameter* const row = ref::find_parameter(name);
        if (row == nullptr) {
            throw JsonFlaw{name, fmt::format("{} is no parameter: there are {}", name,
                                             ref::parameter_names())};
        }
        parameters.*row->value = whole_number(value, name);
    }
    const std::string reason = ref::why_not_built(parameters);
    if (!reason.empty()) throw JsonFlaw{reason.substr(0, reason.find_first_of(" =")), reason};
    return parameters;
}

CoreFile core_of(const Json& json) {
    check_keys(json, kCoreKeys, "a core");
    CoreFile core;
    core.core = text_of(json, "core", "");
    core.parameters = parameters_of(json);
    core.device = text_of(json, "device", "");
    core.unit_mm = positive(json, "unit_mm");
    core.error_mm = positive(json, "error_mm");
    core.sample_period_s = positive(json, "sample_period_s");
    core.clock_hz = positive(json, "clock_hz");
    return core;
}

}  // namespace

Json CoreFile::json() const {
    const auto number = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    return {{"core", core},
            {"build", build_name(parameters.build)},
            {"device", device},
            {"parameters", parameters_json(parameters)},
            {"unit_mm", number(unit_mm)},
            {"error_mm", number(error_mm)},
            {"sample_period_s", number(sample_period_s)},
            {"clock_hz", number(clock_hz)}};
}

CoreFile read_core_file(const std::string& file) {
    return read_json(ref::read_text_file(file), file, "curvecore choose -o writes a core", core_of);
}

}  // namespace curvecore::sysc
