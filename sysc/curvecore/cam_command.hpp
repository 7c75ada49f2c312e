// SPDX-License-Identifier: Apache-2.0
// `curvecore cam`.
#pragma once

#include "sysc/cam/cam_options.hpp"

namespace curvecore::sysc {

/// Returns the exit status: 0 every check held, 1 one failed.
int cam_command(const CamOptions& options);

}  // namespace curvecore::sysc
