// SPDX-License-Identifier: Apache-2.0
// Guard against low queues: a queue that holds less of the plan than a stop takes. The core then
// stops time until more comes. Twin: rtl/queue/underrun_guard.sv.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "sysc/board/board.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {

class QueueGuard {
  public:
    /// Creates a guard of a job, which must outlive it.
    explicit QueueGuard(const Job& job);

    /// Notes that a word has entered its queue.
    void enters(Stream stream);
    /// Notes that a sample was made, at this rate of time (2^16 = 1).
    void made(std::int32_t rate);

    std::uint64_t times() const { return times_; }

  private:
    /// Ticks of reserve: the counts of the hardware are older.
    static constexpr std::int64_t kAge = 10;

    /// The segments or pieces that have entered whole.
    struct Cover {
        std::size_t count = 0;      // of the plan
        std::size_t whole = 0;      // entered whole
        std::int64_t ticks = 0;     // ticks of the plan that these cover
        std::uint64_t entered = 0;  // words
        std::uint64_t next = 0;     // number of words with which one more is whole

        bool complete() const { return whole == count; }
    };

    /// The words and ticks of a segment or a piece.
    std::pair<std::uint64_t, std::int64_t> item(Stream stream, std::size_t index) const;

    const Job& job_;
    std::array<Cover, 2> covers_;  // by Stream
    std::int64_t stop_ticks_;
    int rate_log2_;           // rates that sum to a tick
    std::int64_t rates_ = 0;  // sum of the rates
    bool low_ = false;
    std::uint64_t times_ = 0;
};

}  // namespace curvecore::sysc
