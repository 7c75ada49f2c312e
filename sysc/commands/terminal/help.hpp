// SPDX-License-Identifier: Apache-2.0
// Help texts, and suggestions for mistyped names.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace curvecore::sysc {

/// Groups of options in a command's help. Rarely used ones are shown by --help-all.
namespace group {
constexpr const char* kInput = "Input";
constexpr const char* kCore = "Core";
constexpr const char* kPlan = "Plan";
constexpr const char* kBoard = "Board";
constexpr const char* kOutput = "Output";
constexpr const char* kRare = "More";
}  // namespace group

/// Puts the options that are added to the command from here on into this group.
void begin_group(CLI::App& command, const char* group);

/// Adds -h, --help and --help-all, and makes names independent of case. To be called before any
/// command is added.
void begin_help(CLI::App& app);

/// Reads the line and runs its command; help is shown whatever else stands beside --help. To be
/// called after all commands are added.
/// @throws UsageError: an unknown command or option, with the nearest name, or an invalid line;
/// what the command throws
void parse(CLI::App& app, std::vector<std::string> arguments);

}  // namespace curvecore::sysc
