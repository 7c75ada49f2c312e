// SPDX-License-Identifier: Apache-2.0
// The spline's kernel with access to the words of a step, and to its network alone.
#pragma once

#include "hls/curves/spline.hpp"

namespace curvecore::tb {

template <class C>
class OpenSpline : public hls::SplineCurve<C> {
    using Base = hls::SplineCurve<C>;
    using Steps = hls::CurveSteps<C>;

  public:
    using Coef = typename C::Coef;
    using Base::a_;
    using Base::b_;
    using Base::Base;
    using Base::c_;
    using Base::half_W_;
    using Base::orders;
    using Base::origin_;
    using Base::phi_;
    using Base::Q_;
    using Base::q_;
    using Base::R_;
    using Base::S_;
    using Base::six_a_;
    using Base::step_a_;
    using Base::V_;
    using Base::v_;
    using Base::W_;
    using Base::x_;

    /// Makes S, Q and R of phi: phi^2, -phi^3 and -3 phi^2.
    void derivatives_of_phi() {
        S_[0] = product(phi_[0], phi_[0]);
        Q_[0] = Coef(-product(S_[0], phi_[0]));
        R_[0] = Steps::rounded(-3 * typename C::Product(S_[0]), 2);
    }
    /// The displacement from the segment's start, in units of 2^lambda.
    Coef displacement(int axis) const {
        const Coef e = Coef(b_[axis] + product(a_[axis], v_));
        const Coef f = Coef(c_[axis] + product(e, v_));
        return product(f, v_);
    }
    /// The sum of a series' orders first .. last.
    static Coef sum(const Coef* series, int first, int last) {
        Coef all = 0;
        for (int i = first; i <= last; ++i) all = Coef(all + series[i]);
        return all;
    }

  private:
    Coef product(const Coef& a, const Coef& b) const {
        return Steps::rounded(Steps::times(a, b), C::kCoefBits - 1);
    }
};

}  // namespace curvecore::tb
