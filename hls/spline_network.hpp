// SPDX-License-Identifier: Apache-2.0
// Words of the spline network: one Riemann integrator, three scalers, twelve Stieltjes integrators
// and one adder, [Chikurov] Fig. 10, equation (30), with the factor 6 that the print of R_i lacks.
// Twins: rtl/network/spline_network.sv, ref/series/figures.hpp.
//
// A step of h = 2^k units is drawn in its own parameter q, v = v(0) + q h / 2^lambda, and in the
// variable tau = s / h, so that the only step size in the equations is 1:
//
//     dq = phi dtau    dW = 6a' dq    dV = W dq    dP = V.dV    dphi = Q dP    dQ = R dphi
//     R = -3 phi^2     [dx = V dq, in series mode]
//
// W = dV/dq and a' carry h / 2^lambda and its square: the longer the step, the larger they are.
//
//   | word       | fraction bits | range      | by order i                                        |
//   |------------|---------------|------------|---------------------------------------------------|
//   | q          | CoefBits-2    | [0, 2)     | q_i = phi_{i-1} / i                               |
//   | W, 6a'     | CoefBits+1    | +-1/4      | W_i = 6a' q_i                                     |
//   | DV         | CoefBits+1    | +-1/4      | sum W_j phi_{i-1-j}                               |
//   | V          | CoefBits-1    | +-1        | DV_i / i                                          |
//   | DP (each)  | CoefBits+1    | +-1/4      | sum V_j DV_{i-j}, rounded axis by axis, added     |
//   | Dphi       | CoefBits      | +-1/2      | sum Q_j DP_{i-j}                                  |
//   | phi        | CoefBits-2    | [1, 2)     | Dphi_i / i                                        |
//   | S = phi^2  | CoefBits-3    | [1, 4)     | sum phi_j phi_{i-j}, j = 0 .. i                   |
//   | R          | CoefBits-5    | [-12, -3]  | -3 S_i: floor(-3 S_i / 4 + 1/2)                   |
//   | DQ, Q      | CoefBits-4    | [-8, -1]   | sum R_j Dphi_{i-j}; DQ_i / i                      |
//   | Dx, x      | CoefBits-2    | +-1        | sum V_j phi_{i-1-j}; Dx_i / i                     |
//
// Chain of an order: DV_i -> DP_i -> adder -> Dphi_i -> phi_i. All but the last product of each sum
// is known before; q_i W_i V_i S_i R_i Q_i are off the chain. Products of order i: 7 i + 1 on the
// chain, 1 q_i, 3 W_i, 3 V_i, i + 1 S_i (half of them by symmetry), i + 1 Q_i, 3 (i + 1) x_i.
// With Anchor = 1 phi needs no order above Order - 1, for the Newton step squares its error: q goes
// to Order, V DV DP phi to Order - 1, W Q to Order - 2, S R to Order - 3.
#pragma once

#include "hls/configuration.hpp"
#include "hls/series_node.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

template <class C>
struct SplineNetwork {
    static constexpr int kBits = C::kCoefBits;
    using Coef = Word<kBits>;

    static constexpr bool kSeries = C::kMode == SamplerMode::kSeries;
    static constexpr int kTop = C::kAnchor ? C::kOrder - 1 : C::kOrder;  // highest phi_i needed

    // Set before expand(): phi[0], Q[0], R[0], V[axis][0], W[axis][0], six_a[axis].
    Coef six_a[3] = {};
    Coef q[C::kOrder + 1] = {};
    Coef phi[C::kOrder + 1] = {};
    Coef Q[C::kOrder + 1] = {};
    Coef R[C::kOrder + 1] = {};
    Coef W[3][C::kOrder + 1] = {};
    Coef V[3][C::kOrder + 1] = {};
    Coef x[3][C::kOrder + 1] = {};  // x[axis][1 ..], series mode

    /// phi^2, from which R and Q = -phi^3 start.
    static Coef square(const Coef& p) { return rounded_product<kBits, kBits - 1>(p, p); }
    static Coef minus_three(const Coef& s) {
        return Coef(round_shift<kBits + 3, 2>(Word<kBits + 3>(Word<kBits + 3>(s) * -3)));
    }

    /// Q and R of phi.
    void derivatives_of_phi() {
        const Coef s = square(phi[0]);
        Q[0] = Coef(-rounded_product<kBits, kBits - 1>(s, phi[0]));
        R[0] = minus_three(s);
    }

    void expand() {
        for (int i = 1; i <= C::kOrder; ++i) {
            dq_[i] = phi[i - 1];
            q[i] = over_order<kBits, 0>(dq_[i], i);
            if (kSeries) {
                for (int axis = 0; axis < 3; ++axis) {
                    x[axis][i] =
                        over_order<kBits, 0>(convolve<kBits, kBits - 1>(V[axis], dq_, i), i);
                }
            }
            if (i <= kTop) {
                phi_order(i);
            }
            if (i < kTop || !C::kAnchor) {
                integrands(i);
            }
        }
    }

    /// The state a step farther on: the sum of a series' orders first .. last. What it is on the
    /// way may wrap in a register of CoefBits: the sum is the same.
    static Coef sum(const Coef* series, int first, int last) {
        Word<kBits + 4> total = 0;
        for (int i = first; i <= last; ++i) {
            total = Word<kBits + 4>(total + series[i]);
        }
        return Coef(total);
    }

  private:
    void phi_order(int i) {
        Word<kBits + 2> dp = 0;
        for (int axis = 0; axis < 3; ++axis) {
            dv_[axis][i] = convolve<kBits, kBits - 2>(W[axis], dq_, i);
            dp = Word<kBits + 2>(dp + convolve<kBits, kBits - 1>(V[axis], dv_[axis], i));
            V[axis][i] = over_order<kBits, 2>(dv_[axis][i], i);
        }
        dp_[i] = Coef(dp);
        dphi_[i] = convolve<kBits, kBits - 3>(Q, dp_, i);
        phi[i] = over_order<kBits, 2>(dphi_[i], i);
    }

    void integrands(int i) {
        for (int axis = 0; axis < 3; ++axis) {
            W[axis][i] = rounded_product<kBits, kBits - 2>(six_a[axis], q[i]);
        }
        Q[i] = over_order<kBits, 0>(convolve<kBits, kBits - 1>(R, dphi_, i), i);
        Word<2 * kBits + 4> s = 0;
        for (int j = 0; j <= i; ++j) {
            s = Word<2 * kBits + 4>(s + Word<2 * kBits>(phi[j]) * Word<2 * kBits>(phi[i - j]));
        }
        R[i] = minus_three(Coef(round_shift<2 * kBits + 4, kBits - 1>(s)));
    }

    Coef dq_[C::kOrder + 1] = {};  // dq_[i] = i q_i = phi_{i-1}
    Coef dv_[3][C::kOrder + 1] = {};
    Coef dp_[C::kOrder + 1] = {};
    Coef dphi_[C::kOrder + 1] = {};
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
