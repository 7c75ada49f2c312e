// SPDX-License-Identifier: Apache-2.0
#include "sysc/panel/console.hpp"

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "sysc/cli/usage_error.hpp"
#include "sysc/job/options.hpp"

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

Console::Console(const std::string& control_file) {
    if (isatty(STDIN_FILENO) != 0) terminal_ = std::make_unique<Terminal>();
    if (control_file.empty()) return;
    file_.open(control_file);
    if (!file_) throw UsageError(fmt::format("--control {}: cannot be read", control_file));
}

Console::~Console() = default;

void Console::add_to(WishQueue& wishes, int override_percent) {
    if (terminal_) keys(wishes, override_percent);
    if (file_.is_open()) lines(wishes);
}

void Console::keys(WishQueue& wishes, int percent) {
    using Kind = Wish::Kind;
    for (char c = 0; read(STDIN_FILENO, &c, 1) == 1;) {
        if (c == 'h') wishes.push({Kind::kHold});
        if (c == 'r') wishes.push({Kind::kResume});
        if (c == 's') wishes.push({Kind::kStop});
        if (c == 'e') wishes.push({Kind::kEstop});
        if (c == '+' || c == '-') {
            percent = std::clamp(percent + (c == '+' ? kStep : -kStep), kStep, kMostOverride);
            wishes.push({Kind::kOverride, percent});
        }
    }
}

/// Adds wishes of whole lines: one counts once its end is written.
void Console::lines(WishQueue& wishes) {
    file_.clear();
    for (char c = 0; file_.get(c);) {
        if (c != '\n') {
            line_ += c;
            continue;
        }
        const std::string said = std::exchange(line_, "");
        if (const std::optional<Wish> wish = wish_of(said)) {
            wishes.push(*wish);
            continue;
        }
        fmt::print(stderr,
                   "'{}' is none of: hold, resume, override 1..200, stop, estop; it is left out\n",
                   said);
    }
}

}  // namespace curvecore::sysc
