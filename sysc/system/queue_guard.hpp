// SPDX-License-Identifier: Apache-2.0
// When queues run low: less of the plan is in one of them than a stop takes. The core then stops
// time until there is more. Twin: rtl/queue/underrun_guard.sv.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sysc/board/board.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {

class QueueGuard {
  public:
    explicit QueueGuard(const Job& job);

    /// A word has entered its queue.
    void enters(Stream stream);
    /// A sample was made, at this rate of time (2^16 = 1).
    void made(std::int32_t rate);

    std::uint64_t times() const { return times_; }

  private:
    /// Ticks that are kept besides: the counts of the hardware are older.
    static constexpr std::int64_t kAge = 10;

    /// Segments or pieces: their words, and ticks of the plan that these cover, from the first.
    struct Cover {
        std::vector<std::uint64_t> words;
        std::vector<std::int64_t> ticks;
        std::uint64_t entered = 0;
        std::size_t whole = 0;  // segments or pieces

        void add(std::uint64_t more_words, std::int64_t more_ticks);
        bool complete() const { return whole == words.size(); }
        std::int64_t covered() const { return whole == 0 ? 0 : ticks[whole - 1]; }
    };

    std::array<Cover, 2> covers_;  // by Stream
    std::int64_t stop_ticks_;
    int rate_log2_;           // of rates that are a tick together
    std::int64_t rates_ = 0;  // their sum
    bool low_ = false;
    std::uint64_t times_ = 0;
};

}  // namespace curvecore::sysc
