// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/config_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/nearest.hpp"

namespace curvecore::sysc {
namespace {

constexpr const char* kOption = "--config";
constexpr const char* kNone = "none";

/// Name of the option in an argument: "--unit" of "--unit=1um", "-o" of "-oout".
std::string option_in(const std::string& argument) {
    if (argument.size() > 2 && argument[0] == '-' && argument[1] != '-') {
        return argument.substr(0, 2);
    }
    return argument.substr(0, argument.find('='));
}

/// The last --config of the line; empty: none.
std::string named_file(const std::vector<std::string>& arguments) {
    std::string file;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (CLI::detail::to_lower(option_in(arguments[i])) != kOption) continue;
        const std::size_t equals = arguments[i].find('=');
        if (equals != std::string::npos) {
            file = arguments[i].substr(equals + 1);
        } else if (i + 1 < arguments.size()) {
            file = arguments[i + 1];
        }
    }
    return file;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

CLI::App* command_named(CLI::App& app, const std::string& name) {
    const std::vector<std::string> names = command_names(app);
    const bool there = std::find(names.begin(), names.end(), name) != names.end();
    return there ? app.get_subcommand(name) : nullptr;
}

/// Names of the options of some commands that a file may give: those with a long name.
std::vector<std::string> option_names(const std::vector<CLI::App*>& commands) {
    std::set<std::string> names;
    for (const CLI::App* command : commands) {
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames()) names.insert(name);
        }
    }
    names.erase("help");
    names.erase("help-all");
    names.erase("config");
    names.erase("json");  // of a command alone: scripts ask for it
    return {names.begin(), names.end()};
}

/// Options in an argument: of "-qo" and "-qoout" two.
std::vector<std::string> options_in(const CLI::App& command, const std::string& argument) {
    if (argument.size() < 2 || argument[0] != '-') return {};
    if (argument[1] == '-') return {option_in(argument)};
    std::vector<std::string> options;
    for (std::size_t n = 1; n < argument.size(); ++n) {
        options.push_back(std::string("-") + argument[n]);
        const CLI::Option* const option = command.get_option_no_throw(options.back());
        if (option == nullptr || option->get_items_expected_max() != 0) break;
    }
    return options;
}

bool is_on_line(const CLI::App& command, const CLI::Option& option,
                const std::vector<std::string>& arguments) {
    return std::any_of(arguments.begin(), arguments.end(), [&](const std::string& argument) {
        const std::vector<std::string> there = options_in(command, argument);
        return std::any_of(there.begin(), there.end(),
                           [&](const std::string& name) { return option.check_name(name); });
    });
}

bool asks_for_help(const std::vector<std::string>& arguments) {
    return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
        return argument == "-h" || argument == "--help" || argument == "--help-all";
    });
}

}  // namespace

void add_config(CLI::App& app) {
    for (CLI::App* command : app.get_subcommands({})) {
        if (option_names({command}).empty()) continue;
        begin_group(*command, group::kRare);
        command
            ->add_option_function<std::string>(
                kOption, [](const std::string&) {},
                fmt::format(
                    "defaults of options, a line each, as unit = \"1um\"; below [{}] of this "
                    "command alone; {} in the working folder when left out; {}: no file",
                    command->get_name(), kConfigFile, kNone))
            ->type_name("FILE.toml");
    }
}

ConfigFile::ConfigFile(CLI::App& app, std::vector<std::string> arguments)
    : arguments_(std::move(arguments)) {
    if (arguments_.empty()) return;
    const std::string command = CLI::detail::to_lower(arguments_.front());
    CLI::App* const asked = command_named(app, command);
    if (asked == nullptr || option_names({asked}).empty() || asks_for_help(arguments_)) return;
    file_ = named_file(arguments_);
    if (file_ == kNone) return;
    named_ = !file_.empty();
    std::error_code unknown;
    if (!named_) {
        if (!std::filesystem::exists(kConfigFile, unknown)) return;
        file_ = kConfigFile;
    }
    take(app, ref::read_text_file(file_));
    std::vector<std::string> defaults;
    for (auto one = given_.begin(); one != given_.end();) {
        const bool on_line = is_on_line(*asked, *asked->get_option(one->first), arguments_);
        if (!on_line) {
            defaults.insert(defaults.end(), one->second.arguments.begin(),
                            one->second.arguments.end());
        }
        one = on_line || one->second.arguments.empty() ? given_.erase(one) : std::next(one);
    }
    arguments_.insert(arguments_.begin() + 1, defaults.begin(), defaults.end());
}

void ConfigFile::take(CLI::App& app, const std::string& text) {
    static const std::regex blank(R"(\s*(#.*)?)");
    static const std::regex head(R"(\s*\[\s*([\w-]+)\s*\]\s*(#.*)?)");
    std::istringstream lines(text);
    std::string line;
    std::string section;
    std::smatch found;
    std::set<std::pair<std::string, std::string>> seen;
    while (std::getline(lines, line)) {
        ++line_;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (std::regex_match(line, blank)) continue;
        if (std::regex_match(line, found, head)) {
            section = found[1];
            if (command_named(app, section) != nullptr) continue;
            refuse(fmt::format(
                "there is no command '{}'; {}", section,
                nearest_text(section, command_names(app), names_text(command_names(app)))));
        }
        const bool whole =
            std::count(line.begin(), line.end(), '[') == std::count(line.begin(), line.end(), ']');
        std::istringstream one(line);
        const std::vector<CLI::ConfigItem> items = whole && line.find('=') != std::string::npos
                                                       ? CLI::ConfigTOML().from_config(one)
                                                       : std::vector<CLI::ConfigItem>();
        if (items.size() != 1) refuse("expected name = value, or [command], in one line");
        static const std::regex hidden(R"re([^"#]*"[^"]*#.*)re");
        const std::vector<std::string>& values = items.front().inputs;
        const bool open = std::count(line.begin(), line.end(), '"') % 2 != 0;
        if (open || std::regex_match(line, hidden) ||
            std::find(values.begin(), values.end(), "") != values.end()) {
            refuse("expected a value, or \"a value\" without # in it");
        }
        if (!seen.emplace(section, items.front().fullname()).second) {
            refuse(fmt::format("'{}' is there twice", items.front().fullname()));
        }
        take_item(app, section, items.front());
    }
}

void ConfigFile::take_item(CLI::App& app, const std::string& section, const CLI::ConfigItem& item) {
    const std::string name = item.fullname();
    const std::vector<CLI::App*> of = section.empty()
                                          ? app.get_subcommands({})
                                          : std::vector<CLI::App*>{app.get_subcommand(section)};
    const std::vector<std::string> names = option_names(of);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const std::string who = section.empty() ? "no command" : section;
        refuse(fmt::format("{} has {}option '{}'; {}", who, section.empty() ? "an " : "no ", name,
                           nearest_text(name, names,
                                        fmt::format("curvecore {} --help-all lists them",
                                                    section.empty() ? "COMMAND" : section))));
    }
    const std::string command = CLI::detail::to_lower(arguments_.front());
    if (!section.empty() && section != command) return;
    const CLI::Option* const option = app.get_subcommand(command)->get_option_no_throw("--" + name);
    if (option == nullptr) return;  // of other commands
    // A section stands behind what is for all commands, and replaces it.
    given_["--" + name] = {line_, arguments_of(*option, name, item.inputs)};
}

std::vector<std::string> ConfigFile::arguments_of(const CLI::Option& option,
                                                  const std::string& name,
                                                  const std::vector<std::string>& values) const {
    if (option.get_items_expected_max() == 0) {
        if (values == std::vector<std::string>{"true"}) return {"--" + name};
        if (values == std::vector<std::string>{"false"}) return {};
        refuse(fmt::format("{} is a switch: true or false", name));
    }
    if (option.get_items_expected_max() == 1) {
        return {fmt::format("--{}={}", name, fmt::join(values, ","))};
    }
    std::vector<std::string> arguments;
    arguments.reserve(values.size());
    for (const std::string& value : values)
        arguments.push_back(fmt::format("--{}={}", name, value));
    return arguments;
}

void ConfigFile::report() const {
    static const std::set<std::string> kSilent{"-q", "--quiet", "-h", "--help", "--help-all"};
    const auto is_silent = [](const std::string& argument) { return kSilent.count(argument) > 0; };
    if (named_ || given_.empty() || std::any_of(arguments_.begin(), arguments_.end(), is_silent)) {
        return;
    }
    std::string names;
    for (const auto& [name, given] : given_) names += " " + name;
    fmt::print(stderr, "curvecore: of {}:{}\n", file_, names);
}

void ConfigFile::place(const UsageError& error) const {
    const std::string text = error.what();
    std::size_t first = std::string::npos;
    int line = 0;
    for (const auto& [name, given] : given_) {
        const std::size_t at = text.find(name);
        if (at >= first) continue;
        const char behind = text.c_str()[at + name.size()];
        if (std::isalnum(static_cast<unsigned char>(behind)) != 0 || behind == '-') continue;
        first = at;
        line = given.line;
    }
    if (line > 0) throw ref::InputError(file_, line, text);
}

void ConfigFile::refuse(const std::string& reason) const {
    throw ref::InputError(file_, line_, reason);
}

}  // namespace curvecore::sysc
