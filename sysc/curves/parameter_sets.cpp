// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/parameter_sets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

constexpr std::size_t kMost = 5000;

}  // namespace

std::vector<CoreParameters> all_combinations(const CoreParameters& core,
                                             const std::vector<ParameterList>& lists) {
    std::size_t count = 1;
    for (const ParameterList& list : lists) count *= list.values.size();
    if (count > kMost) {
        throw UsageError(
            fmt::format("{} configurations are asked for, {} are the most", count, kMost));
    }
    std::vector<CoreParameters> all{core};
    for (const ref::Parameter& row : ref::kParameters) {
        const auto list = std::find_if(lists.begin(), lists.end(), [&](const ParameterList& one) {
            return one.row->value == row.value;
        });
        if (list == lists.end()) continue;
        std::vector<CoreParameters> more;
        for (CoreParameters parameters : all) {
            for (const int value : list->values) {
                parameters.*row.value = value;
                more.push_back(parameters);
            }
        }
        all = std::move(more);
    }
    return all;
}

std::vector<const ref::Parameter*> columns_of(const std::vector<CoreParameters>& configurations) {
    std::vector<const ref::Parameter*> columns;
    for (const ref::Parameter& row : ref::kParameters) {
        const bool size = row.default_value > 1;  // the order and the widths
        const bool other = std::any_of(
            configurations.begin(), configurations.end(),
            [&](const CoreParameters& one) { return one.*row.value != row.default_value; });
        if (size || other) columns.push_back(&row);
    }
    return columns;
}

}  // namespace curvecore::sysc
