// SPDX-License-Identifier: Apache-2.0
// Every segment of a plan in the core's words: none may leave its range.
#pragma once

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Quantises every segment of a part of the job's plan and draws its integration steps, which the
/// planner has proven to keep their words: a second look, at these very ones.
/// @throws ref::InputError with the move's line
void check_words(const Job& job, const ref::Plan& part);

}  // namespace curvecore::sysc
