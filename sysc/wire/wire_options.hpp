// SPDX-License-Identifier: Apache-2.0
// Options of `stream` besides the program: the board's link, and the drives at its pins.
#pragma once

#include <string>

#include "sysc/job/options.hpp"
#include "sysc/wire/remote_machine.hpp"

namespace curvecore::sysc {

struct RawWireOptions {
    std::string to;
    std::string steps_per_mm = "400";
    std::string steplen = "2us";
    std::string stepspace = "2us";
    std::string dirsetup = "4us";
    std::string dirhold = "4us";
    std::string watchdog = "500ms";
    std::string control;
};

/// Returns the drives of a board's axes. @throws UsageError
Drives drives_of(const RawWireOptions& raw, int axes);

/// Sets the options to plan for this board.
void plan_for(const RemoteBuild& build, Options& options);
/// Sets the options to plan for the board at the end of this link, which is only read.
/// @throws UsageError: no board is there, or one of another kind
void plan_for(const std::string& link, Options& options);

/// Reads a duration, s; units ns, us, ms, s. @throws UsageError
double duration_of(const std::string& option, const std::string& text);

}  // namespace curvecore::sysc
