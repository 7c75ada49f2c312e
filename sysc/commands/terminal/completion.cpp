// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/completion.hpp"

#include <fmt/format.h>

#include <string>

namespace curvecore::sysc {
namespace {

/// Words that do not begin as options do are names of files, bash's own completion.
constexpr const char* kScript =
    R"(# Completion of curvecore in bash, and in zsh behind bashcompinit.
_curvecore() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} words=
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        words="{commands} help"
    elif [[ $word == -* || ${{COMP_WORDS[1]}} == help ]]; then
        case ${{COMP_WORDS[1]}} in
            help) words="{commands}" ;;
{options}        esac
    fi
    [ -z "$words" ] || COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _curvecore curvecore
)";

void print_script(const CLI::App& app) {
    std::string commands;
    std::string options;
    for (const CLI::App* command : app.get_subcommands({})) {
        commands += (commands.empty() ? "" : " ") + command->get_name();
        std::string names;
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                names += (names.empty() ? "--" : " --") + name;
            }
        }
        options += fmt::format("            {}) words=\"{}\" ;;\n", command->get_name(), names);
    }
    fmt::print(kScript, fmt::arg("commands", commands), fmt::arg("options", options));
}

}  // namespace

void add_completion(CLI::App& app, int& status) {
    CLI::App* const command = app.add_subcommand(
        "completion", "a script for the shell, which then completes commands and options");
    command->callback([&app, &status] {
        print_script(app);
        status = 0;
    });
}

}  // namespace curvecore::sysc
