// SPDX-License-Identifier: Apache-2.0
// Words of the spherical interpolator: six Riemann integrators, [Chikurov] Fig. 8, equation (19).
// Twins: rtl/network/spherical_network.sv and rtl/sampler/, ref/series/,
// ref/curve/segment_curve.hpp.
//
// The network integrates the unit vectors n = r/R (the paper's x y z) and t = B x r/R (F G H):
//
//     dn = phi t ds        dt = -phi n ds
//
// For a step of h = 2^k length units, theta = h phi. Coefficients of order i >= 1 are scaled by the
// step, not by the radius (N_i = n_i / theta), so that a coefficient never exceeds 1 and the
// displacement's series in tau = s/h has just these coefficients, in units of 2^k:
//
//     N_1 = t    T_1 = -n    N_i = (theta/i) T_{i-1}    T_i = -(theta/i) N_{i-1}
//
// Rounding: one per order and node; one per weight; one per state and step.
#pragma once

#include <type_traits>

#include "hls/sampling.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// One step of the sine/cosine network ([Chikurov] Fig. 2), two Riemann integrators, scaled by the
/// step: y_1 = z, z_1 = -y, y_i = (theta/i) z_{i-1}, z_i = -(theta/i) y_{i-1}. The spherical
/// network is three of these.
template <class C>
struct Oscillator {
    using Coef = Word<C::kCoefBits>;

    Coef y;                      // state: sine, or a component of n
    Coef z;                      // state: cosine, or a component of t
    Coef y_coef[C::kOrder + 1];  // [1 .. Order]
    Coef z_coef[C::kOrder + 1];

    /// weight[i] = theta / i for i in [2, Order], weight[1] = theta.
    void expand(const Coef* weight) {
        y_coef[1] = z;
        z_coef[1] = Coef(-y);
        for (int i = 2; i <= C::kOrder; ++i) {
            y_coef[i] = rounded_product<C::kCoefBits, C::kUnitFrac>(weight[i], z_coef[i - 1]);
            z_coef[i] =
                rounded_product<C::kCoefBits, C::kUnitFrac>(weight[i], Coef(-y_coef[i - 1]));
        }
    }

    void advance(const Coef& theta) {
        Coef y_sum = 0;
        Coef z_sum = 0;
        for (int i = 1; i <= C::kOrder; ++i) {
            y_sum = Coef(y_sum + y_coef[i]);
            z_sum = Coef(z_sum + z_coef[i]);
        }
        y = Coef(y + rounded_product<C::kCoefBits, C::kUnitFrac>(theta, y_sum));
        z = Coef(z + rounded_product<C::kCoefBits, C::kUnitFrac>(theta, z_sum));
    }
};

/// The integration steps of one segment and the samples inside a step.
template <class C>
class SphericalKernel {
  public:
    using Coef = Word<C::kCoefBits>;
    using Fine = Word<C::kFineBits>;

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
        weight_[1] = theta_;
        for (int i = 2; i <= C::kOrder; ++i) {
            weight_[i] = rounded_product<C::kCoefBits, C::kUnitFrac>(
                theta_, Coef(reciprocal<C::kUnitFrac>(i)));
        }
        expand_angle(std::integral_constant<bool, C::kMode == SamplerMode::kPolynomial>());
        expand();
    }

    /// Goes on to the next integration step.
    void step() {
        for (int axis = 0; axis < C::kAxes; ++axis) {
            Coef sum = 0;
            for (int i = 1; i <= C::kOrder; ++i) {
                sum = Coef(sum + displacement(axis, i));
            }
            position_[axis] = Fine(position_[axis] + to_fine<C>(sum, k_));
        }
        for (int axis = 0; axis < 3; ++axis) {
            xyz_[axis].advance(theta_);
        }
        expand();
    }

    /// Fine position at an offset of sigma quanta into the present step.
    void sample(const Word<kLengthBits + 1>& sigma, Fine* out) const {
        const Coef tau = to_tau<C>(sigma, k_);
        sample_xyz(tau, out, std::integral_constant<bool, C::kMode == SamplerMode::kPolynomial>());
        for (int axis = 3; axis < C::kAxes; ++axis) {
            const Coef d = rounded_product<C::kCoefBits, C::kUnitFrac>(advance_[axis], tau);
            out[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
        }
    }

  private:
    Coef displacement(int axis, int i) const {
        const Coef linear = i == 1 ? advance_[axis] : Coef(0);
        return axis < 3 ? Coef(xyz_[axis].y_coef[i] + linear) : linear;
    }

    void expand() {
        for (int axis = 0; axis < 3; ++axis) {
            xyz_[axis].expand(weight_);
            for (int i = 1; i <= C::kOrder; ++i) {
                c_[axis][i] = displacement(axis, i);
            }
        }
    }

    void expand_angle(std::false_type /*series*/) {}
    void expand_angle(std::true_type /*polynomial*/) {
        angle_.y = 0;
        angle_.z = Coef(Coef(1) << C::kCoefFrac);
        angle_.expand(weight_);
    }

    /// Series mode: Horner in tau on the displacement's series.
    void sample_xyz(const Coef& tau, Fine* out, std::false_type /*series*/) const {
        for (int axis = 0; axis < 3; ++axis) {
            Coef d = 0;
            for (int i = C::kOrder; i >= 1; --i) {
                d = rounded_product<C::kCoefBits, C::kUnitFrac>(Coef(c_[axis][i] + d),
                                                                tau_of(tau, i));
            }
            out[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
        }
    }

    /// tau with the bits that stage i of a core has; its sums fit theirs
    /// (ref/format/order_words.hpp).
    static Coef tau_of(const Coef& tau, int i) {
        const int cut = C::kCoefBits - ref::tau_bits(C::kCoefBits, C::kTurnBits, i);
        return Coef(Coef(tau >> cut) << cut);
    }

    /// Polynomial mode: r0 cos + f0 sin, from the two series of the angle in tau2 = tau^2:
    ///     d = (t (y_1 + y_3 tau2 + ..) + advance) tau + n (z_2 tau2 + z_4 tau2^2 + ..)
    void sample_xyz(const Coef& tau, Fine* out, std::true_type /*polynomial*/) const {
        constexpr int kOdd = C::kOrder % 2 == 1 ? C::kOrder : C::kOrder - 1;
        constexpr int kEven = C::kOrder % 2 == 0 ? C::kOrder : C::kOrder - 1;
        const Coef tau2 = rounded_product<C::kCoefBits, C::kUnitFrac>(tau, tau);
        Coef sine = angle_.y_coef[kOdd];
        for (int i = kOdd - 2; i >= 1; i -= 2) {
            sine = Coef(angle_.y_coef[i] + rounded_product<C::kCoefBits, C::kUnitFrac>(sine, tau2));
        }
        Coef versine = angle_.z_coef[kEven];
        for (int i = kEven - 2; i >= 2; i -= 2) {
            versine =
                Coef(angle_.z_coef[i] + rounded_product<C::kCoefBits, C::kUnitFrac>(versine, tau2));
        }
        versine = rounded_product<C::kCoefBits, C::kUnitFrac>(versine, tau2);
        for (int axis = 0; axis < 3; ++axis) {
            const Coef rate = Coef(advance_[axis] +
                                   rounded_product<C::kCoefBits, C::kCoefFrac>(xyz_[axis].z, sine));
            const Coef inward = rounded_product<C::kCoefBits, C::kCoefFrac>(xyz_[axis].y, versine);
            const Coef d = Coef(inward + rounded_product<C::kCoefBits, C::kUnitFrac>(rate, tau));
            out[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
        }
    }

    Coef theta_ = 0;
    int k_ = 0;
    Coef weight_[C::kOrder + 1] = {};
    Fine position_[C::kAxes] = {};
    Coef advance_[C::kAxes] = {};
    Oscillator<C> xyz_[3] = {};
    Oscillator<C> angle_ = {};
    Coef c_[3][C::kOrder + 1] = {};
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
