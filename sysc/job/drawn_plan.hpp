// SPDX-License-Identifier: Apache-2.0
// A whole plan as it is drawn, part by part onto the disk: what is read of it again passes through
// little memory.
#pragma once

#include <array>

#include "ref/format/path_words.hpp"
#include "ref/plan/segment.hpp"
#include "sysc/words/bus_words.hpp"
#include "sysc/words/file_list.hpp"

namespace curvecore::sysc {

class DrawnPlan : public ref::PlanFrame {
  public:
    /// Of so many samples the plan takes some megabytes, however short its segments are.
    static constexpr std::uint64_t kSamplesHeld = 100'000;

    FileList<ref::Move> moves;  // of the path that is drawn, all of them before they are planned
    FileList<ref::Segment> segments;
    FileList<ref::ProfilePiece> pieces;

    double duration_s = 0;
    std::size_t slowed_moves = 0;  // by what the queues cover
    int slowed_line = 0;           // of the first
    ref::CoreSlowed core_slowed;
    std::size_t branches = 0;
    std::uint64_t longest_stop = 0;  // ticks from a hold at the rate 1 to rest, with branches
    std::size_t stops = 0;           // that the profile plans

    /// Its words, all of them, are made for this.
    void made_for(std::uint16_t digest) { writer_ = ProfileWriter(digest); }
    /// The next part, whose moves there are.
    void append(const ref::Plan& part);

    /// Of the whole path, quanta.
    std::uint64_t path_length() const { return segments.back().s_start + segments.back().length; }
    /// Of both streams, in all, for a core with so many auxiliary axes.
    std::size_t words(int core_axes) const;
    /// Words of a piece, and how many; those of a stop branch come first.
    std::pair<const std::uint64_t*, std::size_t> words_of(std::size_t piece) const;
    /// Of the segments of a kind.
    std::size_t count(ref::Segment::Kind kind) const { return kinds_[index(kind)].count; }
    double bound(ref::Segment::Kind kind) const { return kinds_[index(kind)].bound; }

    /// Memory that the lists hold goes; what is read comes back.
    void let_go() const;
    /// visit(segment, index) for all of them, in little memory.
    template <class Visit>
    void each_segment(Visit visit) const {
        constexpr std::size_t kHeld = 8192;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            if (i % kHeld == 0) let_go();
            visit(segments[i], i);
        }
        let_go();
    }

  private:
    struct OfKind {
        std::size_t count = 0;
        double bound = 0;  // worst derived one of the error before rounding, units
    };

    static std::size_t index(ref::Segment::Kind kind) { return static_cast<std::size_t>(kind); }
    void append(const ref::Segment& segment);

    ProfileWriter writer_;
    FileList<std::uint64_t> profile_words_;  // of all pieces
    FileList<std::size_t> first_word_;       // of each
    std::array<OfKind, 2> kinds_;            // by Segment::Kind
    std::uint64_t wait_ = ref::kStopLead;    // ticks from the last branch on
    bool stop_behind_ = false;               // the last segment that has a length ends at rest
};

/// Whether the path is at rest where a segment ends: words round, a stop ends a little above zero.
inline bool ends_at_rest(const ref::Segment& segment) { return segment.feed_end < 1e-6; }

}  // namespace curvecore::sysc
