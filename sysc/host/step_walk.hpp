// SPDX-License-Identifier: Apache-2.0
// The integration steps that a path goes through, as the cores count them
// (hls/interpolator_kernel.hpp).
#pragma once

#include <algorithm>

#include "ref/curve/segment.hpp"

namespace curvecore::sysc {

class StepWalk {
  public:
    explicit StepWalk(const ref::Plan& plan) : plan_(plan) { open(0); }

    /// Goes to `s`, quanta. `enter(segment, fresh)` for every step that begins on the way; fresh:
    /// the first of its segment.
    template <class Enter>
    void to(std::uint64_t s, Enter&& enter) {
        while (s > step_end_ || (s == step_end_ && step_end_ != end_)) {
            const bool fresh = step_end_ == end_;
            if (fresh && !open(index_ + 1)) return;
            if (!fresh) next_step();
            enter(plan_.segments[index_], fresh);
        }
    }

  private:
    /// The next segment that has a length.
    bool open(std::size_t index) {
        while (index < plan_.segments.size() && plan_.segments[index].length == 0) ++index;
        if (index == plan_.segments.size()) return false;
        index_ = index;
        step_end_ = plan_.segments[index].s_start;
        end_ = step_end_ + plan_.segments[index].length;
        next_step();
        return true;
    }

    void next_step() {
        const int exponent = plan_.segments[index_].step_exponent + 16;
        step_end_ = std::min(end_, step_end_ + (std::uint64_t{1} << exponent));
    }

    const ref::Plan& plan_;
    std::size_t index_ = 0;
    std::uint64_t step_end_ = 0;  // program-wide
    std::uint64_t end_ = 0;       // of the segment
};

}  // namespace curvecore::sysc
