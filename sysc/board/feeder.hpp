// SPDX-License-Identifier: Apache-2.0
// The host of a board: keeps its queues filled with a plan's words and requests the samples.
#pragma once

#include "sysc/board/board.hpp"
#include "sysc/job/job.hpp"
#include "sysc/words/bus_words.hpp"

namespace curvecore::sysc {

/// Settings of a board that draws a job's plan, of which the first part is available.
BoardSettings board_settings(const Job& job);

class Feeder {
  public:
    Feeder(const Job& job, std::uint64_t samples, Board& board);

    /// Writes the words that fit, requests the samples that they cover and lets the board work.
    /// Appends the samples that came.
    /// @throws BoardError when the board no longer returns samples
    void turn(std::vector<Sample>& samples);

    bool done() const { return received_ == samples_; }

  private:
    static constexpr std::uint64_t kPatience = 50'000'000;  // turns without a sample
    /// The same of a core, which is late by 2^17 clocks at most.
    static constexpr std::uint64_t kPatienceOfACore = 2'000'000;
    /// Bound on ticks that are requested but not yet counted by the board, with a margin.
    static constexpr std::int64_t kOnTheWay = 64;

    /// The words of one segment or piece, and how many of them are sent.
    class Outbox {
      public:
        explicit Outbox(Stream stream) : stream_(stream) {}
        void load(std::vector<std::uint64_t> words, std::uint32_t ticks);
        /// Sends the words that the board takes. Returns true if all are sent. `last`: none
        /// follows.
        bool send(Board& board, bool last);
        std::int64_t ticks() const { return ticks_; }
        bool complete() const { return complete_; }

      private:
        Stream stream_;
        std::vector<std::uint64_t> words_;
        std::size_t sent_ = 0;
        std::uint32_t loaded_ticks_ = 0;
        std::int64_t ticks_ = 0;  // ticks of all that is sent
        bool complete_ = false;
    };

    void write_segments();
    void write_profile();
    /// Returns the number of samples that the words on the board cover, from the first: those that
    /// came, and one for each remaining share of a tick. An override below 1 leaves more than one
    /// sample a share.
    std::uint64_t covered() const;
    std::uint64_t covered(const Outbox& outbox, Stream stream) const;

    const Job& job_;
    Board& board_;
    const std::uint64_t samples_;
    Outbox segments_{Stream::kSegments};
    Outbox profile_{Stream::kProfile};
    SegmentWriter segment_words_;
    std::size_t next_piece_ = 0;
    std::uint64_t requested_ = 0;
    std::uint64_t received_ = 0;
    std::uint64_t walked_ = 0;  // plan time that these took: 2^-16 of a sample at rate 1
    std::uint64_t waited_ = 0;
};

}  // namespace curvecore::sysc
