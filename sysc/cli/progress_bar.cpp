// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace curvecore::sysc {

ProgressBar::ProgressBar(std::uint64_t total, bool quiet, Counts counts)
    : total_(std::max<std::uint64_t>(total, 1)),
      counts_(counts),
      on_(!quiet && isatty(STDERR_FILENO) == 1) {}

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
    fmt::print(stderr, "\r\033[K[{}{}] {:3.0f} %  ", std::string(filled, '#'),
               std::string(kWidth - filled, '.'), part * 100);
    if (counts_ == Counts::kSamples) {
        fmt::print(stderr, "{:.2f} M samples/s  ", static_cast<double>(done) / seconds / 1e6);
    }
    fmt::print(stderr, "{:.0f} s left ", seconds / part - seconds);
    std::fflush(stderr);
    shown_ = true;
}

}  // namespace curvecore::sysc
