// SPDX-License-Identifier: Apache-2.0
// Commands of a part. Each is added with its options, and sets the exit status when it has run: 0
// every check held, 1 one failed.
#pragma once

#include <CLI/CLI.hpp>

namespace curvecore::sysc {

/// Planned and drawn by a board; every sample is compared.
void add_run(CLI::App& app, int& status);
/// Planned without a board.
void add_plan(CLI::App& app, int& status);
/// Words as memory files.
void add_words(CLI::App& app, int& status);
/// The same, and the samples that come of them.
void add_vectors(CLI::App& app, int& status);

}  // namespace curvecore::sysc
