// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace curvecore::sysc {

ProgressBar::ProgressBar(std::uint64_t total, bool quiet)
    : total_(std::max<std::uint64_t>(total, 1)), on_(!quiet && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (!shown_) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}

void ProgressBar::update(std::uint64_t done) {
    if (!on_) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    const double part = static_cast<double>(done) / static_cast<double>(total_);
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    constexpr std::size_t kWidth = 40;
    const auto filled = static_cast<std::size_t>(part * kWidth);
    fmt::print(stderr, "\r\033[K[{}{}] {:3.0f} %  {:.2f} M samples/s  {:.0f} s left ",
               std::string(filled, '#'), std::string(kWidth - filled, '.'), part * 100,
               static_cast<double>(done) / seconds / 1e6, seconds / part - seconds);
    std::fflush(stderr);
    shown_ = true;
}

}  // namespace curvecore::sysc
