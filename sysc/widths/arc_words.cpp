// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/arc_words.hpp"

#include "ref/format/order_words.hpp"

namespace curvecore::sysc {

ArcWords::ArcWords(const CoreParameters& setting, int axes, ValueRanges& ranges)
    : setting_(setting),
      axes_(axes),
      order_(setting.order),
      ranges_(ranges),
      unit_(setting.coef_bits - 1),
      coef_(setting.coef_bits - 2) {
    const CoreParameters& format = setting;
    for (int i = 1; i <= order_; ++i) {
        const int cut = format.coef_bits - ref::tau_bits(format.coef_bits, format.turn_bits, i);
        tau_kept_[i] = -(RunWord(1) << cut);
    }
}

void ArcWords::load(const RunSegment& segment) {
    const int bits = setting_.coef_bits;
    theta_ = segment.theta;
    k_ = segment.step_exponent;
    to_fine_ = FineShift(setting_, k_);
    for (int axis = 0; axis < axes_; ++axis) {
        position_[axis] = segment.start[axis];
        advance_[axis] = segment.advance[axis];
    }
    for (int axis = 0; axis < 3; ++axis) {
        xyz_[axis].y = segment.normal[axis];
        xyz_[axis].z = segment.tangent[axis];
    }
    weight_[1] = ranges_.keep(Variable::kWeight, 1, theta_);
    for (int i = 2; i <= order_; ++i) {
        weight_[i] =
            ranges_.keep(Variable::kWeight, i, unit_.product(theta_, reciprocal(i, bits - 1)));
    }
    if (setting_.polynomial()) {
        angle_.y = 0;
        angle_.z = RunWord(1) << (bits - 2);
        expand(angle_, Variable::kSine, Variable::kVersine);
    }
    expand_axes();
}

void ArcWords::expand(Series& series, Variable y, Variable z) {
    ranges_.keep(y, 0, series.y);
    ranges_.keep(z, 0, series.z);
    series.y_coef[1] = ranges_.keep(y, 1, series.z);
    series.z_coef[1] = ranges_.keep(z, 1, -series.y);
    for (int i = 2; i <= order_; ++i) {
        series.y_coef[i] = ranges_.keep(y, i, unit_.product(weight_[i], series.z_coef[i - 1]));
        series.z_coef[i] = ranges_.keep(z, i, unit_.product(weight_[i], -series.y_coef[i - 1]));
    }
}

void ArcWords::expand_axes() {
    for (int axis = 0; axis < 3; ++axis) {
        expand(xyz_[axis], Variable::kNormal, Variable::kTangent);
        for (int i = 1; i <= order_; ++i) {
            const RunWord linear = i == 1 ? advance_[axis] : 0;
            c_[i][axis] = ranges_.keep(Variable::kMove, i, xyz_[axis].y_coef[i] + linear);
        }
    }
}

void ArcWords::step() {
    for (int axis = 0; axis < axes_; ++axis) {
        RunWord sum = axis < 3 ? 0 : advance_[axis];
        for (int i = 1; i <= order_ && axis < 3; ++i) sum += c_[i][axis];
        position_[axis] += to_fine_(sum);
    }
    for (Series& series : xyz_) {
        RunWord y_sum = 0;
        RunWord z_sum = 0;
        for (int i = 1; i <= order_; ++i) {
            y_sum += series.y_coef[i];
            z_sum += series.z_coef[i];
        }
        series.y = ranges_.keep(Variable::kNormal, 0, series.y + unit_.product(theta_, y_sum));
        series.z = ranges_.keep(Variable::kTangent, 0, series.z + unit_.product(theta_, z_sum));
    }
    expand_axes();
}

void ArcWords::sample(RunWord sigma, RunWord* out) const {
    const RunWord tau = to_tau(sigma, k_, setting_.coef_bits);
    setting_.polynomial() ? sample_polynomial(tau, out) : sample_series(tau, out);
    for (int axis = 3; axis < axes_; ++axis) {
        out[axis] = position_[axis] + to_fine_(unit_.product(advance_[axis], tau));
    }
}

void ArcWords::sample_series(RunWord tau, RunWord* out) const {
    RunWord d[3] = {};
    for (int i = order_; i >= 1; --i) {
        const RunWord kept = tau & tau_kept_[i];
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = unit_.product(c_[i][axis] + d[axis], kept);
        }
    }
    for (int axis = 0; axis < 3; ++axis) out[axis] = position_[axis] + to_fine_(d[axis]);
}

RunWord ArcWords::by_twos(const RunWord* series, int first, int last, RunWord q) const {
    RunWord sum = series[first];
    for (int i = first - 2; i >= last; i -= 2) sum = series[i] + unit_.product(sum, q);
    return sum;
}

void ArcWords::sample_polynomial(RunWord tau, RunWord* out) const {
    const int odd = order_ % 2 == 1 ? order_ : order_ - 1;
    const int even = order_ % 2 == 0 ? order_ : order_ - 1;
    const RunWord q = unit_.product(tau, tau);
    const RunWord sine = by_twos(angle_.y_coef, odd, 1, q);
    const RunWord versine = unit_.product(by_twos(angle_.z_coef, even, 2, q), q);
    for (int axis = 0; axis < 3; ++axis) {
        const RunWord rate = advance_[axis] + coef_.product(xyz_[axis].z, sine);
        const RunWord inward = coef_.product(xyz_[axis].y, versine);
        out[axis] = position_[axis] + to_fine_(inward + unit_.product(rate, tau));
    }
}

}  // namespace curvecore::sysc
