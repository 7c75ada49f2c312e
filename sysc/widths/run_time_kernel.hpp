// SPDX-License-Identifier: Apache-2.0
// hls::MotionKernel with widths at run time: lines, arcs and splines of a plan, followed along the
// path.
#pragma once

#include "tb/compare/arc_words.hpp"
#include "tb/compare/spline_words.hpp"

namespace curvecore::tb {

class RunTimeKernel {
  public:
    /// The segments must outlive the kernel.
    RunTimeKernel(const Setting& setting, const std::vector<RunSegment>& segments, int axes,
                  ValueRanges& ranges)
        : segments_(segments),
          axes_(axes),
          arc_(setting, axes, ranges),
          spline_(setting, axes, ranges) {}

    /// Moves ds quanta along the path, not beyond its end, and gives the fine position there.
    void sample(std::int64_t ds, RunWord* out) {
        sigma_ += ds;
        if (next_ == 0) open();
        while (sigma_ > step_length_ || (sigma_ == step_length_ && !last_step())) {
            sigma_ -= step_length_;
            if (last_step()) {
                open();
            } else {
                rest_ -= step_length_;
                spline_now_ ? spline_.step() : arc_.step();
                measure();
            }
        }
        if (sigma_ == rest_) {
            for (int axis = 0; axis < axes_; ++axis) out[axis] = segments_[next_ - 1].end[axis];
        } else {
            spline_now_ ? spline_.sample(sigma_, out) : arc_.sample(sigma_, out);
        }
    }

    /// Index of the segment of the last sample.
    std::size_t segment() const { return next_ - 1; }
    /// Integration steps begun.
    std::uint64_t steps() const { return steps_; }

  private:
    bool last_step() const { return rest_ == step_length_; }

    void open() {
        while (segments_.at(next_).length == 0) ++next_;
        const RunSegment& segment = segments_[next_++];
        rest_ = segment.length;
        spline_now_ = segment.spline;
        spline_now_ ? spline_.load(segment) : arc_.load(segment);
        measure();
    }

    void measure() {
        const std::int64_t full = std::int64_t(1)
                                  << (segments_[next_ - 1].step_exponent + hls::kPathFrac);
        step_length_ = std::min(rest_, full);
        ++steps_;
    }

    const std::vector<RunSegment>& segments_;
    const int axes_;
    ArcWords arc_;
    SplineWords spline_;
    bool spline_now_ = false;
    std::size_t next_ = 0;
    std::uint64_t steps_ = 0;
    std::int64_t sigma_ = 0;
    std::int64_t rest_ = 0;
    std::int64_t step_length_ = 0;
};

}  // namespace curvecore::tb
