// SPDX-License-Identifier: Apache-2.0
// hls::MotionKernel with widths at run time: lines, arcs and splines of a plan, followed along the
// path.
#pragma once

#include "sysc/widths/arc_words.hpp"
#include "sysc/widths/spline_words.hpp"

namespace curvecore::sysc {

class RunTimeKernel {
  public:
    RunTimeKernel(const CoreParameters& setting, int axes, ValueRanges& ranges)
        : axes_(axes), arc_(setting, axes, ranges), spline_(setting, axes, ranges) {}

    /// Moves ds quanta along the path and gives the fine position there. `next_segment()` gives the
    /// next segment's words; it is called only when the path has left the present one.
    template <class NextSegment>
    void sample(std::int64_t ds, NextSegment&& next_segment, RunWord* out) {
        sigma_ += ds;
        if (steps_ == 0) open(next_segment);
        while (sigma_ > step_length_ || (sigma_ == step_length_ && !last_step())) {
            sigma_ -= step_length_;
            if (last_step()) {
                open(next_segment);
            } else {
                rest_ -= step_length_;
                segment_.spline ? spline_.step() : arc_.step();
                measure();
            }
        }
        if (sigma_ == rest_) {
            for (int axis = 0; axis < axes_; ++axis) out[axis] = segment_.end[axis];
        } else {
            segment_.spline ? spline_.sample(sigma_, out) : arc_.sample(sigma_, out);
        }
    }

    /// Integration steps begun.
    std::uint64_t steps() const { return steps_; }

  private:
    bool last_step() const { return rest_ == step_length_; }

    /// The next segment with a length.
    template <class NextSegment>
    void open(NextSegment&& next_segment) {
        do {
            segment_ = next_segment();
        } while (segment_.length == 0);
        rest_ = segment_.length;
        segment_.spline ? spline_.load(segment_) : arc_.load(segment_);
        measure();
    }

    void measure() {
        const std::int64_t full = std::int64_t(1) << (segment_.step_exponent + hls::kPathFrac);
        step_length_ = std::min(rest_, full);
        ++steps_;
    }

    const int axes_;
    ArcWords arc_;
    SplineWords spline_;
    RunSegment segment_;
    std::uint64_t steps_ = 0;
    std::int64_t sigma_ = 0;
    std::int64_t rest_ = 0;
    std::int64_t step_length_ = 0;
};

}  // namespace curvecore::sysc
