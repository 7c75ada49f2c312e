// SPDX-License-Identifier: Apache-2.0
// A walk through the integration steps of a path, as the cores count them
// (hls/interpolator_kernel.hpp).
#pragma once

#include <algorithm>

#include "ref/plan/segment.hpp"
#include "sysc/words/list_view.hpp"

namespace curvecore::sysc {

class StepWalk {
  public:
    /// Creates a walk on a plan of any kind, which must outlive it.
    template <class Plan>
    explicit StepWalk(const Plan& plan) : segments_(plan.segments) {
        open(0);
    }

    /// Advances to `s`, quanta. Calls `enter(segment, fresh)` for every step that begins on the
    /// way; fresh: the first of its segment.
    template <class Enter>
    void to(std::uint64_t s, Enter&& enter) {
        while (s > step_end_ || (s == step_end_ && step_end_ != end_)) {
            const bool fresh = step_end_ == end_;
            if (fresh && !open(index_ + 1)) return;
            if (!fresh) next_step();
            enter(segments_[index_], fresh);
        }
    }

  private:
    /// Opens the next segment that has a length. Returns false if there is none.
    bool open(std::size_t index) {
        while (index < segments_.size() && segments_[index].length == 0) ++index;
        if (index == segments_.size()) return false;
        index_ = index;
        step_end_ = segments_[index].s_start;
        end_ = step_end_ + segments_[index].length;
        next_step();
        return true;
    }

    void next_step() {
        const int exponent = segments_[index_].step_exponent + 16;
        step_end_ = std::min(end_, step_end_ + (std::uint64_t{1} << exponent));
    }

    ListView<ref::Segment> segments_;
    std::size_t index_ = 0;
    std::uint64_t step_end_ = 0;  // end of the step, program-wide path
    std::uint64_t end_ = 0;       // end of the segment, program-wide path
};

}  // namespace curvecore::sysc
