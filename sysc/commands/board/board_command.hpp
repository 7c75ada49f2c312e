// SPDX-License-Identifier: Apache-2.0
// `curvecore board`: a virtual board that listens.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "sysc/link/link.hpp"

namespace curvecore::sysc {

struct BoardOptions {
    std::string listen = kWireAddress;
    std::string folder;  // empty: no steps.csv
    bool fast = false;
    std::vector<std::string> home;
    bool limits = false;
    std::vector<std::string> slip;
    std::string lag = "0ms";
};

void add_board(CLI::App& command, BoardOptions& options);

/// Runs the board until it is interrupted.
int board_command(const BoardOptions& options);

}  // namespace curvecore::sysc
