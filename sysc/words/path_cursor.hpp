// SPDX-License-Identifier: Apache-2.0
// A cursor at a path length on a plan.
#pragma once

#include <cmath>

#include "ref/plan/segment.hpp"
#include "sysc/words/list_view.hpp"

namespace curvecore::sysc {

/// Leaves a segment when the path goes beyond its length, as the cores do.
class PathCursor {
  public:
    /// Creates a cursor on a plan of any kind, which must outlive it.
    template <class Plan>
    explicit PathCursor(const Plan& plan) : segments_(plan.segments) {
        skip();
    }

    void advance(std::uint64_t ds) {
        s_ += ds;
        skip();
    }

    std::uint64_t s() const { return s_; }  // quanta, program-wide
    std::size_t index() const { return index_; }
    const ref::Segment& segment() const { return segments_[index_]; }
    bool at_end() const { return s_ == end(index_); }
    /// Returns the path length within the segment, length units.
    double local() const { return std::ldexp(static_cast<double>(s_ - segment().s_start), -16); }

  private:
    std::uint64_t end(std::size_t index) const {
        return segments_[index].s_start + segments_[index].length;
    }
    void skip() {
        while (index_ + 1 < segments_.size() &&
               (s_ > end(index_) || segments_[index_].length == 0)) {
            ++index_;
        }
    }

    ListView<ref::Segment> segments_;
    std::uint64_t s_ = 0;
    std::size_t index_ = 0;
};

}  // namespace curvecore::sysc
