// SPDX-License-Identifier: Apache-2.0
// The parameters of a core as the command line sets them: names and ranges of hls/configuration.hpp
// and of the RTL.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ref/error_bound.hpp"

namespace curvecore::tb {

enum class Build { kParallel, kSerial };

struct CoreParameters {
    Build build = Build::kParallel;
    int order = 6;
    int coef_bits = 36;
    int position_bits = 32;
    int guard_bits = 10;
    int aux_axes = 0;
    int splines = 0;          // 1: draws splines besides lines and arcs
    int mode = 0;             // 0 series, 1 polynomial
    int sample_interval = 1;  // clocks per sample of the parallel build
    int turn_bits = 0;        // above 0: a width for each order, ref/order_words.hpp
    int parameter_guard = 0;  // fraction bits of a spline's parameter below those of tau

    int axes() const { return 3 + aux_axes; }
    ref::WordFormat format() const;
    /// Clocks of an integration step, of arcs and lines, and of splines: what the planner keeps
    /// time for.
    int network_latency() const;
    int spline_latency() const;
    /// "Order=6 CoefBits=36 ..."
    std::string text() const;
    nlohmann::ordered_json json() const;
};

bool operator==(const CoreParameters& a, const CoreParameters& b);

const char* build_name(Build build);

/// Names as --set takes them, in order.
std::vector<std::string> parameter_names();

/// Whether TurnBits may be above 0: lines and arcs in series mode, a sample a clock.
bool takes_turn_bits(const CoreParameters& parameters);
/// Whether ParameterGuard may be: the parallel build with splines.
bool takes_parameter_guard(const CoreParameters& parameters);
/// @throws UsageError: one of them is, and may not
void check_combination(const CoreParameters& parameters);

/// Name=Value.
/// @throws UsageError: unknown name, not a number, out of range
void set_parameter(CoreParameters& parameters, const std::string& assignment);

}  // namespace curvecore::tb
