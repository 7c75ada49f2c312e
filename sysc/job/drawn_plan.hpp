// SPDX-License-Identifier: Apache-2.0
// A whole plan as it is drawn, written part by part to the disk; reading it needs little memory.
#pragma once

#include "ref/format/path_words.hpp"
#include "ref/plan/segment.hpp"
#include "sysc/words/bus_words.hpp"
#include "sysc/words/file_list.hpp"

namespace curvecore::sysc {

class DrawnPlan : public ref::PlanFrame {
  public:
    FileList<ref::Move> moves;  // moves of the drawn path, complete before they are planned
    FileList<ref::Segment> segments;
    FileList<ref::ProfilePiece> pieces;
    FileList<ref::PlannedOutput> outputs;

    double duration_s = 0;
    std::size_t slowed_moves = 0;  // moves slowed to the time that the queues cover
    int slowed_line = 0;           // line of the first of them
    ref::CoreSlowed core_slowed;
    std::size_t branches = 0;
    std::uint64_t longest_stop = 0;  // ticks from a hold at the rate 1 to rest, with branches
    std::size_t stops = 0;           // stops in the profile

    /// Sets the writer of its profile's words.
    void made_for(const ProfileWriter& writer) { writer_ = writer; }
    /// Appends the next part, whose moves are complete.
    void append(const ref::Plan& part);

    /// Length of the whole path, quanta.
    std::uint64_t path_length() const { return segments.back().s_start + segments.back().length; }
    /// Number of words of both streams, for a core whose segments have so many each.
    std::size_t words(int segment_words) const;
    /// Returns the words of a piece and their number; those of a stop branch come first.
    std::pair<const std::uint64_t*, std::size_t> words_of(std::size_t piece) const;
    /// Number of segments of a kind.
    std::size_t count(ref::CurveKind kind) const { return kinds_[kind].count; }
    double bound(ref::CurveKind kind) const { return kinds_[kind].bound; }

  private:
    struct OfKind {
        std::size_t count = 0;
        double bound = 0;  // worst derived bound of the error before rounding, units
    };

    void append(const ref::Segment& segment);

    ProfileWriter writer_;
    FileList<std::uint64_t> profile_words_;  // words of all pieces
    FileList<std::size_t> first_word_;       // first word of each piece
    ref::ByKind<OfKind> kinds_;
    std::uint64_t wait_ = ref::kStopLead;  // ticks since the last branch
    bool stop_behind_ = false;             // the last segment that has a length ends at rest
};

/// Returns true if the path is at rest where a segment ends: a stop's word is rounded, so it ends
/// slightly above zero.
inline bool ends_at_rest(const ref::Segment& segment) { return segment.feed_end < 1e-6; }

}  // namespace curvecore::sysc
