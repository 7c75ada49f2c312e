// SPDX-License-Identifier: Apache-2.0
// The subcommands: each returns the exit status 0 (every check held) or 1 (one failed).
#pragma once

#include "sysc/job/job.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

int run_command(const Options& options);
int plan_command(const Options& options);
int words_command(const Options& options);

}  // namespace curvecore::sysc
