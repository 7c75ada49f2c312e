// SPDX-License-Identifier: Apache-2.0
// Properties that a device gives a core: its multipliers, and the clock that it is estimated to
// reach.
#pragma once

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Sets, with options.device, the core's MultiplierForm, and the clock that the core reaches there
/// by the cost model, less the model's error. To be called when the core is known.
/// @throws UsageError: no such device, or no measured runs of the build for it
void take_device(Options& options);

}  // namespace curvecore::sysc
