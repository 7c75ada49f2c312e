// SPDX-License-Identifier: Apache-2.0
// A plan as the words that the bus and the memory files carry, for any legal configuration.
#pragma once

#include <cstdint>
#include <vector>

#include "hls/word_check.hpp"
#include "ref/plan/segment.hpp"
#include "sysc/core/run_time_format.hpp"

namespace curvecore::sysc {

/// The segments of a program in words that join.
class JoinedSegments {
  public:
    explicit JoinedSegments(const RunTimeFormat& format) : format_(format) {}

    /// The next one's: it starts with the words that the one before ended with.
    /// @throws std::logic_error when the plan starts it elsewhere
    RunSegment next(const ref::Segment& segment);
    /// Of those that were given.
    std::size_t count() const { return count_; }
    const RunTimeFormat& format() const { return format_; }

  private:
    void join(const ref::Segment& segment, RunSegment& words) const;

    RunTimeFormat format_;
    RunSegment last_;         // words, the one before
    ref::Aux last_turned_{};  // and what they leave out
    std::size_t count_ = 0;
};

/// A program's segments as words (hls/words.hpp), one after the other.
class SegmentWriter {
  public:
    /// @param digest of what they are made for: sysc/job/made_for.hpp
    explicit SegmentWriter(const CoreParameters& parameters, std::uint16_t digest = 0)
        : segments_(RunTimeFormat(parameters, parameters.axes())), check_(digest) {}

    /// The next one's.
    /// @throws std::logic_error as JoinedSegments
    std::vector<std::uint64_t> write(const ref::Segment& segment);
    /// Of those that were written.
    std::size_t count() const { return segments_.count(); }

  private:
    JoinedSegments segments_;
    hls::WordCheck check_;
};

/// Its pieces.
class ProfileWriter {
  public:
    explicit ProfileWriter(std::uint16_t digest = 0) : check_(digest) {}

    /// The next one's, number `index` of this part of its plan: of the branch before it, if there
    /// is one, and five.
    std::vector<std::uint64_t> write(const ref::Plan& plan, std::size_t index);
    std::size_t count() const { return count_; }

  private:
    hls::WordCheck check_;
    std::size_t count_ = 0;
};

}  // namespace curvecore::sysc
