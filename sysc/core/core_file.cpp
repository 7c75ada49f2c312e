// SPDX-License-Identifier: Apache-2.0
#include "sysc/core/core_file.hpp"

#include <fmt/format.h>

#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

/// Reads a value that must be a number above 0 if it is present.
std::optional<double> positive(const Json& json, const char* name) {
    if (!json.contains(name) || json[name].is_null()) return std::nullopt;
    const double value = json[name].get<double>();
    if (!(value > 0)) throw std::invalid_argument(fmt::format("{} must be above 0", name));
    return value;
}

CoreParameters parameters_of(const Json& json) {
    CoreParameters parameters;
    const std::string build = json.value("build", "parallel");
    if (build != "parallel" && build != "serial") {
        throw std::invalid_argument("build must be parallel or serial");
    }
    parameters.build = build == "serial" ? Build::kSerial : Build::kParallel;
    for (const auto& [name, value] : json.at("parameters").items()) {
        const ref::Parameter* const row = ref::find_parameter(name);
        if (row == nullptr) {
            throw std::invalid_argument(
                fmt::format("{} is no parameter: there are {}", name, ref::parameter_names()));
        }
        parameters.*row->value = value.get<int>();
    }
    const std::string reason = ref::why_not_built(parameters);
    if (!reason.empty()) throw std::invalid_argument(reason);
    return parameters;
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
    const std::string text = ref::read_text_file(file);
    try {
        const Json json = Json::parse(text);
        CoreFile core{
            json.value("core", ""), parameters_of(json), json.value("device", ""), {}, {}, {}, {}};
        core.unit_mm = positive(json, "unit_mm");
        core.error_mm = positive(json, "error_mm");
        core.sample_period_s = positive(json, "sample_period_s");
        core.clock_hz = positive(json, "clock_hz");
        return core;
    } catch (const Json::exception& error) {
        throw ref::InputError(file, 0, std::string("is no core: ") + error.what());
    } catch (const std::invalid_argument& error) {
        throw ref::InputError(file, 0, error.what());
    }
}

}  // namespace curvecore::sysc
