// SPDX-License-Identifier: Apache-2.0
// The paper's scheme in fixed point: one integration per tick over a whole cubic, with all sixteen
// variables of Fig. 10 carried from tick to tick in words.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "ref/series/interpreter.hpp"
#include "ref/series/spline_state.hpp"

namespace curvecore::ref {

/// Every rate, coefficient and state is a word of `coef_bits`, rounded once, to nearest, from its
/// full sum of products; so is 6a. Lengths are in units of the tick's path, so that the network's
/// step is 1. The binary point of each variable is where its largest value on the exact cubic, or
/// its largest rate, leaves one bit to spare: as a host would scale this cubic.
///
/// Source: [Chikurov] (30).
class PaperWords {
  public:
    /// Starts at u0, with ticks of `step` along the path.
    PaperWords(const Cubic& cubic, int order, int coef_bits, double u0, double step);

    /// Makes a step; returns false if a word left its range.
    bool step();

    Vec3 position() const;

  private:
    // A sum of 13 products of words is exact in it.
    using Real = boost::multiprecision::number<
        boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
        boost::multiprecision::et_off>;
    using State = SplineState<Real>;
    using Axes = std::array<Real, 3>;

    /// Rounds numbers node by node, and notes those that are too large for their words.
    struct Words : Exact {
        std::array<int, kSpline.size()> frac{};
        Real limit;  // 2^(coef_bits - 1)
        bool overflow = false;

        Words(const Cubic& cubic, int coef_bits);
        Real keep(std::size_t node, const Real& value);
        Real rate(std::size_t node, int, const Real& value) { return keep(node, value); }
        Real coefficient(std::size_t node, int, const Real& value) { return keep(node, value); }
    };

    static Axes parameters(const Cubic& cubic, int coef_bits);

    Cubic cubic_;  // in units of the tick's path, from the origin
    Vec3 start_;
    double unit_;
    Words words_;
    NetworkInterpreter<Real, kSpline.size(), 3> network_;
    State state_;
};

}  // namespace curvecore::ref
