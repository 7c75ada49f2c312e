// SPDX-License-Identifier: Apache-2.0
// Every segment of a plan in the core's words: none may leave its range.
#pragma once

#include "sysc/host/job.hpp"

namespace curvecore::sysc {

/// Quantises every segment and draws its integration steps, which the planner has proven to keep
/// their words: a second look, at this very part.
/// @throws ref::InputError with the move's line
void check_words(const Job& job);

}  // namespace curvecore::sysc
