// SPDX-License-Identifier: Apache-2.0
// `curvecore join`: an idle move between two working paths.
#pragma once

#include <string>

#include "sysc/job/options.hpp"

namespace curvecore::sysc {

/// The command line as text; empty: not given, so --load gives it, or the default stands.
struct RawJoinOptions {
    std::string a, b;
    std::string load;
    std::string fit, points, least, speed;
    std::string tolerance, step;
    bool exact = false;
};

/// Designs the move, writes join.ngc, join.json and join.html, and runs join.ngc as `run` does.
/// Returns the exit status: 0 every check held, 1 one failed.
/// @throws UsageError, ref::InputError
int join_command(const Options& options, const RawJoinOptions& raw);

}  // namespace curvecore::sysc
