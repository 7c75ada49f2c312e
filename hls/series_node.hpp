// SPDX-License-Identifier: Apache-2.0
// Words of a Stieltjes integrator x = x(0) + integral of u ds, one order of its series at a time,
// [Chikurov] (15):
//
//     D_i = i x_i = sum of u_j Ds_{i-j}, j = 0 .. i-1          x_i = D_i / i
//
// Ds_i = i s_i is the D of the node that makes s, so the factors (i-j) cost nothing. A node whose
// output only integrates others needs no x_i, one that is only an integrand keeps no D_i.
// The products are summed in full; D_i is rounded once, x_i once more. Twin: rtl/node/.
#pragma once

#include "hls/fixed_word.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// Sum of u[j] ds[i - j] for j in [0, i), rounded once. At most 13 products.
template <int Bits, int Shift>
inline Word<Bits> convolve(const Word<Bits>* u, const Word<Bits>* ds, int i) {
    Word<2 * Bits + 4> sum = 0;
    for (int j = 0; j < i; ++j) {
        sum = Word<2 * Bits + 4>(sum + Word<2 * Bits>(u[j]) * Word<2 * Bits>(ds[i - j]));
    }
    return Word<Bits>(round_shift<2 * Bits + 4, Shift>(sum));
}

/// D_i / i with Drop fraction bits less: a product by the word of 1/i, Bits - 1 fraction bits. An
/// order that is a power of two is a shift; the product gives the same bits.
template <int Bits, int Drop>
inline Word<Bits> over_order(const Word<Bits>& d, int i) {
    if (i == 1) {
        return round_shift<Bits, Drop>(d);
    }
    return rounded_product<Bits, Bits - 1 + Drop>(d, Word<Bits>(reciprocal<Bits - 1>(i)));
}

/// A word with `Lift` more fraction bits, divided by 2^shift, shift in [0, 57], rounded once.
template <int Bits, int Lift, int OutBits = Bits>
inline Word<OutBits> scaled_down(const Word<Bits>& x, int shift) {
    return Word<OutBits>(round_shift<58>(Word<58>(Word<58>(x) * (1 << Lift)), shift));
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
