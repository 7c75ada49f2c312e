// SPDX-License-Identifier: Apache-2.0
// Fates of the words of two streams: hls/word_entry.hpp and hls/word_ledger.hpp, with queues of so
// many words behind them. A fault of words cuts both streams.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "hls/word_entry.hpp"
#include "hls/word_ledger.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::tb {

/// A stream: its place in pairs.
enum Stream : std::size_t { kSegments = 0, kPieces = 1 };

class WordRule {
  public:
    using Frame = std::vector<std::uint64_t>;
    enum class Fate { kStays, kDropped, kPassed };

    /// Creates the rule for queues of so many words; `at_once`: words that wait are judged, too.
    WordRule(const sysc::CoreParameters& core, const std::array<int, 2>& queues,
             std::uint16_t digest, bool at_once = false)
        : queues_(queues),
          frames_of_{{core.segment_words(), ref::kProfileBusWords}},
          at_once_(at_once),
          segment_entry_(sysc::RunTimeFormat(core, core.axes()), core.splines != 0, digest,
                         core.table != nullptr),
          piece_entry_(digest) {}

    /// Offers a stream's next word. It stays while there is no room, or, as a frame's first, while
    /// its program waits.
    Fate offer(Stream stream, std::uint64_t word) {
        if (fault_ != 0) return Fate::kDropped;
        const bool waits = this->waits(stream, word) || held(stream) == queues_[stream];
        if (waits && !(at_once_ && judged(stream, word))) return Fate::kStays;
        const hls::Entry entry =
            stream == kSegments ? segment_entry_.take(word) : piece_entry_.take(word);
        if (entry == hls::Entry::kBadWord) fault_ = stream == kSegments ? 1 : 4;
        if (entry == hls::Entry::kBadOrder) fault_ = stream == kSegments ? 2 : 8;
        if (fault_ != 0) return Fate::kDropped;
        pass(stream, word);
        if (entry == hls::Entry::kCompleted) complete(stream);
        return Fate::kPassed;
    }

    /// Bits 0 to 4 of rtl/motion_interpolator.sv.
    int fault() const { return fault_; }
    /// Words in a queue, and its whole frames.
    int held(Stream stream) const { return held_[stream]; }
    int frames(Stream stream) const { return static_cast<int>(frames_[stream].size()); }
    /// Takes a whole frame out of a queue.
    Frame take(Stream stream) {
        Frame frame = frames_[stream].front();
        frames_[stream].pop_front();
        held_[stream] -= static_cast<int>(frame.size());
        return frame;
    }
    static hls::ProfileWords piece_of(const Frame& frame) {
        auto word = frame.end() - hls::kProfileBusWords;
        return hls::unpack_piece([&] { return *word++; });
    }

    hls::WordLedger& ledger() { return ledger_; }
    const hls::WordLedger& ledger() const { return ledger_; }
    /// Queues without room for another frame: of pieces, of segments.
    std::array<bool, 2> full() const { return {full(kPieces), full(kSegments)}; }

  private:
    static hls::Tag tag_of(std::uint64_t word) {
        return static_cast<hls::Tag>(get(hls::kTagField, word));
    }
    bool waits(Stream stream, std::uint64_t word) const {
        const hls::Tag tag = tag_of(word);
        return stream == kSegments
                   ? ledger_.segments_wait() && tag == hls::Tag::kLength
                   : ledger_.pieces_wait() && (tag == hls::Tag::kPiece || tag == hls::Tag::kStop);
    }
    /// Returns whether the word will cut its stream.
    bool judged(Stream stream, std::uint64_t word) const {
        auto segment_entry = segment_entry_;
        auto piece_entry = piece_entry_;
        stream == kSegments ? segment_entry.take(word) : piece_entry.take(word);
        return stream == kSegments ? segment_entry.cut() : piece_entry.cut();
    }
    bool full(Stream stream) const { return held(stream) > queues_[stream] - frames_of_[stream]; }

    void pass(Stream stream, std::uint64_t word) {
        ++held_[stream];
        frame_[stream].push_back(word);
        if (tag_of(word) == hls::Tag::kLength) ledger_.length(get(hls::kLengthField, word));
        if (tag_of(word) == hls::Tag::kDs) ledger_.ds(get(hls::kLengthField, word));
    }

    void complete(Stream stream) {
        Frame& frame = frame_[stream];
        if (stream == kSegments) {
            std::uint32_t ticks = 0;
            int bits = 0;
            for (const std::size_t place : {9U, 10U, 14U, 15U}) {  // Y and Z: tangent, normal
                const auto byte =
                    static_cast<std::uint32_t>(get(hls::kTicksByteField, frame[place]));
                ticks |= byte << bits;
                bits += hls::kTicksByteField.bits;
            }
            ledger_.segment(ticks, get(hls::kLastField, frame[1]) != 0);
        } else {
            const hls::ProfileWords piece = piece_of(frame);
            ledger_.piece(piece.ticks, piece.final);
        }
        if (ledger_.apart()) fault_ = 16;
        frames_[stream].push_back(frame);
        frame.clear();
    }

    std::array<int, 2> queues_;
    std::array<int, 2> frames_of_;  // words of a frame, without a branch
    bool at_once_;
    hls::SegmentEntry<sysc::RunTimeFormat> segment_entry_;
    hls::PieceEntry piece_entry_;
    hls::WordLedger ledger_;
    int fault_ = 0;
    std::array<std::deque<Frame>, 2> frames_;  // whole ones in the queues
    std::array<Frame, 2> frame_;               // under way
    std::array<int, 2> held_{};
};

}  // namespace curvecore::tb
