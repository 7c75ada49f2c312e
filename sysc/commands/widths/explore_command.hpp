// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "sysc/job/options.hpp"

namespace curvecore::sysc {

/// The command line as text, with lists.
struct RawExplore {
    RawExplore();

    RawOptions common;  // options with lists of sample periods and queues
    std::string host = "1ms,20ms,100ms,500ms";
    std::string word = "1us,500us";
    std::string jitter = "0ms";
};

/// Adds the options besides the common ones.
void add_explore(CLI::App& command, RawExplore& explore);

/// @throws UsageError, ref::InputError
int explore_command(const RawExplore& explore, Options options);

}  // namespace curvecore::sysc
