// SPDX-License-Identifier: Apache-2.0
// `curvecore choose`.
#pragma once

#include "sysc/commands/widths/requirement_options.hpp"

namespace curvecore::sysc {

constexpr int kImpossible = 3;  // exit status

/// Returns the exit status: 0; 1 --confirm failed, or the placed and routed core is too slow for
/// the requirement; 3 no configuration meets the requirement.
int choose_command(const ChooseOptions& options);

}  // namespace curvecore::sysc
