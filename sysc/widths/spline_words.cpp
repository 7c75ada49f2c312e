// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/spline_words.hpp"

namespace curvecore::sysc {

SplineWords::SplineWords(const CoreParameters& setting, int axes, ValueRanges& ranges)
    : setting_(setting),
      axes_(axes),
      order_(setting.order),
      bits_(setting.coef_bits),
      ranges_(ranges),
      unit_(bits_ - 1),
      coef_(bits_ - 2),
      net_(setting, ranges) {}

void SplineWords::load(const RunSegment& segment) {
    k_ = segment.step_exponent;
    lambda_ = segment.lambda;
    step_to_fine_ = FineShift(setting_, k_);
    curve_to_fine_ = FineShift(setting_, lambda_);
    v_ = 0;
    fine_v_ = 0;
    net_.phi[0] = segment.theta;
    for (int axis = 0; axis < axes_; ++axis) {
        start_[axis] = segment.start[axis];
        position_[axis] = segment.start[axis];
        advance_[axis] = segment.advance[axis];
    }
    const int twice = 2 * (lambda_ - k_);
    for (int axis = 0; axis < 3; ++axis) {
        a_[axis] = segment.tangent[axis];
        b_[axis] = segment.normal[axis];
        three_a_[axis] = 3 * a_[axis];
        step_a_[axis] = ranges_.keep(Variable::kStepA, 0, scaled_down(a_[axis], 1, twice));
        net_.six_a[axis] = ranges_.keep(Variable::kSixA, 0, scaled_down(three_a_[axis], 4, twice));
    }
    anchor();
    expand();
}

void SplineWords::expand() {
    net_.expand();
    for (int axis = 0; axis < 3; ++axis) step_b_[axis] = Rounding(3)(net_.W[axis][0]);
}

void SplineWords::step() {
    const RunWord moved = SplineSeriesWords::sum(net_.q, 1, order_);
    const int guard = setting_.parameter_guard;
    fine_v_ = wrapped(fine_v_ + scaled_down(moved, 1 + guard, lambda_ - k_), bits_ + guard);
    v_ = ranges_.keep(Variable::kParameter, 0, Rounding(guard)(fine_v_));
    net_.phi[0] = ranges_.keep(Variable::kPhi, 0, SplineSeriesWords::sum(net_.phi, 0, net_.top()));
    for (int axis = 3; axis < axes_; ++axis) {
        position_[axis] += step_to_fine_(advance_[axis]);
    }
    setting_.anchor ? anchor() : propagate();
    expand();
}

void SplineWords::anchor() {
    RunProduct norm = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const RunProduct bend = RunProduct(three_a_[axis]) * v_;
        const RunWord slope = ranges_.keep(b_[axis] + Rounding(bits_ - 1)(bend));
        const RunWord mean = ranges_.keep(b_[axis] + Rounding(bits_)(bend));
        const RunWord velocity = 2 * advance_[axis] + Rounding(bits_ - 3).product(mean, v_);
        net_.V[axis][0] = velocity;
        net_.W[axis][0] = scaled_down(slope, 4, lambda_ - k_);
        norm += RunProduct(velocity) * velocity;
    }
    net_.phi[0] = polished(net_.phi[0], ranges_.keep(Variable::kNorm, 0, unit_(norm)));
    net_.derivatives_of_phi();
    place_origin();
}

RunWord SplineWords::polished(RunWord phi, RunWord norm) const {
    const RunWord speed = coef_.product(norm, phi);
    const RunProduct rest = (RunProduct(1) << (2 * bits_ - 3)) - RunProduct(speed) * phi;
    return phi + Rounding(bits_ + 4).product(Rounding(bits_ - 6)(rest), phi);
}

void SplineWords::propagate() {
    net_.Q[0] = SplineSeriesWords::sum(net_.Q, 0, order_);
    net_.R[0] = SplineSeriesWords::sum(net_.R, 0, order_);
    for (int axis = 0; axis < 3; ++axis) {
        net_.V[axis][0] = SplineSeriesWords::sum(net_.V[axis], 0, order_);
        net_.W[axis][0] = SplineSeriesWords::sum(net_.W[axis], 0, order_);
        if (setting_.polynomial()) continue;
        RunWord d = 0;
        for (int i = 1; i <= order_; ++i) d += net_.x[i][axis];
        position_[axis] += step_to_fine_(d);
    }
    if (setting_.polynomial()) place_origin();
}

void SplineWords::place_origin() {
    for (int axis = 0; axis < 3; ++axis) {
        const RunWord e = b_[axis] + unit_.product(a_[axis], v_);
        const RunWord f = advance_[axis] + unit_.product(e, v_);
        position_[axis] = start_[axis] + curve_to_fine_(unit_.product(f, v_));
    }
}

void SplineWords::sample(RunWord sigma, RunWord* out) const {
    const RunWord tau = to_tau(sigma, k_, bits_);
    setting_.polynomial() ? sample_polynomial(tau, out) : sample_series(tau, out);
    for (int axis = 3; axis < axes_; ++axis) {
        out[axis] = position_[axis] + step_to_fine_(unit_.product(advance_[axis], tau));
    }
}

void SplineWords::sample_series(RunWord tau, RunWord* out) const {
    RunWord d[3] = {net_.x[order_][0], net_.x[order_][1], net_.x[order_][2]};
    for (int i = order_ - 1; i >= 1; --i) {
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = net_.x[i][axis] + unit_.product(d[axis], tau);
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        out[axis] = position_[axis] + step_to_fine_(unit_.product(d[axis], tau));
    }
}

void SplineWords::sample_polynomial(RunWord tau, RunWord* out) const {
    RunWord q = net_.q[order_];
    for (int i = order_ - 1; i >= 1; --i) q = net_.q[i] + unit_.product(q, tau);
    q = unit_.product(q, tau);
    for (int axis = 0; axis < 3; ++axis) {
        const RunWord e = step_b_[axis] + coef_.product(step_a_[axis], q);
        const RunWord f = net_.V[axis][0] + coef_.product(e, q);
        out[axis] = position_[axis] + step_to_fine_(unit_.product(f, q));
    }
}

}  // namespace curvecore::sysc
