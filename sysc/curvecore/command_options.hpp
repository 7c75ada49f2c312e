// SPDX-License-Identifier: Apache-2.0
// Options that commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sysc/job/options.hpp"

namespace curvecore::sysc {

constexpr const char* kAlongPoints = "along points: 10m/min, 100mm/s, 40in/min";

/// A text with its default.
CLI::Option* add_text(CLI::App& command, const char* name, std::string& text, const char* type,
                      const std::string& help);
/// May be given again and again.
CLI::Option* add_list(CLI::App& command, const char* name, std::vector<std::string>& list,
                      const char* type, const std::string& help);
/// Who reads G-code.
void add_interpreter(CLI::App& command, RawOptions& raw);
/// Where results go, on which machine, in which unit.
void add_surroundings(CLI::App& command, RawOptions& raw, Options& options);
/// FILE, and what is read with it.
CLI::Option* add_input(CLI::App& command, RawOptions& raw, Options& options, std::string& feed,
                       const char* feeds, const std::string& feed_help);
/// The core and what it is asked to keep.
void add_core(CLI::App& command, RawOptions& raw);
/// How a program is planned.
void add_planning(CLI::App& command, RawOptions& raw);
/// How fast feeds are.
void add_override(CLI::App& command, RawOptions& raw);
/// The core and its clocks.
void add_timed_core(CLI::App& command, RawOptions& raw);
/// What run, plan and words share.
void add_common(CLI::App& command, RawOptions& raw, Options& options);
/// Of what `run` and `plan` leave behind.
void add_report(CLI::App& command, Options& options);
/// Of run, and what runs at its end.
void add_run(CLI::App& command, RawOptions& raw, Options& options);

}  // namespace curvecore::sysc
