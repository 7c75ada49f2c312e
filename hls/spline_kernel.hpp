// SPDX-License-Identifier: Apache-2.0
// Words of the spline interpolator: a cubic drawn at constant path speed, [Chikurov] equation (30).
// Twins: rtl/network/spline_steps.sv and rtl/sampler/, ref/series/, ref/curve/cubic.hpp.
//
//     r(v) = start + 2^lambda ((a v + b) v + c) v        0 <= v < 1
//
// The planner guarantees 1/2 < |V| < 1 for V = dr/dv / 2^lambda, |3a v + b| < 2, |a| < 2/3, and
// steps so short that the network's words keep their ranges (hls/spline_network.hpp) and m below 1,
// which the last step's phi may exceed where |V| comes near 1. With Anchor = 1 v is the only state
// between steps: position, V, W and phi are made from it. It accumulates with G = ParameterGuard
// fraction bits more than in products.
//
// The words of every step, with A = CoefBits-2 and U = CoefBits-1 fraction bits, s = lambda - k,
// each line one rounding (to nearest, ties up) of a full product or sum:
//
//   |  1 | a' = a / 4^s (U), 6a' = 6 a / 4^s (CoefBits+1)     at load; 3a = a + 2a (A), exact     |
//   |  2 | B = b + 3a v (A)                                  half of dV/dv                       |
//   |  3 | M = b + 3a v / 2 (A)                              the same product                    |
//   |  4 | V = c + 2 M v (U)                                                                     |
//   |  5 | W = 2 B / 2^s (CoefBits+1);  B' = W / 2 (U)       per step instead of per unit of v   |
//   |  6 | e = a v + b (A);  f = e v + c (A);  d = f v (A);  origin = start + d 2^lambda (fine)  |
//   |  7 | N = V.V (U), a sum of three products                                                  |
//   |  8 | m = N phi (U);  z = 1 - m phi (CoefBits+3);  phi <- phi + z phi / 2 (A)    Newton     |
//   |  9 | S = phi^2 (CoefBits-3);  Q = -S phi (CoefBits-4);  R = -3 S (CoefBits-5)              |
//   | 10 | the network's orders                                                                  |
//   | 11 | next: v <- v + q(1) / 2^s (U + G), then rounded (U) for lines 2 .. 6;                |
//   |    | phi <- phi(1): sums of words                                                          |
//
// Products of a step in polynomial mode with Anchor = 1: lines 2..9 are 23, the network makes it
//
//     Order           4    6    8   12      S as its full sum; every weight 1/i, i > 1, counted
//     products       85  180  311  681      series mode: + 3 P (P + 1) / 2 + 3 P
//
// The longest chain: 2 4 7 8 8 8 9 9 of the table, then for each order the last products of DV, DP
// and Dphi, and phi's weight unless the order is a power of two; at last q_P's weight. Order 6: 8 +
// 17 + 1 products, one after the other. Line 6 is off the chain.
//
// With Anchor = 0 lines 2..4 and 7..9 work at load only; V W phi Q R (and the position in series
// mode) continue as the sums of their words.
//
// A sample, tau = s / 2^k (U) from the path's low bits:
//
//     series       d = ((x_P tau + ..) tau + x_1) tau (A)                3 Order products
//     polynomial   q = ((q_P tau + ..) tau + q_1) tau (A)                Order + 9 products
//                  e = B' + a' q (U)    f = V + e q (U)    d = f q (A)   for each axis
//     position = origin + d 2^k (fine)
#pragma once

#include "hls/sampling.hpp"
#include "hls/spline_network.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

template <class C>
class SplineKernel : private C {
  public:
    using Coef = typename C::Coef;
    using Fine = typename C::Fine;
    using FineParameter = typename C::FineParameter;
    using Network = SplineNetwork<C>;

    SplineKernel() = default;
    explicit SplineKernel(const C& format) : C(format), net_(format) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        k_ = segment.step_exponent;
        lambda_ = segment.lambda;
        v_ = 0;
        fine_v_ = 0;
        net_.phi[0] = segment.theta;
        for (int axis = 0; axis < C::kAxes; ++axis) {
            start_[axis] = segment.start[axis];
            position_[axis] = segment.start[axis];
            advance_[axis] = segment.advance[axis];
        }
        const int twice = 2 * (lambda_ - k_);
        for (int axis = 0; axis < 3; ++axis) {
            a_[axis] = segment.tangent[axis];
            b_[axis] = segment.normal[axis];
            three_a_[axis] = Coef(3 * a_[axis]);
            step_a_[axis] = C::keep(Variable::kStepA, 0, scaled_down<Coef>(a_[axis], 1, twice));
            net_.six_a[axis] =
                C::keep(Variable::kSixA, 0, scaled_down<Coef>(three_a_[axis], 4, twice));
        }
        anchor();
        expand();
    }

    /// Moves on to the next integration step.
    void step() {
        const Coef moved = Network::sum(net_.q, 1, C::kOrder);
        fine_v_ = FineParameter(
            fine_v_ + scaled_down<FineParameter>(moved, 1 + C::kParameterGuard, lambda_ - k_));
        v_ = C::keep(Variable::kParameter, 0, Coef(round_shift(fine_v_, C::kParameterGuard)));
        net_.phi[0] = C::keep(Variable::kPhi, 0, Network::sum(net_.phi, 0, C::kTop));
        for (int axis = 3; axis < C::kAxes; ++axis) {
            position_[axis] = Fine(position_[axis] + fine(advance_[axis]));
        }
        if (C::kAnchor) {
            anchor();
        } else {
            propagate();
        }
        expand();
    }

    /// Returns the fine position at an offset of sigma quanta into the present step.
    void sample(const Word<kLengthBits + 1>& sigma, Fine* out) const {
        const Coef tau = to_tau<C>(*this, sigma, k_);
        if (C::kSeries) {
            for (int axis = 0; axis < 3; ++axis) {
                out[axis] = Fine(position_[axis] + fine(horner(Variable::kX, net_.x[axis], tau)));
            }
        } else {
            sample_polynomial(tau, out);
        }
        for (int axis = 3; axis < C::kAxes; ++axis) {
            out[axis] = Fine(position_[axis] + fine(unit(advance_[axis], tau)));
        }
    }

  protected:  // the words of a step, for the RTL's tests
    using Product = typename C::Product;

    Coef unit(const Coef& a, const Coef& b) const {
        return rounded_product<Product>(a, b, C::kUnitFrac);
    }
    Coef coef(const Coef& a, const Coef& b) const {
        return rounded_product<Product>(a, b, C::kCoefFrac);
    }
    Fine fine(const Coef& d) const { return to_fine<C>(*this, d, k_); }

    void expand() {
        net_.expand();
        for (int axis = 0; axis < 3; ++axis) {
            step_b_[axis] = round_shift(net_.W[axis][0], 3);
        }
    }

    /// Makes everything that the polynomial gives at v, and pulls phi onto 1 / |V|.
    void anchor() {
        const int bits = C::kCoefBits;
        Product norm = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Product bend = Product(Product(three_a_[axis]) * Product(v_));
            const Coef slope =
                C::keep(Variable::kSlope, 0, Coef(b_[axis] + round_shift(bend, bits - 1)));
            const Coef mean =
                C::keep(Variable::kSlope, 1, Coef(b_[axis] + round_shift(bend, bits)));
            // The term 2 M v alone may be beyond 1: it wraps, and V wraps back.
            const Product change = Product(Product(mean) * Product(v_));
            const Coef velocity = Coef(2 * advance_[axis] + round_shift(change, bits - 3));
            net_.V[axis][0] = velocity;
            net_.W[axis][0] = scaled_down<Coef>(slope, 4, lambda_ - k_);
            norm = Product(norm + Product(velocity) * Product(velocity));
        }
        net_.phi[0] =
            polished(net_.phi[0], C::keep(Variable::kNorm, 0, Coef(round_shift(norm, bits - 1))));
        net_.derivatives_of_phi();
        place_origin();
    }

    /// Makes one Newton step of phi -> 1 / sqrt(norm): phi (3 - norm phi^2) / 2.
    Coef polished(const Coef& phi, const Coef& norm) const {
        const int bits = C::kCoefBits;
        const Coef speed = coef(norm, phi);
        const Product one = Product(Product(1) << (2 * bits - 3));
        const Product rest = Product(one - Product(speed) * Product(phi));
        const Coef z = Coef(round_shift(rest, bits - 6));
        return Coef(phi + rounded_product<Product>(z, phi, bits + 4));
    }

    void propagate() {
        net_.Q[0] = Network::sum(net_.Q, 0, C::kOrder);
        net_.R[0] = Network::sum(net_.R, 0, C::kOrder);
        for (int axis = 0; axis < 3; ++axis) {
            net_.V[axis][0] = Network::sum(net_.V[axis], 0, C::kOrder);
            net_.W[axis][0] = Network::sum(net_.W[axis], 0, C::kOrder);
            if (C::kSeries) {
                const Coef d = Network::sum(net_.x[axis], 1, C::kOrder);
                position_[axis] = Fine(position_[axis] + fine(d));
            }
        }
        if (!C::kSeries) {
            place_origin();
        }
    }

    void place_origin() {
        for (int axis = 0; axis < 3; ++axis) {
            const Coef e = Coef(b_[axis] + unit(a_[axis], v_));
            const Coef f = Coef(advance_[axis] + unit(e, v_));
            position_[axis] = Fine(start_[axis] + to_fine<C>(*this, unit(f, v_), lambda_));
        }
    }

    void sample_polynomial(const Coef& tau, Fine* out) const {
        const Coef q = horner(Variable::kQ, net_.q, tau);
        for (int axis = 0; axis < 3; ++axis) {
            const Coef e = Coef(step_b_[axis] + coef(step_a_[axis], q));
            const Coef f = Coef(net_.V[axis][0] + coef(e, q));
            out[axis] = Fine(position_[axis] + fine(unit(f, q)));
        }
    }

    Coef horner(Variable of, const Coef* series, const Coef& tau) const {
        Coef sum = series[C::kOrder];
        for (int i = C::kOrder - 1; i >= 1; --i) {
            sum = C::keep(of, i, Coef(series[i] + unit(sum, tau)));
        }
        return unit(sum, tau);
    }

    int k_ = 0;
    int lambda_ = 0;
    FineParameter fine_v_ = 0;
    Coef v_ = 0;
    Coef a_[3] = {};
    Coef three_a_[3] = {};
    Coef b_[3] = {};
    Coef advance_[C::kMostAxes] = {};  // c, and the auxiliary axes' rates
    Coef step_a_[3] = {};              // a'
    Coef step_b_[3] = {};              // B'
    Fine start_[C::kMostAxes] = {};
    Fine position_[C::kMostAxes] = {};
    Network net_;
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
