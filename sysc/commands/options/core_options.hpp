// SPDX-License-Identifier: Apache-2.0
// Options of the core and of its clocks: what the command line says overrides what a file says.
#pragma once

#include <CLI/CLI.hpp>

#include "sysc/core/core_file.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

/// The core as the command line asks for it; unset: the file's value, or the default.
struct CoreChoice {
    std::string core;   // file
    std::string board;  // name or file
    CoreFile said;      // device, unit, error and clock that override those of the file
    std::optional<Build> build;
    std::vector<ParameterList> set;         // one value each
    std::vector<double> sample_periods_s;   // several: of `explore`
    std::vector<int> segment_queues_words;  // those of the board, if one is given
    std::vector<int> profile_queues_words;

    /// Sets core, unit, error limit, times and queues; of several values the shortest period and
    /// the longest queues. @throws UsageError, ref::InputError of the core's or board's file
    void apply(Options& options);
};

/// Defaults of the queues, and whether periods and queues are lists.
struct TimedValues {
    bool lists = false;
    std::string segment_queue = std::to_string(ref::kSegmentQueueWords);
    std::string profile_queue = std::to_string(ref::kProfileQueueWords);
};

/// Adds the options of the core and of its requirements.
void add_core(CLI::App& command, CoreChoice& core);
/// Adds the options of the core's clocks, queues and parameters.
void add_clocks(CLI::App& command, CoreChoice& core, Options& options, const TimedValues& values);

}  // namespace curvecore::sysc
