// SPDX-License-Identifier: Apache-2.0
// A progress bar for long work: on a terminal only, on stderr, removed when done.
#pragma once

#include <chrono>
#include <cstdint>

namespace curvecore::sysc {

class ProgressBar {
  public:
    /// Kinds of things that are counted; the bar shows the rate of samples.
    enum class Counts { kSamples, kParts };

    ProgressBar(std::uint64_t total, bool quiet, Counts counts = Counts::kSamples);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void update(std::uint64_t done);

  private:
    using Clock = std::chrono::steady_clock;

    std::uint64_t total_;
    Counts counts_;
    bool on_;
    bool shown_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_ + std::chrono::milliseconds(300);
};

}  // namespace curvecore::sysc
