// SPDX-License-Identifier: Apache-2.0
// The kernel as a board: the words of hls/ in any legal configuration, without a clock.
#pragma once

#include <deque>

#include "hls/path_kernel.hpp"
#include "hls/stop_schedule.hpp"
#include "hls/time_scaler.hpp"
#include "ref/format/queues.hpp"
#include "sysc/board/board.hpp"
#include "sysc/core/core_parameters.hpp"
#include "sysc/kernel/run_time_kernel.hpp"

namespace curvecore::sysc {

/// Depths of both queues in words of 48 bits.
struct QueueDepths {
    int segments = ref::kBoardSegmentWords;
    int profile = ref::kBoardProfileWords;
};

class KernelBoard : public Board {
  public:
    KernelBoard(const CoreParameters& core, const BoardSettings& settings,
                const QueueDepths& depths = {});

    std::size_t write(Stream stream, const std::uint64_t* words, std::size_t count) override;
    bool full(Stream stream) const override;
    void request(std::uint64_t samples) override { requested_ += samples; }
    /// Draws one sample if its words are there.
    void work(std::vector<Sample>& samples) override;
    BoardStatus status() const override;

  private:
    struct Queue {
        std::size_t depth;
        std::deque<std::uint64_t> words;
        bool full() const { return words.size() == depth; }
        std::uint64_t pop() {
            const std::uint64_t word = words.front();
            words.pop_front();
            return word;
        }
    };

    Queue& queue(Stream stream) { return stream == Stream::kSegments ? segments_ : profile_; }
    /// Takes the next request's path increment. Returns false if there is no request, or its tick
    /// has no words yet.
    bool move();
    /// Returns true if the next piece is queued; stop branches before it are moved to stops_.
    bool piece_queued();
    bool next_piece(hls::ProfileWords& words);
    /// Takes segments off the queue until they cover the increment. Returns false if there are too
    /// few.
    bool cover();
    void draw(Sample& sample);

    const CoreParameters core_;
    const std::int32_t target_;  // rate of time, 2^16 = 1
    const std::size_t segment_words_;
    Queue segments_;
    Queue profile_;
    hls::TimeScaler scaler_;
    hls::StopSchedule stops_;
    hls::PathKernel path_;
    hls::SampleShare share_;
    const RunTimeFormat format_;
    RunTimeKernel kernel_;
    std::uint64_t requested_ = 0;
    bool moving_ = false;  // ds_ is the increment of a request that waits for segments
    bool final_ = false;   // the last piece is under way
    std::int32_t rate_ = 0;
    std::int64_t ds_ = 0;
    std::deque<RunSegment> ahead_;  // segments taken off the queue, not reached yet
    std::uint64_t covered_ = 0;     // path length of all segments taken off the queue, quanta
    std::uint64_t walked_ = 0;
    std::uint64_t empty_segments_ = 0;
};

}  // namespace curvecore::sysc
