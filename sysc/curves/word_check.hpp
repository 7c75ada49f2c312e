// SPDX-License-Identifier: Apache-2.0
// Check of a plan in the core's words: no segment leaves their range.
#pragma once

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Quantises every segment of a part of the job's plan and draws its integration steps. The planner
/// has proven that they keep their words; this checks the actual ones, but for those of tables.
/// @throws ref::InputError with the move's line
void check_words(const Job& job, const ref::Plan& part);

}  // namespace curvecore::sysc
