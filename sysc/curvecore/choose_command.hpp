// SPDX-License-Identifier: Apache-2.0
// `curvecore choose`.
#pragma once

#include "tb/choose/wish_options.hpp"

namespace curvecore::tb {

constexpr int kImpossibleWish = 3;  // exit status

/// Returns the exit status: 0; 1 --confirm failed, or placed and routed too slow for the wish; 3 no
/// configuration keeps the wish.
int choose_command(const ChooseOptions& options);

}  // namespace curvecore::tb
