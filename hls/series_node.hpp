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

/// Returns the sum of u[j] ds[i - j] for j in [0, i), rounded once. At most 13 products.
template <class Product, class T>
inline T convolve(const T* u, const T* ds, int i, int shift) {
    Product sum = 0;
    for (int j = 0; j < i; ++j) {
        sum = Product(sum + Product(u[j]) * Product(ds[i - j]));
    }
    return T(round_shift(sum, shift));
}

/// Returns D_i / i with `drop` fraction bits less: a product by the word of 1/i, bits - 1 fraction
/// bits. An order that is a power of two is a shift; the product gives the same bits.
template <class Product, class T>
inline T over_order(const T& d, int i, int bits, int drop) {
    if (i == 1) {
        return round_shift(d, drop);
    }
    return rounded_product<Product>(d, T(reciprocal(i, bits - 1)), bits - 1 + drop);
}

/// Returns a word with `lift` more fraction bits, divided by 2^shift, shift in [0, 57], rounded
/// once.
template <class Out, class T>
inline Out scaled_down(const T& x, int lift, int shift) {
    return Out(round_shift(Word<64>(Word<64>(x) * (1 << lift)), shift));
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
