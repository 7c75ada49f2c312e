// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/program_run.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace curvecore::tb {
namespace fs = std::filesystem;
namespace {

fs::path make_folder() {
    std::string name = (fs::temp_directory_path() / "curvecore-cli.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    return name;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Waits until the process has used as much processor time, so that its progress does not depend on
/// the machine's load.
void wait_for_work(pid_t child, int ms) {
    clockid_t clock{};
    if (clock_getcpuclockid(child, &clock) != 0) return;
    timespec worked{};
    siginfo_t ended{};
    while (clock_gettime(clock, &worked) == 0 &&
           worked.tv_sec * 1000 + worked.tv_nsec / 1000000 < ms) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
        if (ended.si_pid == child) return;
    }
}

/// Returns whether no file of this process was like it but for digits, signs and exponents.
bool is_new(const fs::path& file) {
    static std::set<std::string> seen;
    static const std::regex digits("-?[0-9]+(e[-+][0-9]+)?");
    const std::string text = std::regex_replace(text_of(file), digits, "");
    return seen.insert(file.filename().string() + text).second;
}

/// Those in the folder that `-o` names that have a schema must fit it; others read them.
void check_formats(const fs::path& here, const std::vector<std::string>& arguments) {
    const auto option = std::find(arguments.begin(), arguments.end(), "-o");
    if (arguments.end() - option < 2) return;
    std::string files;
    for (const std::string name :
         {"report", "core", "words", "join", "segments", "explore", "compare", "choose"}) {
        const fs::path file = here / *(option + 1) / (name + ".json");
        if (fs::exists(file) && is_new(file)) files += " '" + file.string() + "'";
    }
    if (files.empty()) return;
    FILE* const checker = popen((CHECK_JSON + files + " 2>&1").c_str(), "r");
    std::string said;
    for (int c = fgetc(checker); c != EOF; c = fgetc(checker)) said += static_cast<char>(c);
    EXPECT_EQ(pclose(checker), 0) << said;
}

}  // namespace

std::string name_of(const std::vector<std::string>& arguments) {
    std::string name;
    for (const std::string& argument : arguments) {
        name += '_' + argument.substr(argument.find_first_not_of('-'));
    }
    std::replace(name.begin(), name.end(), '=', '_');
    return name.empty() ? "default" : name.substr(1);
}

ProgramRun::ProgramRun(std::string program)
    : program_(std::move(program)), folder_(make_folder()), streams_(make_folder()) {}

ProgramRun::~ProgramRun() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    fs::remove_all(streams_, ignored);
}

void ProgramRun::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string ProgramRun::read(const std::string& name) const { return text_of(folder_ / name); }

std::vector<std::string> ProgramRun::files() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

ProgramResult ProgramRun::run(const std::vector<std::string>& arguments, int interrupt_ms) const {
    const std::string out = streams_ / "out";
    const std::string err = streams_ / "err";
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> argv{const_cast<char*>("curvecore")};
        for (const std::string& argument : arguments) {
            argv.push_back(const_cast<char*>(argument.c_str()));
        }
        argv.push_back(nullptr);
        const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (chdir(folder_.c_str()) != 0 || dup2(out_file, STDOUT_FILENO) < 0 ||
            dup2(err_file, STDERR_FILENO) < 0) {
            _exit(127);
        }
        execv(program_.c_str(), argv.data());
        _exit(127);
    }
    if (interrupt_ms > 0) {
        wait_for_work(child, interrupt_ms);
        kill(child, SIGINT);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    check_formats(folder_, arguments);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err),
            usage.ru_maxrss};
}

}  // namespace curvecore::tb
