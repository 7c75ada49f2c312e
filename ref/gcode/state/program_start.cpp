// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/state/program_start.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "ref/gcode/blocks/program_parameters.hpp"
#include "ref/machine/ini_file.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::ref {
namespace {

namespace fs = std::filesystem;

/// Reads lines of the form "5161 0.5".
std::map<int, double> read_parameters(const std::string& file) {
    std::map<int, double> parameters;
    std::ifstream text = open_text_file(file);
    TextLines lines(text);
    while (const std::optional<std::string_view> line = lines.next()) {
        std::istringstream words{std::string(*line)};
        int number = 0;
        double value = 0;
        if ((words >> std::ws).eof()) continue;
        if (!(words >> number >> value) || !ProgramParameters::exists(number)) {
            Place{file, lines.number()}.refuse("a parameter is its number and its value");
        }
        parameters[number] = value;
    }
    return parameters;
}

/// Returns a file that the .ini names, if it exists.
std::optional<std::string> file_of(const IniFile& ini, const char* section, const char* name) {
    const std::optional<IniEntry> entry = ini.find(section, name);
    if (!entry) return std::nullopt;
    const fs::path file = fs::path(ini.file()).parent_path() / entry->value;
    std::error_code error;
    return fs::is_regular_file(file, error) ? std::optional(file.string()) : std::nullopt;
}

/// Adds the folders between colons, which begin at the .ini's own; ~ is the user's.
void add_folders(const IniFile& ini, const char* section, const char* name, ProgramStart& start) {
    const std::optional<IniEntry> entry = ini.find(section, name);
    if (!entry) return;
    std::istringstream names(entry->value);
    for (std::string folder; std::getline(names, folder, ':');) {
        const char* const home = std::getenv("HOME");
        if (home != nullptr && folder.rfind('~', 0) == 0) folder.replace(0, 1, home);
        if (!folder.empty()) start.folders.push_back(fs::path(ini.file()).parent_path() / folder);
    }
}

void set_startup(const IniFile& ini, ProgramStart& start) {
    const std::optional<IniEntry> code = ini.find("RS274NGC", "RS274NGC_STARTUP_CODE");
    if (!code) return;
    start.startup = code->value;
    start.ini = ini.file();
    start.startup_line = code->line;
}

}  // namespace

ProgramStart read_program_start(const std::string& ini, const std::string& tools) {
    ProgramStart start;
    std::optional<std::string> table;
    if (!tools.empty()) table = tools;
    if (!ini.empty()) {
        const IniFile machine(read_text_file(ini), ini);
        start.unit = mm_per_unit(machine);
        if (!table) table = file_of(machine, "EMCIO", "TOOL_TABLE");
        if (const auto file = file_of(machine, "RS274NGC", "PARAMETER_FILE")) {
            start.parameters = read_parameters(*file);
        }
        add_folders(machine, "DISPLAY", "PROGRAM_PREFIX", start);
        add_folders(machine, "RS274NGC", "SUBROUTINE_PATH", start);
        set_startup(machine, start);
        start.ini_numbers = machine.numbers();
    }
    if (table) start.tools = ToolTable(*table, start.unit);
    return start;
}

}  // namespace curvecore::ref
