// SPDX-License-Identifier: Apache-2.0
// Parameters as text, and which combinations of them are built.
#pragma once

#include <string>

#include "ref/format/parameters.hpp"

namespace curvecore::ref {

/// Why there is no core with these parameters; empty: there is one.
std::string why_not_built(const CoreParameters& parameters);
/// Every value is in its range and with what it needs.
inline bool legal(const CoreParameters& parameters) { return why_not_built(parameters).empty(); }

/// The row of a name, or nullptr.
const Parameter* find_parameter(const std::string& name);
/// "Order must be in [2, 12]", as the RTL says it.
std::string range_text(const Parameter& row);
/// "Order, CoefBits, ..."
std::string parameter_names();
/// "Order=6 CoefBits=36 ...", every parameter.
std::string parameters_text(const CoreParameters& parameters);
/// "parallel" or "serial".
const char* build_name(Build build);

}  // namespace curvecore::ref
