// SPDX-License-Identifier: Apache-2.0
// hls::SphericalKernel with widths at run time, its words' ranges noted at every step.
#pragma once

#include "sysc/widths/segment_words.hpp"
#include "sysc/widths/value_ranges.hpp"

namespace curvecore::sysc {

class ArcWords {
  public:
    ArcWords(const CoreParameters& setting, int axes, ValueRanges& ranges);

    void load(const RunSegment& segment);
    void step();
    /// Fine position at an offset of sigma quanta into the present step.
    void sample(RunWord sigma, RunWord* out) const;

  private:
    struct Series {
        RunWord y = 0;
        RunWord z = 0;
        RunWord y_coef[kMostOrders] = {};
        RunWord z_coef[kMostOrders] = {};
    };

    void expand(Series& series, Variable y, Variable z);
    void expand_axes();
    void sample_series(RunWord tau, RunWord* out) const;
    void sample_polynomial(RunWord tau, RunWord* out) const;
    /// Horner's scheme in steps of two orders, down to `last`.
    RunWord by_twos(const RunWord* series, int first, int last, RunWord q) const;

    const CoreParameters setting_;
    const int axes_;
    const int order_;
    ValueRanges& ranges_;
    const Rounding unit_;                 // CoefBits-1
    const Rounding coef_;                 // CoefBits-2
    RunWord tau_kept_[kMostOrders] = {};  // by order: the bits of tau that its stage has
    int k_ = 0;
    FineShift to_fine_;
    RunWord theta_ = 0;
    RunWord weight_[kMostOrders] = {};
    RunWord advance_[kMostAxes] = {};
    RunWord position_[kMostAxes] = {};
    Series xyz_[3];
    Series angle_;
    RunWord c_[kMostOrders][3] = {};  // by order: the axes' Horner chains run side by side
};

}  // namespace curvecore::sysc
