// SPDX-License-Identifier: Apache-2.0
// Options that are values when the command line is read. Each is declared with its reader
// (readers.hpp); CLI11 reads them in the order of their declaration, so that a reader may look at
// an option declared before its own.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "sysc/commands/options/readers.hpp"

namespace curvecore::sysc {

/// Adds an option with one value; `default_val` behind it sets and shows a default.
template <class Value, class Read>
CLI::Option* add_value(CLI::App& command, const std::string& name, Value& value, const char* type,
                       const std::string& help, Read read) {
    const auto take = [&value, name, read](const std::string& text) { value = read(name, text); };
    return command.add_option_function<std::string>(name, take, help)
        ->type_name(type)
        ->run_callback_for_default();
}

/// Adds an option that may be given several times, with one value each; every value is kept.
template <class Value, class Read>
CLI::Option* add_values(CLI::App& command, const std::string& name, std::vector<Value>& values,
                        const char* type, const std::string& help, Read read) {
    const auto take = [&values, name, read](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) values.push_back(read(name, text));
    };
    return command.add_option_function<std::vector<std::string>>(name, take, help)
        ->type_name(type)
        ->allow_extra_args(false)
        ->take_all();
}

/// Adds an option that is its text: a file, a name.
inline CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& text,
                             const char* type, const std::string& help) {
    return command.add_option(name, text, help)->type_name(type);
}

/// Adds an option that is one of the names, which stand for {} in its help, and shows its default.
template <class Enum, std::size_t Count>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Enum& value,
                        const std::array<std::string_view, Count>& names, const char* help) {
    return add_value(command, name, value, "NAME",
                     fmt::format(fmt::runtime(help), fmt::join(names, ", ")), one_of<Enum>(names))
        ->default_str(std::string(names.at(static_cast<std::size_t>(value))));
}

/// Adds such an option without a default.
template <class Enum, std::size_t Count>
CLI::Option* add_choice(CLI::App& command, const std::string& name, std::optional<Enum>& value,
                        const std::array<std::string_view, Count>& names, const char* help,
                        const char* type = "NAME", const char* separator = ", ") {
    return add_value(command, name, value, type,
                     fmt::format(fmt::runtime(help), fmt::join(names, separator)),
                     one_of<Enum>(names));
}

/// Adds a command with its options; when the line is read, `run` takes them and returns the exit
/// status.
template <class Asked>
std::pair<CLI::App&, Asked&> add_command(CLI::App& app, int& status, const char* name,
                                         const char* what, int (*run)(Asked& asked)) {
    CLI::App* const command = app.add_subcommand(name, what);
    const auto asked = std::make_shared<Asked>();
    command->callback([asked, run, &status] { status = run(*asked); });
    return {*command, *asked};
}

}  // namespace curvecore::sysc
