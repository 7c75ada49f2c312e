// SPDX-License-Identifier: Apache-2.0
// A motion merged into fewer phases.
#pragma once

#include <vector>

#include "ref/feed/optimum/run_path.hpp"

namespace curvecore::ref {

/// Returns the fewest phases that keep the limits, and the acceleration at their ends to within
/// what no window of the machine's joint time sees. Ends of phases are places, speeds and times of
/// the run.
/// @param mends of each phase; those that have any stay as they are
std::vector<Phase> merged_phases(const std::vector<Phase>& run, const std::vector<int>& mends,
                                 const RunPath& path, const Machine& machine);

}  // namespace curvecore::ref
