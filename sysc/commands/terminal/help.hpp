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

/// Adds examples below each help; rare options are hidden unless one of the arguments is
/// --help-all. To be called after all commands are added.
void finish_help(CLI::App& app, const std::vector<std::string>& arguments);

/// Rewrites `help run` as `run --help`.
std::vector<std::string> asked_help(std::vector<std::string> arguments);

/// Refuses a first word that is no command, and an option that the command does not have.
/// @throws UsageError with the nearest name
void check_names(const CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace curvecore::sysc
