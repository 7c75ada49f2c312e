// SPDX-License-Identifier: Apache-2.0
// Parameters of a core as the command line sets them and as JSON (ref/format/parameters.def).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ref/format/parameter_text.hpp"

namespace curvecore::sysc {

using ref::Build;
using ref::build_name;
using ref::CoreParameters;

/// The widest words that exist: no core needs fewer segments.
CoreParameters widest_words();

nlohmann::ordered_json parameters_json(const CoreParameters& parameters);

/// Values of one parameter, as --set lists them.
struct ParameterList {
    const ref::Parameter* row;
    std::vector<int> values;

    /// Sets the parameter to the first value.
    void set(CoreParameters& parameters) const { parameters.*row->value = values.front(); }
};

/// Reads Name=LIST, sysc/cli/number_list.hpp.
/// @throws UsageError: unknown name, invalid list, a value out of range
ParameterList read_parameter(const std::string& text);

/// Reads Name=Value. @throws UsageError, also where there are several values
ParameterList single_parameter(const std::string& text);

}  // namespace curvecore::sysc
