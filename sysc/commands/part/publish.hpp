// SPDX-License-Identifier: Apache-2.0
// Results of `plan` and `run`: segments.json, report.json, report.html, and the summary.
#pragma once

#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/report/report.hpp"

namespace curvecore::sysc {

/// Completes the folder and prints the summary. Returns the exit status: 0 every check held, 1 one
/// failed.
int publish(const Report& report, const Pictures& pictures, OutputFolder& folder);

}  // namespace curvecore::sysc
