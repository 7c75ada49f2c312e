// SPDX-License-Identifier: Apache-2.0
// Guard against low queues: a queue that holds less of the plan than a stop takes. The core then
// stops time until more comes. Twin: rtl/queue/underrun_guard.sv.
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

    /// Notes that a word has entered its queue.
    void enters(Stream stream);
    /// Notes that a sample was made, at this rate of time (2^16 = 1).
    void made(std::int32_t rate);

    std::uint64_t times() const { return times_; }

  private:
    /// Ticks of reserve: the counts of the hardware are older.
    static constexpr std::int64_t kAge = 10;

    /// The words of segments or pieces, and the ticks of the plan that they cover, from the first.
    struct Cover {
        std::vector<std::uint64_t> words;
        std::vector<std::int64_t> ticks;
        std::uint64_t entered = 0;
        std::size_t whole = 0;  // number of segments or pieces

        void add(std::uint64_t more_words, std::int64_t more_ticks);
        bool complete() const { return whole == words.size(); }
        std::int64_t covered() const { return whole == 0 ? 0 : ticks[whole - 1]; }
    };

    std::array<Cover, 2> covers_;  // by Stream
    std::int64_t stop_ticks_;
    int rate_log2_;           // rates that sum to a tick
    std::int64_t rates_ = 0;  // sum of the rates
    bool low_ = false;
    std::uint64_t times_ = 0;
};

}  // namespace curvecore::sysc
