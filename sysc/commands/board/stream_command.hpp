// SPDX-License-Identifier: Apache-2.0
// `curvecore stream`: a program to a board at the other end of a wire.
#pragma once

#include <CLI/CLI.hpp>

#include "sysc/job/options.hpp"
#include "sysc/wire/wire_options.hpp"

namespace curvecore::sysc {

void add_wire(CLI::App& command, RawWireOptions& raw);

/// Returns the exit status: 0 drawn to its end; 1 the board ended it or was lost; 130 stopped by
/// the operator.
int stream_command(Options options, const RawWireOptions& wire);

}  // namespace curvecore::sysc
