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
struct SplineNetwork : private C {
    using Coef = typename C::Coef;
    using Product = typename C::Product;

    SplineNetwork() = default;
    explicit SplineNetwork(const C& format) : C(format) {}

    // Set before expand(): phi[0], Q[0], R[0], V[axis][0], W[axis][0], six_a[axis].
    Coef six_a[3] = {};
    Coef q[C::kMostOrder + 1] = {};
    Coef phi[C::kMostOrder + 1] = {};
    Coef Q[C::kMostOrder + 1] = {};
    Coef R[C::kMostOrder + 1] = {};
    Coef W[3][C::kMostOrder + 1] = {};
    Coef V[3][C::kMostOrder + 1] = {};
    Coef x[3][C::kMostOrder + 1] = {};  // x[axis][1 ..], series mode

    /// Makes Q and R of phi: -phi^3 and -3 phi^2.
    void derivatives_of_phi() {
        const Coef s =
            C::keep(Variable::kS, 0, rounded_product<Product>(phi[0], phi[0], C::kCoefBits - 1));
        Q[0] = Coef(-rounded_product<Product>(s, phi[0], C::kCoefBits - 1));
        R[0] = minus_three(s);
    }

    void expand() {
        phi[0] = C::keep(Variable::kPhi, 0, phi[0]);
        Q[0] = C::keep(Variable::kBigQ, 0, Q[0]);
        R[0] = C::keep(Variable::kR, 0, R[0]);
        for (int axis = 0; axis < 3; ++axis) {
            V[axis][0] = C::keep(Variable::kV, 0, V[axis][0]);
            W[axis][0] = C::keep(Variable::kW, 0, W[axis][0]);
        }
        for (int i = 1; i <= C::kOrder; ++i) {
            dq_[i] = phi[i - 1];
            q[i] = C::keep(Variable::kQ, i, over(dq_[i], i, 0));
            if (C::kSeries) {
                for (int axis = 0; axis < 3; ++axis) {
                    x[axis][i] =
                        C::keep(Variable::kX, i, over(sum_of_products(V[axis], dq_, i, 1), i, 0));
                }
            }
            if (i <= C::kTop) {
                phi_order(i);
            }
            if (i < C::kTop || !C::kAnchor) {
                integrands(i);
            }
        }
    }

    /// Returns the state a step farther on: the sum of a series' orders first .. last. Partial sums
    /// may wrap in a register of CoefBits: the sum is the same.
    static Coef sum(const Coef* series, int first, int last) {
        Product total = 0;
        for (int i = first; i <= last; ++i) {
            total = Product(total + series[i]);
        }
        return Coef(total);
    }

  private:
    static Coef minus_three(const Coef& s) {
        return Coef(round_shift(Product(Product(s) * -3), 2));
    }
    /// Returns a sum with CoefBits - `less` fraction bits fewer than the products.
    Coef sum_of_products(const Coef* u, const Coef* ds, int i, int less) const {
        return convolve<Product>(u, ds, i, C::kCoefBits - less);
    }
    Coef over(const Coef& d, int i, int drop) const {
        return over_order<Product>(d, i, C::kCoefBits, drop);
    }

    void phi_order(int i) {
        Product dp = 0;
        for (int axis = 0; axis < 3; ++axis) {
            dv_[axis][i] = C::keep(Variable::kDV, i, sum_of_products(W[axis], dq_, i, 2));
            dp = Product(dp + C::keep(Variable::kDP, i, sum_of_products(V[axis], dv_[axis], i, 1)));
            V[axis][i] = C::keep(Variable::kV, i, over(dv_[axis][i], i, 2));
        }
        dp_[i] = C::keep(Variable::kDP, i, Coef(dp));
        dphi_[i] = C::keep(Variable::kDphi, i, sum_of_products(Q, dp_, i, 3));
        phi[i] = C::keep(Variable::kPhi, i, over(dphi_[i], i, 2));
    }

    void integrands(int i) {
        for (int axis = 0; axis < 3; ++axis) {
            W[axis][i] = C::keep(Variable::kW, i,
                                 rounded_product<Product>(six_a[axis], q[i], C::kCoefBits - 2));
        }
        Q[i] = C::keep(Variable::kBigQ, i, over(sum_of_products(R, dphi_, i, 1), i, 0));
        Product s = 0;
        for (int j = 0; j <= i; ++j) {
            s = Product(s + Product(phi[j]) * Product(phi[i - j]));
        }
        const Coef square = C::keep(Variable::kS, i, Coef(round_shift(s, C::kCoefBits - 1)));
        R[i] = C::keep(Variable::kR, i, minus_three(square));
    }

    Coef dq_[C::kMostOrder + 1] = {};  // dq_[i] = i q_i = phi_{i-1}
    Coef dv_[3][C::kMostOrder + 1] = {};
    Coef dp_[C::kMostOrder + 1] = {};
    Coef dphi_[C::kMostOrder + 1] = {};
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
