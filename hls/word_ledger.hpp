// SPDX-License-Identifier: Apache-2.0
// The ledger of words that have entered, of both streams, and the guard that stops time before they
// run out. Twins: rtl/queue/program_ledger.sv, piece_ledger.sv and underrun_guard.sv, which count a
// tick for each clock that their numbers are old; rtl/engine/programs/ledger.asm.
//
// Segments and pieces end a program at the same path and after the same ticks: else they are apart,
// and the words that follow are dropped. A stream whose program has ended waits for the other's.
#pragma once

#include <array>
#include <cstdint>

namespace curvecore {
namespace hls {

class WordLedger {
  public:
    /// Counts the length of a segment that comes in, of a piece.
    void length(std::uint64_t quanta) { path_ += static_cast<std::int64_t>(quanta); }
    void ds(std::uint64_t quanta) { path_ -= static_cast<std::int64_t>(quanta); }
    /// Counts a whole segment, a whole piece.
    void segment(std::uint32_t ticks, bool last) {
        ticks_ += ticks;
        segments_wait_ = last;
        compare();
    }
    void piece(std::int32_t ticks, bool final) {
        ticks_ -= ticks;
        queued_ticks_ += ticks;
        finals_ += final ? 1 : 0;
        pieces_wait_ = final;
        compare();
    }
    /// A piece begins.
    void take(std::int32_t ticks, bool final) {
        queued_ticks_ -= ticks;
        finals_ -= final ? 1 : 0;
    }

    /// The stream waits until the other's program has ended, too; for ever if they are apart.
    bool segments_wait() const { return segments_wait_; }
    bool pieces_wait() const { return pieces_wait_; }
    bool apart() const { return apart_; }

    /// Ticks that pieces cover, those not begun, and that segments do beyond the present piece.
    std::int64_t queued_ticks() const { return queued_ticks_; }
    std::int64_t queued_segment_ticks() const { return queued_ticks_ + ticks_; }
    /// Programs that have not begun and whose final piece is in; whose last segment is in.
    int whole_of_pieces() const { return apart_ ? 0 : finals_; }
    int whole_of_segments() const {
        return apart_ ? 0 : finals_ + (segments_wait_ ? 1 : 0) - (pieces_wait_ ? 1 : 0);
    }

  private:
    void compare() {
        if (!segments_wait_ || !pieces_wait_) return;
        apart_ = path_ != 0 || ticks_ != 0;
        segments_wait_ = pieces_wait_ = apart_;
    }

    std::int64_t path_ = 0;   // of the segments over the pieces
    std::int64_t ticks_ = 0;  // the same
    std::int64_t queued_ticks_ = 0;
    int finals_ = 0;
    bool segments_wait_ = false;
    bool pieces_wait_ = false;
    bool apart_ = false;
};

/// The piece under way, if one is: the rest of it in ticks with 16 fraction bits.
struct PresentPiece {
    bool active;
    bool final;
    std::int64_t rest;
};

/// Stops time when a stream no longer covers more ticks than a stop takes; it goes on when both
/// cover more than twice as many. A queue without room for another frame gets no more: more than a
/// stop is enough of it, and not more is a fault. A stream that has all words of a program covers
/// it, the program under way for a hold, and the next one for its start.
class UnderrunGuard {
  public:
    /// Looks at the streams, pieces and segments, before each tick.
    void tick(const WordLedger& ledger, const PresentPiece& present,
              const std::array<bool, 2>& full, std::int64_t stop_ticks) {
        const std::int64_t rest = present.active ? present.rest >> 16 : 0;
        const int final = present.active && present.final && !ledger.apart() ? 1 : 0;
        const std::int64_t covered[2] = {ledger.queued_ticks() + rest,
                                         ledger.queued_segment_ticks() + rest};
        const int whole[2] = {ledger.whole_of_pieces(), ledger.whole_of_segments()};
        may_begin_ = true;
        bool goes_on = true;
        bool runs_low = false;
        for (std::size_t n = 0; n < 2; ++n) {
            const bool low = covered[n] <= stop_ticks;
            const bool ample = covered[n] > 2 * stop_ticks || (full[n] && !low);
            const bool complete = whole[n] + final > 0;
            may_begin_ = may_begin_ && (whole[n] > 0 || ample);
            goes_on = goes_on && (complete || ample);
            runs_low = runs_low || (low && !complete);
            short_queue_ = short_queue_ || (low && !complete && full[n]);
        }
        if (!present.active || goes_on) {
            hold_ = false;
        } else if (runs_low) {
            hold_ = underrun_ = true;
        }
    }

    bool hold() const { return hold_; }
    bool may_begin() const { return may_begin_; }
    /// There was a hold; a full queue did not cover a stop.
    bool underrun() const { return underrun_; }
    bool short_queue() const { return short_queue_; }

  private:
    bool hold_ = false;
    bool may_begin_ = false;
    bool underrun_ = false;
    bool short_queue_ = false;
};

}  // namespace hls
}  // namespace curvecore
