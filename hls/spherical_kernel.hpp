// SPDX-License-Identifier: Apache-2.0
// Words of the spherical interpolator: six Riemann integrators, [Chikurov] Fig. 8, equation (19).
// Twins: rtl/network/spherical_network.sv and rtl/sampler/, ref/series/,
// ref/plan/segment_curve.hpp.
//
// The network integrates the unit vectors n = r/R (the paper's x y z) and t = B x r/R (F G H):
//
//     dn = phi t ds        dt = -phi n ds
//
// A step of h = 2^k length units has theta = h phi. Coefficients of order i >= 1 are scaled by the
// step, not by the radius (N_i = n_i / theta), so that a coefficient never exceeds 1 and the
// displacement's series in tau = s/h has just these coefficients, in units of 2^k:
//
//     N_1 = t    T_1 = -n    N_i = (theta/i) T_{i-1}    T_i = -(theta/i) N_{i-1}
//
// Rounding: one per order and node; one per weight; one per state and step.
#pragma once

#include "hls/sampling.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// One step of the sine/cosine network ([Chikurov] Fig. 2), two Riemann integrators, scaled by the
/// step: y_1 = z, z_1 = -y, y_i = (theta/i) z_{i-1}, z_i = -(theta/i) y_{i-1}. The spherical
/// network is three of these.
template <class C>
struct Oscillator {
    using Coef = typename C::Coef;
    using Product = typename C::Product;

    Coef y;                          // state: sine, or a component of n
    Coef z;                          // state: cosine, or a component of t
    Coef y_coef[C::kMostOrder + 1];  // [1 .. Order]
    Coef z_coef[C::kMostOrder + 1];

    /// Expands the series with weight[i] = theta / i for i in [2, Order], weight[1] = theta; the
    /// words are those of `of_y` and `of_z`.
    void expand(const C& c, const Coef* weight, Variable of_y, Variable of_z) {
        y = c.keep(of_y, 0, y);
        z = c.keep(of_z, 0, z);
        y_coef[1] = c.keep(of_y, 1, z);
        z_coef[1] = c.keep(of_z, 1, Coef(-y));
        for (int i = 2; i <= c.kOrder; ++i) {
            y_coef[i] =
                c.keep(of_y, i, rounded_product<Product>(weight[i], z_coef[i - 1], c.kUnitFrac));
            z_coef[i] = c.keep(
                of_z, i, rounded_product<Product>(weight[i], Coef(-y_coef[i - 1]), c.kUnitFrac));
        }
    }

    void advance(const C& c, const Coef& theta) {
        Coef y_sum = 0;
        Coef z_sum = 0;
        for (int i = 1; i <= c.kOrder; ++i) {
            y_sum = Coef(y_sum + y_coef[i]);
            z_sum = Coef(z_sum + z_coef[i]);
        }
        y = Coef(y + rounded_product<Product>(theta, y_sum, c.kUnitFrac));
        z = Coef(z + rounded_product<Product>(theta, z_sum, c.kUnitFrac));
    }
};

/// The integration steps of one segment and the samples inside a step.
template <class C>
class SphericalKernel : private C {
  public:
    using Coef = typename C::Coef;
    using Fine = typename C::Fine;

    SphericalKernel() = default;
    explicit SphericalKernel(const C& format) : C(format) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        theta_ = segment.theta;
        k_ = segment.step_exponent;
        for (int axis = 0; axis < C::kAxes; ++axis) {
            position_[axis] = segment.start[axis];
            advance_[axis] = segment.advance[axis];
        }
        for (int axis = 0; axis < 3; ++axis) {
            xyz_[axis].y = segment.normal[axis];
            xyz_[axis].z = segment.tangent[axis];
        }
        weight_[1] = C::keep(Variable::kWeight, 1, theta_);
        for (int i = 2; i <= C::kOrder; ++i) {
            weight_[i] =
                C::keep(Variable::kWeight, i, unit(theta_, Coef(reciprocal(i, C::kUnitFrac))));
        }
        if (!C::kSeries) {
            angle_.y = 0;
            angle_.z = Coef(Coef(1) << C::kCoefFrac);
            angle_.expand(*this, weight_, Variable::kSine, Variable::kVersine);
        }
        expand();
    }

    /// Moves on to the next integration step.
    void step() {
        for (int axis = 0; axis < C::kAxes; ++axis) {
            Coef sum = axis < 3 ? Coef(0) : advance_[axis];
            for (int i = 1; i <= C::kOrder && axis < 3; ++i) {
                sum = Coef(sum + c_[axis][i]);
            }
            position_[axis] = Fine(position_[axis] + fine(sum));
        }
        for (int axis = 0; axis < 3; ++axis) {
            xyz_[axis].advance(*this, theta_);
        }
        expand();
    }

    /// Returns the fine position at an offset of sigma quanta into the present step.
    void sample(const Word<kLengthBits + 1>& sigma, Fine* out) const {
        const Coef tau = to_tau<C>(*this, sigma, k_);
        if (C::kSeries) {
            sample_series(tau, out);
        } else {
            sample_polynomial(tau, out);
        }
        for (int axis = 3; axis < C::kAxes; ++axis) {
            out[axis] = Fine(position_[axis] + fine(unit(advance_[axis], tau)));
        }
    }

  private:
    using Product = typename C::Product;

    Coef unit(const Coef& a, const Coef& b) const {
        return rounded_product<Product>(a, b, C::kUnitFrac);
    }
    Fine fine(const Coef& d) const { return to_fine<C>(*this, d, k_); }

    void expand() {
        for (int axis = 0; axis < 3; ++axis) {
            xyz_[axis].expand(*this, weight_, Variable::kNormal, Variable::kTangent);
            for (int i = 1; i <= C::kOrder; ++i) {
                const Coef linear = i == 1 ? advance_[axis] : Coef(0);
                c_[axis][i] = C::keep(Variable::kMove, i, Coef(xyz_[axis].y_coef[i] + linear));
            }
        }
    }

    /// Draws a sample in series mode: Horner in tau on the displacement's series.
    void sample_series(const Coef& tau, Fine* out) const {
        for (int axis = 0; axis < 3; ++axis) {
            Coef d = 0;
            for (int i = C::kOrder; i >= 1; --i) {
                d = unit(Coef(c_[axis][i] + d), tau);
            }
            out[axis] = Fine(position_[axis] + fine(d));
        }
    }

    /// Draws a sample in polynomial mode: r0 cos + f0 sin, from the two series in tau2 = tau^2:
    ///     d = (t (y_1 + y_3 tau2 + ..) + advance) tau + n (z_2 tau2 + z_4 tau2^2 + ..)
    void sample_polynomial(const Coef& tau, Fine* out) const {
        const int odd = C::kOrder % 2 == 1 ? C::kOrder : C::kOrder - 1;
        const int even = C::kOrder % 2 == 0 ? C::kOrder : C::kOrder - 1;
        const Coef tau2 = unit(tau, tau);
        Coef sine = angle_.y_coef[odd];
        for (int i = odd - 2; i >= 1; i -= 2) {
            sine = Coef(angle_.y_coef[i] + unit(sine, tau2));
        }
        Coef versine = angle_.z_coef[even];
        for (int i = even - 2; i >= 2; i -= 2) {
            versine = Coef(angle_.z_coef[i] + unit(versine, tau2));
        }
        versine = unit(versine, tau2);
        for (int axis = 0; axis < 3; ++axis) {
            const Coef rate =
                Coef(advance_[axis] + rounded_product<Product>(xyz_[axis].z, sine, C::kCoefFrac));
            const Coef inward = rounded_product<Product>(xyz_[axis].y, versine, C::kCoefFrac);
            out[axis] = Fine(position_[axis] + fine(Coef(inward + unit(rate, tau))));
        }
    }

    Coef theta_ = 0;
    int k_ = 0;
    Coef weight_[C::kMostOrder + 1] = {};
    Fine position_[C::kMostAxes] = {};
    Coef advance_[C::kMostAxes] = {};
    Oscillator<C> xyz_[3] = {};
    Oscillator<C> angle_ = {};
    Coef c_[3][C::kMostOrder + 1] = {};
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
