// SPDX-License-Identifier: Apache-2.0
#include "sysc/panel/terminal_panel.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace curvecore::sysc {
namespace {

constexpr std::size_t kColumns = 80;  // of a terminal that does not say

}  // namespace

TerminalPanel::TerminalPanel(bool wanted) : on_(wanted && isatty(STDERR_FILENO) == 1) {}

TerminalPanel::~TerminalPanel() {
    clear();
    std::fflush(stderr);
}

std::size_t TerminalPanel::columns() const {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : kColumns;
}

void TerminalPanel::show(const std::vector<std::string>& lines) {
    if (!on_) return;
    clear();
    for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
    shown_ = lines.size();
    std::fflush(stderr);
}

/// Goes up to the first line and clears all below.
void TerminalPanel::clear() {
    if (shown_ > 0) fmt::print(stderr, "\r\033[{}A\033[J", shown_);
    shown_ = 0;
}

}  // namespace curvecore::sysc
