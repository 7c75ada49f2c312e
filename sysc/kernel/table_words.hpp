// SPDX-License-Identifier: Apache-2.0
// A core's words as the arithmetic of a curve's table (ref/curves/table_machine.hpp): every line is
// rounded once, to nearest, ties upwards.
#pragma once

#include <cmath>

#include "hls/fixed_word.hpp"

namespace curvecore::sysc {

/// Number must hold a sum of 13 products of words exactly: 113 bits.
template <class Number>
struct TableWords {
    int coef_bits = 36;
    int guard_bits = 10;
    int parameter_guard = 0;

    Number rounded(const Number& sum, int fraction) const {
        return nearest(sum, coef_bits + fraction);
    }
    Number weight(int i) const {
        const int bits = coef_bits - 1;
        return scaled(Number(hls::reciprocal(i, bits)), -bits);
    }
    int guard() const { return parameter_guard; }
    Number position(const Number& sum) const { return nearest(sum, guard_bits); }

    /// The value with so many fraction bits.
    static Number nearest(const Number& value, int bits) {
        using std::floor;
        return scaled(floor(scaled(value, bits) + Number(0.5)), -bits);
    }

  private:
    static Number scaled(const Number& value, int power) {
        using std::ldexp;
        return ldexp(value, power);
    }
};

}  // namespace curvecore::sysc
