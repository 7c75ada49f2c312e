// SPDX-License-Identifier: Apache-2.0
// How far one step's words of the spline network are from the series they stand for.
#pragma once

#include <cmath>

#include "ref/error_bound.hpp"
#include "ref/series/spline_series.hpp"

namespace curvecore::ref {

/// Half a last bit of a word with `frac` fraction bits.
inline double half_bit(int frac) { return std::ldexp(0.5, -frac); }

/// What the anchor at v leaves: largest errors of the words of order 0, and of the constants.
struct AnchorErrors {
    Vec3 V = Vec3::Zero();       // per axis
    Vec3 W = Vec3::Zero();       // per axis
    Vec3 half_W = Vec3::Zero();  // B', the sampler's word
    Vec3 a = Vec3::Zero();       // a', the sampler's word
    Vec3 six_a = Vec3::Zero();   // per axis
    double phi = 0;
};

/// The same for every order, by the recurrences of hls/spline_network.hpp taken in absolute values:
/// each product passes on its factors' errors, each rounding adds half a last bit, each weight 1/i
/// that is no power of two half a last bit of its own.
struct SplineRoundings {
    using Terms = SplineSeries::Terms;

    /// Errors of the anchor's words. `prediction`: relative error of phi before the Newton step.
    AnchorErrors anchor{};
    Terms q{}, phi{};
    std::array<Terms, 3> x{};
    int words = 1;  // q_1 .. q_words may differ from 0

    void set_anchor(const WordFormat& format, const Segment& segment, const SplineSeries& series,
                    double v, double prediction);
    void expand(const WordFormat& format, const SplineSeries& series);
};

}  // namespace curvecore::ref
