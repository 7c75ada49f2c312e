// SPDX-License-Identifier: Apache-2.0
// The parameters of a core as the command line sets them and as JSON (ref/format/parameters.def).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ref/format/parameter_text.hpp"

namespace curvecore::sysc {

using ref::Build;
using ref::build_name;
using ref::CoreParameters;

/// The widest words there are: no core needs fewer segments.
CoreParameters widest_words();

nlohmann::ordered_json parameters_json(const CoreParameters& parameters);

/// Values of one parameter, as --set has them.
struct ParameterList {
    const ref::Parameter* row;
    std::vector<int> values;
};

/// Name=LIST, sysc/cli/number_list.hpp.
/// @throws UsageError: unknown name, no such list, a value out of range
ParameterList read_parameter(const std::string& text);

/// Name=Value. Returns the parameter that it set.
/// @throws UsageError, also where there are several values
const ref::Parameter& set_parameter(CoreParameters& parameters, const std::string& text);

}  // namespace curvecore::sysc
