// SPDX-License-Identifier: Apache-2.0
// Commands about widths and queues. Each is added with its options, and sets the exit status when
// it has run.
#pragma once

#include <CLI/CLI.hpp>

namespace curvecore::sysc {

/// The smallest core that meets a requirement. Status: 0; 1 --confirm failed, or the placed and
/// routed core is too slow for the requirement; 3 no configuration meets it.
void add_choose(CLI::App& app, int& status);
/// Configurations side by side. Status: 0; 1 an error beyond its bound, or a missed end; 130
/// interrupted, with the finished configurations written.
void add_compare(CLI::App& app, int& status);
/// The shortest queues. Status: 0; 3 no queues fit any host.
void add_explore(CLI::App& app, int& status);

}  // namespace curvecore::sysc
