// SPDX-License-Identifier: Apache-2.0
// What --help shows, and what a mistyped name may have meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace curvecore::sysc {

/// Groups of options in a command's help. Those that are rarely wanted are shown by --help-all.
namespace group {
constexpr const char* kInput = "Input";
constexpr const char* kCore = "Core";
constexpr const char* kPlan = "Plan";
constexpr const char* kBoard = "Board";
constexpr const char* kOutput = "Output";
constexpr const char* kRare = "More";
}  // namespace group

/// Options that are added to the command from here on stand in this group.
void begin_group(CLI::App& command, const char* group);

/// Before any command is added: -h, --help and --help-all, and names in any case.
void begin_help(CLI::App& app);

/// After all of them: examples below each help; the rare options are hidden unless one of the
/// arguments is --help-all.
void finish_help(CLI::App& app, const std::vector<std::string>& arguments);

/// `help run` asks for `run --help`.
std::vector<std::string> asked_help(std::vector<std::string> arguments);

/// Refuses a first word that is no command, and an option that the command does not have.
/// @throws UsageError with the nearest name
void check_names(const CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace curvecore::sysc
