// SPDX-License-Identifier: Apache-2.0
// Commands of boards at the other end of a wire. Each is added with its options, and sets the exit
// status when it has run.
#pragma once

#include <CLI/CLI.hpp>

#include "sysc/wire/wire_options.hpp"

namespace curvecore::sysc {

/// A virtual board, which runs until it is interrupted.
void add_board(CLI::App& app, int& status);

/// The axes of a board's machine to their switches. Status: 0 homed; 1 a switch was not found, the
/// board ended the run or was lost; 130 stopped by the operator.
void add_home(CLI::App& app, int& status);

/// A program to a board. Status: 0 drawn to its end; 1 the board ended it or was lost; 130 stopped
/// by the operator.
void add_stream(CLI::App& app, int& status);

/// Adds the options of a board's link and of its drives.
void add_wire(CLI::App& command, WireOptions& wire);

}  // namespace curvecore::sysc
