// SPDX-License-Identifier: Apache-2.0
// Many configurations: those that `compare` is asked for, and what a table says of them.
#pragma once

#include <vector>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// Every combination of the lists' values, the last parameter of the table varying fastest; a
/// parameter without a list is that of `core`.
/// @throws UsageError: there are too many
std::vector<CoreParameters> all_combinations(const CoreParameters& core,
                                             const std::vector<ParameterList>& lists);

/// The parameters that a table of these configurations has as columns: the order, the widths, and
/// what is not its default in all of them.
std::vector<const ref::Parameter*> columns_of(const std::vector<CoreParameters>& configurations);

}  // namespace curvecore::sysc
