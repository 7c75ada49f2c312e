// SPDX-License-Identifier: Apache-2.0
// `curvecore completion`: what a shell needs to complete commands and options.
#pragma once

#include <CLI/CLI.hpp>

namespace curvecore::sysc {

/// Adds the command, which prints a script for bash of the commands that the program has then.
/// Status: 0.
void add_completion(CLI::App& app, int& status);

}  // namespace curvecore::sysc
