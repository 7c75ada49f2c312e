// SPDX-License-Identifier: Apache-2.0
#include "tb/command/core_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "ref/order_words.hpp"
#include "tb/command/usage_error.hpp"

namespace curvecore::tb {
namespace {

struct Parameter {
    const char* name;
    int CoreParameters::*value;
    int low;
    int high;
};

constexpr std::array<Parameter, 10> kParameters{{
    {"Order", &CoreParameters::order, 2, 12},
    {"CoefBits", &CoreParameters::coef_bits, 18, 36},
    {"PositionBits", &CoreParameters::position_bits, 16, 32},
    {"GuardBits", &CoreParameters::guard_bits, 2, 12},
    {"AuxAxes", &CoreParameters::aux_axes, 0, 6},
    {"Splines", &CoreParameters::splines, 0, 1},
    {"Mode", &CoreParameters::mode, 0, 1},
    {"SampleInterval", &CoreParameters::sample_interval, 1, 8},
    {"TurnBits", &CoreParameters::turn_bits, 0, ref::kMostTurnBits},
    {"ParameterGuard", &CoreParameters::parameter_guard, 0, ref::kMostParameterGuard},
}};

}  // namespace

const char* build_name(Build build) { return build == Build::kParallel ? "parallel" : "serial"; }

ref::WordFormat CoreParameters::format() const {
    return {order, coef_bits, position_bits, guard_bits, mode == 1, turn_bits, parameter_guard};
}

int CoreParameters::network_latency() const {
    // Parallel: as rtl/spherical_interpolator.sv states it; serial: two products a node and order,
    // one after the other through a pipeline of nine clocks, and the step before.
    const int digits = (coef_bits + 1) / 2;
    return build == Build::kParallel ? order * (digits + 3) + 7 : order * 18 + 60;
}

int CoreParameters::spline_latency() const {
    // Serial: as rtl/curve_interpolator_serial.sv states a step's pause, without axes.
    if (build == Build::kSerial) {
        const int series = mode == 0 ? 3 * order * (order + 11) / 2 : 0;
        return 4 * order * order + 39 * order + 9 * (order + 3) + 120 + series;
    }
    // As rtl/network/spline_steps.sv and rtl/control/spline_sequencer.sv state it, and two clocks
    // from a step to the next.
    const int digits = (coef_bits + 1) / 2;
    const int top = order - 1;
    const int series = mode == 0 ? 4 * order + 15 : 0;
    const int rest = std::max(series, order + digits + 6);
    return 92 + 9 * top * (top + 1) / 2 + 27 * top + std::max(0, 2 * digits - 31) + rest + 1 + 2;
}

std::string CoreParameters::text() const {
    std::string text;
    for (const Parameter& parameter : kParameters) {
        text +=
            fmt::format("{}{}={}", text.empty() ? "" : " ", parameter.name, this->*parameter.value);
    }
    return text;
}

nlohmann::ordered_json CoreParameters::json() const {
    nlohmann::ordered_json json;
    for (const Parameter& parameter : kParameters) {
        json[parameter.name] = this->*parameter.value;
    }
    return json;
}

bool operator==(const CoreParameters& a, const CoreParameters& b) {
    for (const Parameter& parameter : kParameters) {
        if (a.*parameter.value != b.*parameter.value) return false;
    }
    return a.build == b.build;
}

std::vector<std::string> parameter_names() {
    std::vector<std::string> names;
    names.reserve(kParameters.size());
    for (const Parameter& parameter : kParameters) names.emplace_back(parameter.name);
    return names;
}

bool takes_turn_bits(const CoreParameters& parameters) {
    return parameters.build == Build::kParallel && parameters.splines == 0 &&
           parameters.mode == 0 && parameters.sample_interval == 1;
}

bool takes_parameter_guard(const CoreParameters& parameters) {
    return parameters.build == Build::kParallel && parameters.splines == 1;
}

void check_combination(const CoreParameters& parameters) {
    if (parameters.turn_bits > 0 && !takes_turn_bits(parameters)) {
        throw UsageError(
            "TurnBits works with --build parallel, Splines=0, Mode=0 and SampleInterval=1 only");
    }
    // Splines is set by the program, if it is not said.
    if (parameters.parameter_guard > 0 && parameters.build != Build::kParallel) {
        throw UsageError("ParameterGuard works with --build parallel only");
    }
}

void set_parameter(CoreParameters& parameters, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        throw UsageError(fmt::format("--set {}: Name=Value is expected", assignment));
    }
    const std::string name = assignment.substr(0, equals);
    for (const Parameter& parameter : kParameters) {
        if (name != parameter.name) continue;
        int value = 0;
        const char* end = assignment.data() + assignment.size();
        const auto result = std::from_chars(assignment.data() + equals + 1, end, value);
        if (result.ec != std::errc() || result.ptr != end) {
            throw UsageError(fmt::format("--set {}: not a whole number", assignment));
        }
        const bool power_of_two = (value & (value - 1)) == 0;
        if (value < parameter.low || value > parameter.high ||
            (parameter.value == &CoreParameters::sample_interval && !power_of_two)) {
            throw UsageError(
                parameter.value == &CoreParameters::sample_interval
                    ? "SampleInterval must be 1, 2, 4 or 8"
                    : fmt::format("{} must be in [{}, {}]", name, parameter.low, parameter.high));
        }
        parameters.*parameter.value = value;
        return;
    }
    throw UsageError(fmt::format("--set {}: unknown parameter; there are {}", name,
                                 fmt::join(parameter_names(), ", ")));
}

}  // namespace curvecore::tb
