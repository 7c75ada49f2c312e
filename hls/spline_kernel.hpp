// SPDX-License-Identifier: Apache-2.0
// Words of the spline interpolator: a cubic drawn at constant path speed, [Chikurov] equation (30).
// Twins: rtl/network/spline_steps.sv and rtl/sampler/, ref/series/, ref/curve/cubic.hpp.
//
//     r(v) = start + 2^lambda ((a v + b) v + c) v        0 <= v < 1
//
// The planner guarantees 1/2 < |V| < 1 for V = dr/dv / 2^lambda, |3a v + b| < 2, |a| < 2/3, and
// steps so short that the network's words keep their ranges (hls/spline_network.hpp) and m below
// 1, which the phi of the step before may exceed where |V| comes near 1.
// Between steps v is the only state with Anchor = 1: position, V, W and phi are made from it. It
// adds up with G = ParameterGuard fraction bits more than the products have of it.
//
// Every step, with A = CoefBits-2 and U = CoefBits-1 fraction bits, s = lambda - k, each line one
// rounding (to nearest, ties up) of a full product or sum:
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
// In the longest chain: 2 4 7 8 8 8 9 9 of the table, then for each order the last products of DV,
// DP and Dphi, and phi's weight unless the order is a power of two; at last q_P's weight. Order 6:
// 8 + 17 + 1 products, one after the other. Line 6 is off the chain.
//
// With Anchor = 0 lines 2..4 and 7..9 work at load only; V W phi Q R (and the position in series
// mode) go on by the sums of their words.
//
// A sample, tau = s / 2^k (U) from the path's low bits:
//
//     series       d = ((x_P tau + ..) tau + x_1) tau (A)                3 Order products
//     polynomial   q = ((q_P tau + ..) tau + q_1) tau (A)                Order + 9 products
//                  e = B' + a' q (U)    f = V + e q (U)    d = f q (A)   for each axis
//     position = origin + d 2^k (fine)
#pragma once

#include <type_traits>

#include "hls/sampling.hpp"
#include "hls/spline_network.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

template <class C>
class SplineKernel {
  public:
    static constexpr int kBits = C::kCoefBits;
    using Coef = Word<kBits>;
    using Fine = Word<C::kFineBits>;
    using FineParameter = Word<kBits + C::kParameterGuard>;
    using Network = SplineNetwork<C>;

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
        for (int axis = 0; axis < 3; ++axis) {
            a_[axis] = segment.tangent[axis];
            b_[axis] = segment.normal[axis];
            three_a_[axis] = Coef(3 * a_[axis]);
            step_a_[axis] = scaled_down<kBits, 1>(a_[axis], 2 * (lambda_ - k_));
            net_.six_a[axis] = scaled_down<kBits, 4>(three_a_[axis], 2 * (lambda_ - k_));
        }
        anchor();
        net_.expand();
    }

    /// Goes on to the next integration step.
    void step() {
        const Coef moved = Network::sum(net_.q, 1, C::kOrder);
        constexpr int kGuard = C::kParameterGuard;
        fine_v_ = FineParameter(
            fine_v_ + scaled_down<kBits, 1 + kGuard, kBits + kGuard>(moved, lambda_ - k_));
        v_ = Coef(round_shift<kBits + kGuard, kGuard>(fine_v_));
        net_.phi[0] = Network::sum(net_.phi, 0, Network::kTop);
        for (int axis = 3; axis < C::kAxes; ++axis) {
            position_[axis] = Fine(position_[axis] + to_fine<C>(advance_[axis], k_));
        }
        if (C::kAnchor) {
            anchor();
        } else {
            propagate();
        }
        net_.expand();
    }

    /// Fine position at an offset of sigma quanta into the present step.
    void sample(const Word<kLengthBits + 1>& sigma, Fine* out) const {
        const Coef tau = to_tau<C>(sigma, k_);
        sample_xyz(tau, out, std::integral_constant<bool, Network::kSeries>());
        for (int axis = 3; axis < C::kAxes; ++axis) {
            const Coef d = rounded_product<kBits, C::kUnitFrac>(advance_[axis], tau);
            out[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
        }
    }

  protected:  // the words of a step, for the RTL's tests
    /// Everything that the polynomial gives at v, and phi pulled onto 1 / |V|.
    void anchor() {
        Word<2 * kBits + 2> norm = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Coef& b = b_[axis];
            const Coef& c = advance_[axis];
            const Word<2 * kBits> bend = Word<2 * kBits>(three_a_[axis]) * Word<2 * kBits>(v_);
            const Coef slope = Coef(b + round_shift<2 * kBits, kBits - 1>(bend));
            const Coef mean = Coef(b + round_shift<2 * kBits, kBits>(bend));
            // 2 M v alone may be beyond 1: it wraps, and V does so back.
            const Word<2 * kBits> change = Word<2 * kBits>(mean) * Word<2 * kBits>(v_);
            const Coef velocity = Coef(2 * c + round_shift<2 * kBits, kBits - 3>(change));
            net_.V[axis][0] = velocity;
            net_.W[axis][0] = scaled_down<kBits, 4>(slope, lambda_ - k_);
            norm =
                Word<2 * kBits + 2>(norm + Word<2 * kBits>(velocity) * Word<2 * kBits>(velocity));
        }
        net_.phi[0] = polished(net_.phi[0], Coef(round_shift<2 * kBits + 2, kBits - 1>(norm)));
        net_.derivatives_of_phi();
        place_origin();
        share_with_sampler();
    }

    /// One Newton step of phi -> 1 / sqrt(norm): phi (3 - norm phi^2) / 2.
    static Coef polished(const Coef& phi, const Coef& norm) {
        const Coef speed = rounded_product<kBits, kBits - 2>(norm, phi);
        const Word<2 * kBits> one = Word<2 * kBits>(Word<2 * kBits>(1) << (2 * kBits - 3));
        const Word<2 * kBits> rest =
            Word<2 * kBits>(one - Word<2 * kBits>(speed) * Word<2 * kBits>(phi));
        const Coef z = Coef(round_shift<2 * kBits, kBits - 6>(rest));
        return Coef(phi + rounded_product<kBits, kBits + 4>(z, phi));
    }

    void propagate() {
        net_.Q[0] = Network::sum(net_.Q, 0, C::kOrder);
        net_.R[0] = Network::sum(net_.R, 0, C::kOrder);
        for (int axis = 0; axis < 3; ++axis) {
            net_.V[axis][0] = Network::sum(net_.V[axis], 0, C::kOrder);
            net_.W[axis][0] = Network::sum(net_.W[axis], 0, C::kOrder);
            if (Network::kSeries) {
                const Coef d = Network::sum(net_.x[axis], 1, C::kOrder);
                position_[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
            }
        }
        if (!Network::kSeries) {
            place_origin();
        }
        share_with_sampler();
    }

    void place_origin() {
        for (int axis = 0; axis < 3; ++axis) {
            const Coef e = Coef(b_[axis] + rounded_product<kBits, kBits - 1>(a_[axis], v_));
            const Coef f = Coef(advance_[axis] + rounded_product<kBits, kBits - 1>(e, v_));
            const Coef d = rounded_product<kBits, kBits - 1>(f, v_);
            position_[axis] = Fine(start_[axis] + to_fine<C>(d, lambda_));
        }
    }

    void share_with_sampler() {
        for (int axis = 0; axis < 3; ++axis) {
            step_b_[axis] = round_shift<kBits, 3>(net_.W[axis][0]);
        }
    }

    void sample_xyz(const Coef& tau, Fine* out, std::true_type /*series*/) const {
        for (int axis = 0; axis < 3; ++axis) {
            const Coef d = horner(net_.x[axis], tau);
            out[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
        }
    }

    void sample_xyz(const Coef& tau, Fine* out, std::false_type /*polynomial*/) const {
        const Coef q = horner(net_.q, tau);
        for (int axis = 0; axis < 3; ++axis) {
            const Coef e =
                Coef(step_b_[axis] + rounded_product<kBits, C::kCoefFrac>(step_a_[axis], q));
            const Coef f = Coef(net_.V[axis][0] + rounded_product<kBits, C::kCoefFrac>(e, q));
            const Coef d = rounded_product<kBits, C::kUnitFrac>(f, q);
            out[axis] = Fine(position_[axis] + to_fine<C>(d, k_));
        }
    }

    static Coef horner(const Coef* series, const Coef& tau) {
        Coef sum = series[C::kOrder];
        for (int i = C::kOrder - 1; i >= 1; --i) {
            sum = Coef(series[i] + rounded_product<kBits, C::kUnitFrac>(sum, tau));
        }
        return rounded_product<kBits, C::kUnitFrac>(sum, tau);
    }

    int k_ = 0;
    int lambda_ = 0;
    FineParameter fine_v_ = 0;
    Coef v_ = 0;
    Coef a_[3] = {};
    Coef three_a_[3] = {};
    Coef b_[3] = {};
    Coef advance_[C::kAxes] = {};  // c, and the auxiliary axes' rates
    Coef step_a_[3] = {};          // a'
    Coef step_b_[3] = {};          // B'
    Fine start_[C::kAxes] = {};
    Fine position_[C::kAxes] = {};
    Network net_;
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
