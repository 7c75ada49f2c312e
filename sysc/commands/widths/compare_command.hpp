// SPDX-License-Identifier: Apache-2.0
// `curvecore compare`.
#pragma once

#include "sysc/compare/compare_options.hpp"

namespace curvecore::sysc {

/// Returns the exit status: 0; 1 an error beyond its bound, or a missed end; 130 interrupted, with
/// the finished configurations written.
/// @throws ref::InputError
int compare_command(CompareOptions options);

}  // namespace curvecore::sysc
