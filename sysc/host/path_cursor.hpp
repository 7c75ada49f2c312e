// SPDX-License-Identifier: Apache-2.0
// Where on the plan a path length lies.
#pragma once

#include <cmath>

#include "ref/curve/segment.hpp"

namespace curvecore::sysc {

/// A segment is left when the path goes beyond its length, as the cores do.
class PathCursor {
  public:
    explicit PathCursor(const ref::Plan& plan) : plan_(plan) { skip(); }

    void advance(std::uint64_t ds) {
        s_ += ds;
        skip();
    }

    std::uint64_t s() const { return s_; }  // quanta, program-wide
    std::size_t index() const { return index_; }
    const ref::Segment& segment() const { return plan_.segments[index_]; }
    bool at_end() const { return s_ == end(index_); }
    /// Path length within the segment, length units.
    double local() const { return std::ldexp(static_cast<double>(s_ - segment().s_start), -16); }

  private:
    std::uint64_t end(std::size_t index) const {
        return plan_.segments[index].s_start + plan_.segments[index].length;
    }
    void skip() {
        while (index_ + 1 < plan_.segments.size() &&
               (s_ > end(index_) || plan_.segments[index_].length == 0)) {
            ++index_;
        }
    }

    const ref::Plan& plan_;
    std::uint64_t s_ = 0;
    std::size_t index_ = 0;
};

}  // namespace curvecore::sysc
