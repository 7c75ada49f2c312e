// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/console.hpp"

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kStep = 10;  // percent a key

}  // namespace

/// Terminal settings under which keys come one by one, without echo.
struct Console::Terminal {
    Terminal() {
        tcgetattr(STDIN_FILENO, &before);
        termios keys = before;
        keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        keys.c_cc[VMIN] = 0;
        keys.c_cc[VTIME] = 0;
        tcsetattr(STDIN_FILENO, TCSANOW, &keys);
    }
    ~Terminal() { tcsetattr(STDIN_FILENO, TCSANOW, &before); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    termios before{};
};

Console::Console(const std::string& control_file, int override_percent)
    : percent_(override_percent) {
    if (isatty(STDIN_FILENO) != 0) terminal_ = std::make_unique<Terminal>();
    if (control_file.empty()) return;
    file_.open(control_file);
    if (!file_) throw UsageError(fmt::format("--control {}: cannot be read", control_file));
}

Console::~Console() = default;

std::optional<Wish> Console::next() {
    if (terminal_) {
        if (std::optional<Wish> wish = key()) return wish;
    }
    return file_.is_open() ? line() : std::nullopt;
}

std::optional<Wish> Console::key() {
    using Kind = Wish::Kind;
    for (char c = 0; read(STDIN_FILENO, &c, 1) == 1;) {
        if (c == 'h') return Wish{Kind::kHold};
        if (c == 'r') return Wish{Kind::kResume};
        if (c == 's') return Wish{Kind::kStop};
        if (c == 'e') return Wish{Kind::kEstop};
        if (c == '+' || c == '-') {
            percent_ = std::clamp(percent_ + (c == '+' ? kStep : -kStep), kStep, 100);
            return Wish{Kind::kOverride, percent_};
        }
    }
    return std::nullopt;
}

/// Returns the next line; a line counts once its end is written.
std::optional<Wish> Console::line() {
    using Kind = Wish::Kind;
    file_.clear();
    for (char c = 0; file_.get(c);) {
        if (c != '\n') {
            line_ += c;
            continue;
        }
        std::istringstream words(line_);
        std::string word;
        std::string more;
        words >> word;
        int percent = 0;
        const bool rate = word == "override" && words >> percent && percent >= 1 && percent <= 100;
        const bool whole = !(words >> more);
        const std::string said = std::exchange(line_, "");
        if (rate && whole) return Wish{Kind::kOverride, percent_ = percent};
        if (word == "hold" && whole) return Wish{Kind::kHold};
        if (word == "resume" && whole) return Wish{Kind::kResume};
        if (word == "stop" && whole) return Wish{Kind::kStop};
        if (word == "estop" && whole) return Wish{Kind::kEstop};
        fmt::print(stderr,
                   "'{}' is none of: hold, resume, override 1..100, stop, estop; it is left out\n",
                   said);
    }
    return std::nullopt;
}

}  // namespace curvecore::sysc
