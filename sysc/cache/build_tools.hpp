// SPDX-License-Identifier: Apache-2.0
// The tools that make cores: Verilator, make and the compiler.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace curvecore::sysc {

/// Checks that the tools are those that the program was made with; cores need the same.
/// @throws UsageError which one is missing, or of another version
void check_build_tools();

/// Returns true if there is a tool of that name in PATH.
bool in_path(const std::string& tool);

/// Runs a program in a folder, with its output in a file. Returns its exit status.
int run_tool(const std::vector<std::string>& arguments, const std::filesystem::path& log,
             const std::filesystem::path& folder = ".");

/// Returns stdout and stderr of a command of the shell.
std::string output_of(const std::string& command);

/// Reason of a failure from a tool's output: its first line with an error, or its last line.
std::string reason_in(const std::filesystem::path& log);

}  // namespace curvecore::sysc
