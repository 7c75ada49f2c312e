// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/terminal/nearest.hpp"

namespace curvecore::sysc {
namespace {

constexpr const char* kHelpAll = "--help-all";

/// Examples of each command, as a user would type them.
const std::map<std::string, std::vector<const char*>> kExamples{
    {"run",
     {"part.ngc -o out", "part.ngc --build serial --device ecp5-25 -o small",
      "part.ngc --on systemc --trace -o system"}},
    {"plan",
     {"part.ngc -o plan", "part.ngc --machine mill.ini -o mill",
      "points.csv --fit c2 --feed 2m/min -o curve"}},
    {"words",
     {"part.ngc -o words", "part.ngc --build serial --device ecp5-25 -o serial",
      "part.ngc --holds bounds -o memory"}},
    {"vectors",
     {"part.ngc -o vectors", "part.ngc --set Order=4 --set CoefBits=24 --unit 10nm -o small",
      "part.ngc --build engine --holds bounds -o engine"}},
    {"cam",
     {"radii.csv --kappa 0.5 -o cam", "radii.csv --scallop 5um --cutter 10mm -o fine",
      "radii.csv --kappa 0.5 --against measured.csv -o checked"}},
    {"join",
     {"first.ngc second.ngc -o join", "first.ngc second.ngc --least jerk --points 5 -o smooth",
      "--load join/join.json -o again"}},
    {"compare",
     {"part.ngc -o widths", "part.ngc --build serial --device gw2a-18 -o serial",
      "--curves all --set CoefBits=24:36:4 --set Order=4,6 -o curves"}},
    {"choose",
     {"--error 1um --radius 300mm --feed 10m/min --device up5k",
      "--error 10nm --length 50mm --feed 6m/min --device ecp5-25 -o answer",
      "--error 1um --radius 300mm --feed 10m/min --board tang_nano_20k"}},
    {"stream",
     {"part.ngc --to udp:192.168.1.50", "part.ngc --to serial:/dev/ttyUSB0@1000000 -o drawn",
      "part.ngc --to udp:127.0.0.1 --override 50"}},
    {"home",
     {"--machine mill.ini --to udp:192.168.1.50",
      "--machine mill.ini --to serial:/dev/ttyUSB0@1000000 --axes z",
      "--machine mill.ini --to udp:127.0.0.1 -q"}},
    {"board", {"--fast", "--listen 127.0.0.1:27181 -o board", "--home x=-9000..-300,z=400..9000"}},
    {"completion", {">~/.curvecore.bash; . ~/.curvecore.bash"}},
    {"explore",
     {"part.ngc -o queues", "part.ngc --host 1ms,5ms --word 2us,500us -o uart",
      "part.ngc --segment-queue 512,1024 --profile-queue 256,512 -o short"}},
    {"curve",
     {"check ref/curves/clothoid.net",
      "run wave.net --x '20*t' --y '8*sin(w*t)' --let w=2 --t 0,3 --set Order=4 --unit 100nm -o "
      "wave",
      "run clothoid --row T=1,0,0 --row N=0,1,0 --row kappa=0,0,0 --row sigma=0.0025 --length 40mm "
      "--feed 3m/min -o out"}},
};

std::string examples_of(const std::string& command) {
    std::string text = "Examples:\n";
    for (const char* example : kExamples.at(command)) {
        text += fmt::format("  curvecore {} {}\n", command, example);
    }
    return text;
}

bool is(const std::string& argument, const char* name) {
    return CLI::detail::to_lower(argument) == name;
}

bool has(const std::vector<std::string>& arguments, const char* name) {
    return std::any_of(arguments.begin(), arguments.end(),
                       [name](const std::string& argument) { return is(argument, name); });
}

bool is_help(const std::string& argument) {
    return is(argument, "-h") || is(argument, "--help") || is(argument, kHelpAll);
}

/// Names of options as the user types them, "--output"; also those of a hidden group.
std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

bool known(const std::vector<std::string>& names, const std::string& word) {
    return std::any_of(names.begin(), names.end(), [&word](const std::string& name) {
        return is(word, CLI::detail::to_lower(name).c_str());
    });
}

/// Adds examples below each help; rare options are hidden unless one of the arguments is
/// --help-all.
void finish_help(CLI::App& app, const std::vector<std::string>& arguments) {
    const bool all = has(arguments, kHelpAll);
    for (CLI::App* command : app.get_subcommands({})) {
        bool hidden = false;
        for (CLI::Option* option : command->get_options()) {
            if (all || option->get_group() != group::kRare) continue;
            option->group("");
            hidden = true;
        }
        command->footer(
            fmt::format("{}{}{}", examples_of(command->get_name()),
                        command->get_footer().empty() ? "" : "\n" + command->get_footer(),
                        hidden ? "\n--help-all has more options." : ""));
    }
    app.footer("curvecore COMMAND --help says more, with examples.");
}

/// Rewrites `help run` as `run --help`.
std::vector<std::string> asked_help(std::vector<std::string> arguments) {
    if (arguments.empty()) return {"--help"};
    if (!is(arguments.front(), "help")) return arguments;
    std::rotate(arguments.begin(), arguments.begin() + 1, arguments.end());
    arguments.back() = "--help";
    return arguments;
}

/// Refuses a first word that is no command, and an option that the command does not have.
/// @throws UsageError with the nearest name
void check_names(const CLI::App& app, const std::vector<std::string>& arguments) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    const std::string& first = arguments.front();
    const CLI::App* command = &app;
    if (first[0] != '-') {
        if (!known(names, first)) {
            throw UsageError(fmt::format("there is no command '{}'; {}", first,
                                         nearest_text(first, names, names_text(names))));
        }
        command = app.get_subcommand(CLI::detail::to_lower(first));
    }
    const std::vector<std::string> options = option_names(*command);
    for (const std::string& argument : arguments) {
        const std::string word = argument.substr(0, argument.find('='));
        if (word == "--") return;
        if (word.rfind("--", 0) != 0 || known(options, word)) continue;
        throw UsageError(fmt::format(
            "{} has no option '{}'; {}", command->get_name(), word,
            nearest_text(word, options, command->get_name() + " --help-all lists them")));
    }
}

}  // namespace

void begin_group(CLI::App& command, const char* group) { command.option_defaults()->group(group); }

void begin_help(CLI::App& app) {
    app.set_help_flag("-h,--help,--help-all", "this text; --help-all: with every option");
    app.ignore_case();
    app.option_defaults()->ignore_case();
}

void parse(CLI::App& app, std::vector<std::string> arguments) {
    arguments = asked_help(std::move(arguments));
    finish_help(app, arguments);
    check_names(app, arguments);
    const auto help = std::find_if(arguments.begin() + 1, arguments.end(), is_help);
    if (help != arguments.end()) arguments = {arguments.front(), *help};
    std::reverse(arguments.begin(), arguments.end());
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::Success& asked) {
        app.exit(asked);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
}

}  // namespace curvecore::sysc
