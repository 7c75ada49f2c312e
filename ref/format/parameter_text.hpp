// SPDX-License-Identifier: Apache-2.0
// Parameters as text, and the rule which combinations of them are built.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "ref/format/parameters.hpp"

namespace curvecore::ref {

/// Names of the builds, in their order.
constexpr std::array<std::string_view, 3> kBuildNames{"parallel", "serial", "engine"};

/// Returns the reason why there is no core with these parameters; empty if there is one.
std::string why_not_built(const CoreParameters& parameters);
/// Returns true if every value is in its range and has what it needs.
inline bool legal(const CoreParameters& parameters) { return why_not_built(parameters).empty(); }

/// Returns the row of a name, or nullptr.
const Parameter* find_parameter(const std::string& name);
/// Returns "Order must be in [2, 12]", the message of the RTL.
std::string range_text(const Parameter& row);
/// Returns "Order, CoefBits, ...".
std::string parameter_names();
/// Returns "Order=6 CoefBits=36 ...", every parameter.
std::string parameters_text(const CoreParameters& parameters);
/// Returns "parallel", "serial" or "engine".
const char* build_name(Build build);

}  // namespace curvecore::ref
