// SPDX-License-Identifier: Apache-2.0
#include "sysc/core/core_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sysc/cli/choice.hpp"
#include "sysc/cli/number_list.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

CoreParameters widest_words() {
    CoreParameters widest;
    for (const auto value :
         {&CoreParameters::order, &CoreParameters::coef_bits, &CoreParameters::guard_bits}) {
        widest.*value = ref::parameter_of(value).high;
    }
    widest.mode = 1;
    return widest;
}

nlohmann::ordered_json parameters_json(const CoreParameters& parameters) {
    nlohmann::ordered_json json;
    for (const ref::Parameter& row : ref::kParameters) json[row.name] = parameters.*row.value;
    return json;
}

ParameterList read_parameter(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        throw UsageError(fmt::format("--set {}: Name=Value is expected", text));
    }
    const std::string name = text.substr(0, equals);
    const auto row =
        std::find_if(std::begin(ref::kParameters), std::end(ref::kParameters),
                     [&name](const ref::Parameter& one) { return same_name(one.name, name); });
    if (row == std::end(ref::kParameters)) {
        throw UsageError(
            fmt::format("--set {}: unknown parameter; there are {}", name, ref::parameter_names()));
    }
    const std::string values = text.substr(equals + 1);
    ParameterList list{&*row, number_list("--set " + name, values, row->low, row->high)};
    for (const int value : list.values) {
        if (!row->holds(value)) throw UsageError("--set " + ref::range_text(*row));
    }
    return list;
}

ParameterList single_parameter(const std::string& text) {
    ParameterList list = read_parameter(text);
    if (list.values.size() > 1) {
        throw UsageError(fmt::format("--set {}: one value is expected; compare takes lists", text));
    }
    return list;
}

}  // namespace curvecore::sysc
