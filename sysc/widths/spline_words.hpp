// SPDX-License-Identifier: Apache-2.0
// hls::SplineNetwork and hls::SplineKernel with widths at run time, their words' ranges noted at
// every step. A word that leaves its range is cut as a register cuts it (the kernel's native
// integers keep it): the propagated scheme does that on long chains.
#pragma once

#include "sysc/widths/segment_words.hpp"
#include "sysc/widths/value_ranges.hpp"

namespace curvecore::sysc {

/// One step's series, hls/spline_network.hpp.
class SplineSeriesWords {
  public:
    SplineSeriesWords(const CoreParameters& setting, ValueRanges& ranges);

    // Set before expand(): phi[0], Q[0], R[0], V[axis][0], W[axis][0], six_a[axis].
    RunWord six_a[3] = {};
    RunWord q[kMostOrders] = {};
    RunWord phi[kMostOrders] = {};
    RunWord Q[kMostOrders] = {};
    RunWord R[kMostOrders] = {};
    RunWord W[3][kMostOrders] = {};
    RunWord V[3][kMostOrders] = {};
    RunWord x[kMostOrders][3] = {};  // series mode; by order, for the sampler

    void derivatives_of_phi();
    void expand();
    int top() const { return top_; }

    static RunWord sum(const RunWord* series, int first, int last) {
        RunWord total = 0;
        for (int i = first; i <= last; ++i) total += series[i];
        return total;
    }

  private:
    RunWord over_order(RunWord d, int i, int drop) const;
    RunWord minus_three(RunWord s) const { return (s * -3 + 2) >> 2; }
    void phi_order(int i);
    void integrands(int i);

    const int order_;
    const int bits_;
    const bool anchor_;
    const bool series_;
    const int top_;
    ValueRanges& ranges_;
    const Rounding by_w1_;  // CoefBits-1
    const Rounding by_w2_;
    const Rounding by_w3_;
    RunWord dq_[kMostOrders] = {};
    RunWord dv_[3][kMostOrders] = {};
    RunWord dp_[kMostOrders] = {};
    RunWord dphi_[kMostOrders] = {};
};

class SplineWords {
  public:
    SplineWords(const CoreParameters& setting, int axes, ValueRanges& ranges);

    void load(const RunSegment& segment);
    void step();
    void sample(RunWord sigma, RunWord* out) const;

  private:
    void expand();
    void anchor();
    RunWord polished(RunWord phi, RunWord norm) const;
    void propagate();
    void place_origin();
    void sample_series(RunWord tau, RunWord* out) const;
    void sample_polynomial(RunWord tau, RunWord* out) const;

    const CoreParameters setting_;
    const int axes_;
    const int order_;
    const int bits_;
    ValueRanges& ranges_;
    const Rounding unit_;  // CoefBits-1
    const Rounding coef_;  // CoefBits-2
    SplineSeriesWords net_;
    int k_ = 0;
    int lambda_ = 0;
    FineShift step_to_fine_;
    FineShift curve_to_fine_;
    RunWord fine_v_ = 0;
    RunWord v_ = 0;
    RunWord a_[3] = {};
    RunWord three_a_[3] = {};
    RunWord b_[3] = {};
    RunWord advance_[kMostAxes] = {};  // c, and the auxiliary axes' rates
    RunWord step_a_[3] = {};           // a'
    RunWord step_b_[3] = {};           // B'
    RunWord start_[kMostAxes] = {};
    RunWord position_[kMostAxes] = {};
};

}  // namespace curvecore::sysc
