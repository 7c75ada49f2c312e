// SPDX-License-Identifier: Apache-2.0
// Options that commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sysc/job/options.hpp"

namespace curvecore::sysc {

constexpr const char* kAlongPoints = "along points: 10m/min, 100mm/s, 40in/min";

/// Adds a text with its default.
CLI::Option* add_text(CLI::App& command, const char* name, std::string& text, const char* type,
                      const std::string& help);
/// Adds an option that may be given several times.
CLI::Option* add_list(CLI::App& command, const char* name, std::vector<std::string>& list,
                      const char* type, const std::string& help);
/// Adds the options that choose the interpreter of G-code.
void add_interpreter(CLI::App& command, RawOptions& raw);
/// Adds the options of output folder, machine and unit.
void add_surroundings(CLI::App& command, RawOptions& raw, Options& options);
/// Adds FILE, and the options of how it is read.
CLI::Option* add_input(CLI::App& command, RawOptions& raw, Options& options, std::string& feed,
                       const char* feeds, const std::string& feed_help);
/// Adds the options of the core and of its requirements.
void add_core(CLI::App& command, RawOptions& raw);
/// Adds the options of planning.
void add_planning(CLI::App& command, RawOptions& raw);
/// Adds the options of the feed override.
void add_override(CLI::App& command, RawOptions& raw);
/// Adds the options of the core and its clocks.
void add_timed_core(CLI::App& command, RawOptions& raw);
/// Adds the options that run, plan and words share.
void add_common(CLI::App& command, RawOptions& raw, Options& options);
/// Adds the options of the files that `run` and `plan` write.
void add_report(CLI::App& command, Options& options);
/// Adds the options of `run`, and of commands that end with a run.
void add_run(CLI::App& command, RawOptions& raw, Options& options);

}  // namespace curvecore::sysc
