// SPDX-License-Identifier: Apache-2.0
// Sets of configurations for `compare`, and the columns of their table.
#pragma once

#include <vector>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// Returns every combination of the lists' values, the last parameter of the table varying fastest;
/// a parameter without a list is that of `core`.
/// @throws UsageError: there are too many
std::vector<CoreParameters> all_combinations(const CoreParameters& core,
                                             const std::vector<ParameterList>& lists);

/// Returns the parameters that a table of these configurations has as columns: the order, the
/// widths, and all that are not at their default everywhere.
std::vector<const ref::Parameter*> columns_of(const std::vector<CoreParameters>& configurations);

}  // namespace curvecore::sysc
