// SPDX-License-Identifier: Apache-2.0
// `curvecore home`: drives the axes of a board's machine to their switches.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "sysc/job/options.hpp"
#include "sysc/wire/wire_options.hpp"

namespace curvecore::sysc {

struct RawHomeOptions {
    RawWireOptions wire;
    std::string axes;  // empty: all that have a switch
};

void add_home(CLI::App& command, RawHomeOptions& raw, Options& options);

/// Returns the exit status: 0 homed; 1 a switch was not found, the board ended the run or was lost;
/// 130 stopped by the operator.
int home_command(Options options, const RawHomeOptions& raw);

}  // namespace curvecore::sysc
