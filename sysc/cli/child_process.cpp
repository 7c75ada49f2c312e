// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace curvecore::sysc {
namespace {

[[noreturn]] void become(const std::vector<std::string>& arguments, int output,
                         const char* errors) {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    const int input = open("/dev/null", O_RDONLY);
    const int file = open(errors, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
        dup2(file, STDERR_FILENO) >= 0) {
        execvp(argv[0], argv.data());
    }
    _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments,
                           const std::filesystem::path& errors) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
    process_ = fork();
    if (process_ == 0) become(arguments, ends[1], errors.c_str());
    close(ends[1]);
    output_ = fdopen(ends[0], "r");
    if (process_ < 0 || output_ == nullptr) {
        throw std::runtime_error("cannot start " + arguments.front());
    }
}

ChildProcess::~ChildProcess() {
    if (output_ != nullptr) std::fclose(output_);
    if (process_ < 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
}

std::optional<std::string> ChildProcess::line() {
    char* text = nullptr;
    std::size_t room = 0;
    const ssize_t count = getline(&text, &room, output_);
    std::optional<std::string> line;
    if (count > 0 && text[count - 1] == '\n') line.emplace(text, count - 1);
    std::free(text);
    return line;
}

std::string ChildProcess::end() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    if (WIFEXITED(status)) return fmt::format("exit status {}", WEXITSTATUS(status));
    return fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
}

}  // namespace curvecore::sysc
