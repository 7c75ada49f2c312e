// SPDX-License-Identifier: Apache-2.0
// What a command needs before it draws or writes anything.
#pragma once

#include "sysc/host/job.hpp"

namespace curvecore::sysc {

/// Plans for the job's core, which is known by now, with the clock of its device, and looks at
/// every word of the plan.
/// @throws UsageError, ref::InputError: take_device(), plan_job(), check_words()
void plan_and_check(Job& job);

}  // namespace curvecore::sysc
