// SPDX-License-Identifier: Apache-2.0
// Commands that make a program and run it as `run` does. Each is added with its options, and sets
// the exit status when it has run: 0 every check held, 1 one failed.
#pragma once

#include <CLI/CLI.hpp>

namespace curvecore::sysc {

/// A volumetric cam.
void add_cam(CLI::App& app, int& status);
/// A curve's table. Status: 0; 1 a row leaves its range.
void add_curve(CLI::App& app, int& status);
/// An idle move between two working paths.
void add_join(CLI::App& app, int& status);

}  // namespace curvecore::sysc
