// SPDX-License-Identifier: Apache-2.0
// Words of the hyperbola y = 1 / (k (t0 + t)): one Riemann and one Stieltjes integrator, [Chikurov]
// Fig. 3.  Twins: rtl/network/hyperbola_network.sv, ref/series/figures.hpp, ref/bound/.
//
//     dy = z dt        dz = -2 k y dy        z = -k y^2
//
// In a step of h, y is carried as h k y = h / (t0 + t), z as h^2 k z, and time as tau = t / h. So
// the equations have no number but the start word:
//
//     dy = z dtau      dz = -2 y dy          y(tau) = y / (1 + y tau)
//
//   | word | fraction bits | range      | by order i                                              |
//   |------|---------------|------------|---------------------------------------------------------|
//   | y    | CoefBits      | [0, 1/2)   | y_i = z_{i-1} / i, at most 2^-(i+1)                     |
//   | z    | CoefBits      | (-1/4, 0]  | z_i = -sum y_j y_{i-j}, j = 0 .. i, at most 1/4         |
//
// Legal: 0 < y < 1/2 at the start, t0 > 2 h; then y falls and no word leaves its range. A y below
// 2^-b loses b bits, and y^2 loses 2 b: y stops when its square rounds to 0. So h should be a good
// part of t0 + t.
//
// (15)'s integral of y dy is half the square: z_i has no product by 1/i. Rounding: one for each
// word, to nearest, ties up; y_1 = z_0 has none.
//
//     Anchor = 1   z_0 = -y^2 at every step's start: y is the only state
//     Anchor = 0   at the first; then z is the sum of its words, as in the paper. Nothing
//                  pulls C = z + y^2 back to 0: y falls through 0 in the end, and leaves its range
#pragma once

#include "hls/configuration.hpp"
#include "hls/series_node.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// The steps of one hyperbola; y[i] for i in [0, Order], z[i] to Order - 1, or to Order with
/// Anchor = 0.
template <class C>
struct HyperbolaKernel : private C {
    using Coef = typename C::Coef;
    using Product = typename C::Product;

    HyperbolaKernel() = default;
    explicit HyperbolaKernel(const C& format) : C(format) {}

    Coef y[C::kMostOrder + 1] = {};
    Coef z[C::kMostOrder + 1] = {};

    void load(const Coef& start) {
        y[0] = start;
        z[0] = minus_square(0);
        expand();
    }

    /// Moves on to the next step.
    void step() {
        y[0] = sum(y);
        z[0] = C::kAnchor ? minus_square(0) : sum(z);
        expand();
    }

  private:
    void expand() {
        for (int i = 1; i <= C::kOrder; ++i) {
            y[i] = over_order<Product>(z[i - 1], i, C::kCoefBits, 0);
            if (i < C::kOrder || !C::kAnchor) {
                z[i] = minus_square(i);
            }
        }
    }

    Coef minus_square(int i) const {
        Product square = 0;
        for (int j = 0; j <= i; ++j) {
            square = Product(square + Product(y[j]) * Product(y[i - j]));
        }
        return Coef(-round_shift(square, C::kCoefBits));
    }

    Coef sum(const Coef* series) const {
        Product total = 0;
        for (int i = 0; i <= C::kOrder; ++i) {
            total = Product(total + series[i]);
        }
        return Coef(total);
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
