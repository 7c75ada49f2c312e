// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/spline_words.hpp"

namespace curvecore::sysc {

SplineSeriesWords::SplineSeriesWords(const CoreParameters& setting, ValueRanges& ranges)
    : order_(setting.order),
      bits_(setting.coef_bits),
      anchor_(setting.anchor != 0),
      series_(!setting.polynomial()),
      top_(anchor_ ? order_ - 1 : order_),
      ranges_(ranges),
      by_w1_(bits_ - 1),
      by_w2_(bits_ - 2),
      by_w3_(bits_ - 3) {}

void SplineSeriesWords::derivatives_of_phi() {
    const RunWord s = ranges_.keep(Variable::kS, 0, by_w1_.product(phi[0], phi[0]));
    Q[0] = -by_w1_.product(s, phi[0]);
    R[0] = minus_three(s);
}

RunWord SplineSeriesWords::over_order(RunWord d, int i, int drop) const {
    if (i == 1) return Rounding(drop)(d);
    return Rounding(bits_ - 1 + drop).product(d, reciprocal(i, bits_ - 1));
}

void SplineSeriesWords::expand() {
    phi[0] = ranges_.keep(Variable::kPhi, 0, phi[0]);
    Q[0] = ranges_.keep(Variable::kBigQ, 0, Q[0]);
    R[0] = ranges_.keep(Variable::kR, 0, R[0]);
    for (int axis = 0; axis < 3; ++axis) {
        V[axis][0] = ranges_.keep(Variable::kV, 0, V[axis][0]);
        W[axis][0] = ranges_.keep(Variable::kW, 0, W[axis][0]);
    }
    for (int i = 1; i <= order_; ++i) {
        dq_[i] = phi[i - 1];
        q[i] = ranges_.keep(Variable::kQ, i, over_order(dq_[i], i, 0));
        for (int axis = 0; axis < 3 && series_; ++axis) {
            x[i][axis] =
                ranges_.keep(Variable::kX, i, over_order(by_w1_(convolved(V[axis], dq_, i)), i, 0));
        }
        if (i <= top_) phi_order(i);
        if (i < top_ || !anchor_) integrands(i);
    }
}

void SplineSeriesWords::phi_order(int i) {
    dp_[i] = 0;
    for (int axis = 0; axis < 3; ++axis) {
        dv_[axis][i] = ranges_.keep(Variable::kDV, i, by_w2_(convolved(W[axis], dq_, i)));
        dp_[i] += ranges_.keep(Variable::kDP, i, by_w1_(convolved(V[axis], dv_[axis], i)));
        V[axis][i] = ranges_.keep(Variable::kV, i, over_order(dv_[axis][i], i, 2));
    }
    dp_[i] = ranges_.keep(Variable::kDP, i, dp_[i]);
    dphi_[i] = ranges_.keep(Variable::kDphi, i, by_w3_(convolved(Q, dp_, i)));
    phi[i] = ranges_.keep(Variable::kPhi, i, over_order(dphi_[i], i, 2));
}

void SplineSeriesWords::integrands(int i) {
    for (int axis = 0; axis < 3; ++axis) {
        W[axis][i] = ranges_.keep(Variable::kW, i, by_w2_.product(six_a[axis], q[i]));
    }
    Q[i] = ranges_.keep(Variable::kBigQ, i, over_order(by_w1_(convolved(R, dphi_, i)), i, 0));
    RunProduct s = 0;
    for (int j = 0; j <= i; ++j) s += RunProduct(phi[j]) * phi[i - j];
    R[i] = ranges_.keep(Variable::kR, i, minus_three(ranges_.keep(Variable::kS, i, by_w1_(s))));
}

}  // namespace curvecore::sysc
