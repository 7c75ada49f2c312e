// SPDX-License-Identifier: Apache-2.0
// The word width of each order of the sampler: the one rule, in integers. C++14, for hls/. Twin:
// rtl/curvecore_pkg.sv.
//
// Series mode, arcs, steps of theta <= 2^-T rad: a sample is Horner's rule
// (hls/spherical_kernel.hpp)
//
//     p_i = round((N_i + p_(i+1)) tau)        i = P .. 1        |N_j| <= theta^(j-1) / j!
//
// with words of W-2 fraction bits, tau of W-1; half = 2^-(W-1) is half a last bit of a word and a
// last bit of tau. The sum of stage i >= 2 is at most
//
//     A_i = g (theta^(i-1) / i! + .. + theta^(P-1) / P!) + roundings,    g: how much n and t grow
//
// and that is below 2^(1-r) with r = T (i-1) + ceil(log2 i!), since i! is well above a power of two
// for i > 2 (tb/model/series/order_words_test.cpp: for every configuration). So the top r bits are
// copies of the sign, W - r bits hold the very same word. Cutting t low bits of tau in that stage
// moves the sample by less than A_i 2^t half, times tau <= 1 on its way out: with t = r - kSpare by
// less than 2^(1-kSpare) half. Stage 1 keeps all its bits: |N_1 + advance| < 2, and an error of its
// tau is one along the path.
//
// | parameter | range    | meaning                                                  |
// |-----------|----------|----------------------------------------------------------|
// | coef_bits | 18 .. 36 | W                                                        |
// | turn_bits | 0 .. 14  | T; 0: steps of at most 1/2 rad, all orders of W bits     |
// | i         | 1 .. 12  | order                                                    |
#pragma once

namespace curvecore {
namespace ref {

constexpr int kLeastWord = 18;  // one block of a multiplier, and the least of the cores
constexpr int kSpare = 1;       // bits of tau

/// Returns ceil(log2(i!)).
constexpr int factorial_bits(int i) {
    constexpr int kBits[] = {0, 0, 1, 3, 5, 7, 10, 13, 16, 19, 22, 26, 29};
    return kBits[i];
}

/// Number of sign copies in front of the sum of stage i.
constexpr int sign_copies(int turn_bits, int i) {
    return turn_bits > 0 && i > 1 ? turn_bits * (i - 1) + factorial_bits(i) : 0;
}

/// Width of coefficients, sums and products of stage i, bits.
constexpr int sum_bits(int coef_bits, int turn_bits, int i) {
    const int bits = coef_bits - sign_copies(turn_bits, i);
    return bits < kLeastWord ? kLeastWord : bits;
}

/// Width of tau in stage i, bits, its sign included.
constexpr int tau_bits(int coef_bits, int turn_bits, int i) {
    if (turn_bits == 0 || i == 1) return coef_bits;
    const int bits = coef_bits - sign_copies(turn_bits, i) + kSpare;
    return bits < kLeastWord ? kLeastWord : bits;
}

}  // namespace ref
}  // namespace curvecore
