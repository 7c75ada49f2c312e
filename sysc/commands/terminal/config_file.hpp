// SPDX-License-Identifier: Apache-2.0
// Defaults of options from a file: `name = value` lines in TOML, those below [run] of the command
// run alone. What the command line says replaces them; a switch is true or false, a list an array.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

/// File of the working folder that is read if it is there, and --config names no other.
constexpr const char* kConfigFile = "curvecore.toml";

/// Adds --config to every command. To be called after all commands are added.
void add_config(CLI::App& app);

/// A command line with a file's defaults in it.
class ConfigFile {
  public:
    /// @throws ref::InputError with the line: a command or an option that is not there, or no
    /// `name = value`; UsageError: --config names no file
    ConfigFile(CLI::App& app, std::vector<std::string> arguments);

    const std::vector<std::string>& arguments() const { return arguments_; }
    /// Says on stderr which options a file gave that nobody named, unless that is to be quiet.
    void report() const;
    /// @throws ref::InputError with the line of the option that an error is about, if the file gave
    /// it
    void place(const UsageError& error) const;

  private:
    struct Given {
        int line;
        std::vector<std::string> arguments;
    };
    void take(CLI::App& app, const std::string& text);
    void take_item(CLI::App& app, const std::string& section, const CLI::ConfigItem& item);
    std::vector<std::string> arguments_of(const CLI::Option& option, const std::string& name,
                                          const std::vector<std::string>& values) const;
    [[noreturn]] void refuse(const std::string& reason) const;

    std::string file_;
    bool named_ = false;
    int line_ = 0;
    std::map<std::string, Given> given_;  // by option, "--unit"
    std::vector<std::string> arguments_;
};

}  // namespace curvecore::sysc
