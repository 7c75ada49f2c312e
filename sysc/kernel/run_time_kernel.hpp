// SPDX-License-Identifier: Apache-2.0
// The kernel of any core, whose widths and curves are known at run time only.
#pragma once

#include <memory>

#include "sysc/kernel/table_kernel.hpp"

namespace curvecore::sysc {

/// Arcs, splines and, of a core that has one, its table; its auxiliary axes go as a line's.
class RunTimeCurves {
  public:
    explicit RunTimeCurves(const RunTimeFormat& format)
        : own_(format),
          table_(format.kTable ? std::make_unique<TableKernel>(*format.kTable, format) : nullptr),
          auxiliary_(format.kAxes > 3) {}

    RunTimeCurves(const RunTimeCurves& other)
        : own_(other.own_),
          table_(other.table_ ? std::make_unique<TableKernel>(*other.table_) : nullptr),
          auxiliary_(other.auxiliary_),
          of_table_(other.of_table_) {}
    RunTimeCurves(RunTimeCurves&&) = default;
    RunTimeCurves& operator=(RunTimeCurves&&) = default;
    ~RunTimeCurves() = default;

    void load(const RunSegment& words) {
        of_table_ = table_ && words.kind == hls::SegmentKind::kTable;
        if (!of_table_) return own_.load(words);
        table_->load(words);
        if (auxiliary_) own_.load(line(words));
    }
    void step() {
        if (of_table_) table_->step();
        if (!of_table_ || auxiliary_) own_.step();
    }
    void sample(std::int64_t sigma, std::int64_t* out) {
        if (!of_table_ || auxiliary_) own_.sample(sigma, out);
        if (of_table_) table_->sample(sigma, out);
    }

  private:
    /// Returns a segment in which X Y Z stand, and the other axes go as in this one.
    static RunSegment line(RunSegment words) {
        words.kind = hls::SegmentKind::kArc;
        words.theta = 0;
        words.lambda = 0;
        for (int axis = 0; axis < 3; ++axis) {
            words.tangent[axis] = words.normal[axis] = words.advance[axis] = 0;
        }
        return words;
    }

    hls::CurveKernel<RunTimeFormat> own_;
    std::unique_ptr<TableKernel> table_;
    bool auxiliary_;
    bool of_table_ = false;
};

using RunTimeKernel = hls::InterpolatorKernel<RunTimeFormat, RunTimeCurves>;

}  // namespace curvecore::sysc
