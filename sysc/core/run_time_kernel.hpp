// SPDX-License-Identifier: Apache-2.0
// The kernel of any core, whose widths and curves are known at run time only.
#pragma once

#include <memory>

#include "sysc/core/table_kernel.hpp"

namespace curvecore::sysc {

/// Arcs, splines and, of a core that has one, its table.
class RunTimeCurves {
  public:
    explicit RunTimeCurves(const RunTimeFormat& format)
        : own_(format),
          table_(format.kTable ? std::make_unique<TableKernel>(*format.kTable, format) : nullptr) {}

    RunTimeCurves(const RunTimeCurves& other)
        : own_(other.own_),
          table_(other.table_ ? std::make_unique<TableKernel>(*other.table_) : nullptr),
          of_table_(other.of_table_) {}
    RunTimeCurves(RunTimeCurves&&) = default;
    RunTimeCurves& operator=(RunTimeCurves&&) = default;
    ~RunTimeCurves() = default;

    void load(const RunSegment& words) {
        of_table_ = table_ && words.kind == hls::SegmentKind::kTable;
        of_table_ ? table_->load(words) : own_.load(words);
    }
    void step() { of_table_ ? table_->step() : own_.step(); }
    void sample(std::int64_t sigma, std::int64_t* out) {
        of_table_ ? table_->sample(sigma, out) : own_.sample(sigma, out);
    }

  private:
    hls::CurveKernel<RunTimeFormat> own_;
    std::unique_ptr<TableKernel> table_;
    bool of_table_ = false;
};

using RunTimeKernel = hls::InterpolatorKernel<RunTimeFormat, RunTimeCurves>;

}  // namespace curvecore::sysc
