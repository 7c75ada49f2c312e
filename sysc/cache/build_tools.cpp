// SPDX-License-Identifier: Apache-2.0
#include "sysc/cache/build_tools.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;

bool in_path(const std::string& tool) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((fs::path(folder) / tool).c_str(), X_OK) == 0) return true;
    }
    return false;
}

std::string output_of(const std::string& command) {
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot start a shell");
    std::string text;
    std::array<char, 4096> part{};
    std::size_t count = 0;
    while ((count = fread(part.data(), 1, part.size(), pipe)) > 0) text.append(part.data(), count);
    pclose(pipe);
    return text;
}

void check_build_tools() {
    for (const char* tool : {"verilator", "make", CURVECORE_CXX}) {
        const std::string name = fs::path(tool).filename();
        if (fs::path(tool).is_absolute() ? access(tool, X_OK) == 0 : in_path(tool)) continue;
        throw UsageError(
            fmt::format("this core is not built in, and {} is missing to make it: install "
                        "verilator, make and {}, or run with --on kernel",
                        name, fs::path(CURVECORE_CXX).filename().string()));
    }
    const std::string version = output_of("verilator --version");
    if (version.find(CURVECORE_VERILATOR_VERSION) == std::string::npos) {
        throw UsageError(fmt::format(
            "this core is not built in, and cannot be made: the program needs Verilator {}, here "
            "is {}",
            CURVECORE_VERILATOR_VERSION, version.substr(0, version.find('\n'))));
    }
}

int run_tool(const std::vector<std::string>& arguments, const fs::path& log,
             const fs::path& folder) {
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> argv;
        argv.reserve(arguments.size() + 1);
        for (const std::string& argument : arguments) {
            argv.push_back(const_cast<char*>(argument.c_str()));
        }
        argv.push_back(nullptr);
        const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        if (chdir(folder.c_str()) != 0) _exit(127);
        if (file < 0 || dup2(file, STDOUT_FILENO) < 0 || dup2(file, STDERR_FILENO) < 0) _exit(127);
        execvp(argv[0], argv.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string reason_in(const fs::path& log) {
    std::ifstream lines(log);
    std::string last;
    for (std::string line; std::getline(lines, line); last = line) {
        if (line.find("rror") != std::string::npos) return line;
    }
    return last;
}

}  // namespace curvecore::sysc
