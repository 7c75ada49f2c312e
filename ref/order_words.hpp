// SPDX-License-Identifier: Apache-2.0
// Words of a width of their own for each order of the sampler: what they cost and what they save.
#pragma once

#include <array>

#include "ref/error_bound.hpp"

namespace curvecore::ref {

/// A study, no core has them. Series mode, arcs: a sample is Horner's rule
/// (hls/spherical_kernel.hpp)
///
///     p_i = round((N_i + p_(i+1)) tau)        i = P .. 1        |N_j| <= theta^(j-1) / j!
///
/// with words of W-2 fraction bits, tau of W-1. The sum of stage i is at most
///
///     A_i = theta^(i-1) / i! + .. + theta^(P-1) / P! + 3 (P - i + 1) half       i >= 2
///
/// (coefficients and products are rounded), so that its top r_i = floor(1 - log2 A_i) bits are
/// copies of the sign: W - r_i bits hold the very same word. Cutting t_i low bits of tau in that
/// stage moves the sample by less than A_i 2^t_i last bits of tau, that is 2 A_i 2^t_i of a
/// coefficient's half last bits (half = 2^-(W-1)), each times tau <= 1 on its way out. Stage 1
/// keeps all its bits: |N_1 + advance| < 2, and an error of its tau is one along the path.
///
/// | field     | meaning                                                                      |
/// |-----------|------------------------------------------------------------------------------|
/// | max_theta | steps turn by no more: the planner's kMaxTheta for such a core               |
/// | extra     | half last bits that a sample loses against the uniform words                 |
/// | sum_bits  | W - r_i, by order                                                            |
/// | tau_bits  | W - t_i, by order, sign included                                             |
struct OrderWords {
    double max_theta = 0.5;
    double extra = 0;
    std::array<int, 13> sum_bits{};
    std::array<int, 13> tau_bits{};
};

/// Of orders 1 .. order; each stage may lose 2^-spare half last bits.
OrderWords order_words(const WordFormat& format, double max_theta, int spare);

/// Products of one lane: sum over the orders of sum_bits tau_bits; uniform words: order W^2.
int lane_bits(const WordFormat& format, const OrderWords& words);

/// The same in blocks of 18 x 18 bits.
int lane_blocks(const WordFormat& format, const OrderWords& words);

/// All orders alike.
OrderWords uniform_words(const WordFormat& format);

}  // namespace curvecore::ref
