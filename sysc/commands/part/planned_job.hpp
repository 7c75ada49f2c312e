// SPDX-License-Identifier: Apache-2.0
// Planning and checks that a command does before it draws or writes anything.
#pragma once

#include "sysc/job/job_stream.hpp"

namespace curvecore::sysc {

/// Plans a whole job for its core, which is known by now, with the clock of its device, and checks
/// every word of the plan.
/// @throws UsageError, ref::InputError: take_device(), JobStream::all(), check_words()
Job plan_and_check(JobStream& stream);

}  // namespace curvecore::sysc
