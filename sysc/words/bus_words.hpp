// SPDX-License-Identifier: Apache-2.0
// A plan as the words that the bus and the memory files carry, for any legal configuration.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hls/word_check.hpp"
#include "ref/plan/segment.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::sysc {

/// The segments of a program in words that join.
class JoinedSegments {
  public:
    explicit JoinedSegments(const RunTimeFormat& format) : format_(format) {}

    /// Returns the next segment's words, which start with the end words of the one before.
    /// @throws std::logic_error if the plan starts the segment elsewhere
    RunSegment next(const ref::Segment& segment);
    /// Returns the number of segments given.
    std::size_t count() const { return count_; }
    const RunTimeFormat& format() const { return format_; }

  private:
    void join(const ref::Segment& segment, RunSegment& words) const;

    RunTimeFormat format_;
    RunSegment last_;         // words of the segment before
    ref::Aux last_turned_{};  // turns that these words leave out
    std::size_t count_ = 0;
};

/// A program's segments as words (hls/words.hpp), one after the other.
class SegmentWriter {
  public:
    /// @param digest of the settings that the words are made for: sysc/job/made_for.hpp
    explicit SegmentWriter(const CoreParameters& parameters, std::uint16_t digest = 0)
        : segments_(RunTimeFormat(parameters, parameters.axes())), check_(digest) {}

    /// Returns the next segment's words.
    /// @throws std::logic_error as JoinedSegments
    std::vector<std::uint64_t> write(const ref::Segment& segment);
    /// Returns the number of segments written.
    std::size_t count() const { return segments_.count(); }

  private:
    JoinedSegments segments_;
    hls::WordCheck check_;
};

/// Changes of outputs as words.
class OutputWriter {
  public:
    OutputWriter(double sample_s, double unit_mm) : way_(sample_s / unit_mm) {}

    /// Appends the words of a change, which is not before the last one.
    void write(const ref::PlannedOutput& output, std::vector<std::uint64_t>& words);
    /// Appends changes of nothing, so that the last one is never far behind the path.
    void pass(std::uint64_t path, std::vector<std::uint64_t>& words);

  private:
    void write(ref::OutputKind kind, std::uint32_t value, std::uint32_t distance,
               std::vector<std::uint64_t>& words);
    std::uint32_t value_of(const ref::PlannedOutput& output) const;

    double way_;               // length units of a sample at 1 mm/s
    std::uint64_t place_ = 0;  // of the last one, length units
    std::uint32_t bits_ = 0;
    unsigned number_ = 0;
};

/// The pieces of a program's feed profile as words.
class ProfileWriter {
  public:
    explicit ProfileWriter(std::uint16_t digest = 0) : check_(digest) {}
    ProfileWriter(std::uint16_t digest, const OutputWriter& outputs)
        : check_(digest), outputs_(outputs) {}

    /// Returns the words of the next piece, number `index` of this part of its plan: those of
    /// changes of outputs up to its end, of the branch before it, if there is one, and five. Steps
    /// that are those of the branch before are left out.
    std::vector<std::uint64_t> write(const ref::Plan& plan, std::size_t index);
    /// Returns the words of changes of outputs that come before the next wait of this part, where
    /// the path is now; changes behind that wait follow.
    std::vector<std::uint64_t> wait(const ref::Plan& plan);
    std::size_t count() const { return count_; }

  private:
    void write_outputs(const ref::Plan& plan, std::vector<std::uint64_t>& words);

    hls::WordCheck check_;
    std::optional<OutputWriter> outputs_;
    std::size_t count_ = 0;
    std::vector<std::uint64_t> steps_;  // of the program's last branch
    std::uint64_t path_ = 0;            // before the next piece, quanta
    std::size_t output_ = 0;            // next one of the part
    int waits_ = 0;                     // that are passed
};

}  // namespace curvecore::sysc
