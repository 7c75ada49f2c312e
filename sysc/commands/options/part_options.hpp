// SPDX-License-Identifier: Apache-2.0
// Options of a part, of its plan and of its run, which commands share.
#pragma once

#include <functional>

#include "sysc/commands/options/core_options.hpp"

namespace curvecore::sysc {

/// Options of a command that plans a part.
struct PartOptions {
    Options options;
    CoreChoice core;
    bool linuxcnc = false;                  // LinuxCNC's interpreter reads G-code
    std::string tools;                      // file; empty: not given
    std::optional<double> radii_tolerance;  // mm, --arc-tolerance

    /// Completes the options and checks that they go together. @throws UsageError; ref::InputError
    /// of a file that they name
    const Options& complete();
};

/// Adds the options that choose the interpreter of G-code.
void add_interpreter(CLI::App& command, PartOptions& part);
/// Adds the options of output folder, machine and unit.
void add_surroundings(CLI::App& command, PartOptions& part);
/// Adds FILE, and the options of how it is read.
CLI::Option* add_file(CLI::App& command, PartOptions& part);
/// Adds the feed along points.
void add_feed(CLI::App& command, PartOptions& part,
              const char* along = "along points: 10m/min, 100mm/s, 40in/min");
/// Adds FILE, and the options of its feed and surroundings.
CLI::Option* add_input(CLI::App& command, PartOptions& part);
/// Adds the options of planning.
void add_planning(CLI::App& command, PartOptions& part);
/// Adds the options of the feed override.
void add_override(CLI::App& command, PartOptions& part);
/// Adds the options of the core and its clocks, and of planning.
void add_timed_core(CLI::App& command, PartOptions& part, const TimedValues& values = {});
/// Adds the options that run, plan and words share.
void add_common(CLI::App& command, PartOptions& part, const TimedValues& values = {});
/// Adds the options of the files that `run` and `plan` write.
void add_report(CLI::App& command, PartOptions& part);
/// Adds the options of `run`, and of commands that end with a run.
void add_drawing(CLI::App& command, PartOptions& part);

/// Reads FILE and options as `plan` takes them, for who calls without a command line; `more` adds
/// further ones. The options are quiet.
/// @throws UsageError, ref::InputError, as a command does
Options read_part_options(std::vector<std::string> arguments,
                          const std::function<void(CLI::App&, PartOptions&)>& more = nullptr);

}  // namespace curvecore::sysc
