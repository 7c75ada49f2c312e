// SPDX-License-Identifier: Apache-2.0
// Letters as in hls/spline_network.hpp; P its Order, W its CoefBits. e(x) is the largest error of
// x.
#include "ref/series/spline_roundings.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

using Terms = SplineSeries::Terms;

/// Error of a sum of u_j ds_{i-j}, j = 0 .. i-1, before its rounding.
double convolved(const Terms& u, const Terms& eu, const Terms& ds, const Terms& eds,
                 std::size_t i) {
    double sum = 0;
    for (std::size_t j = 0; j < i; ++j) {
        sum += eu[j] * std::abs(ds[i - j]) + std::abs(u[j]) * eds[i - j];
    }
    return sum;
}

/// Error of a word that is `value` exactly and rounded from something `before` away: a word below
/// half a last bit is 0, and wrong by its value.
double rounded(double value, double before, double half) {
    const double size = std::abs(value);
    return size + before < half ? size : before + half;
}

bool power_of_two(std::size_t i) { return (i & (i - 1)) == 0; }

}  // namespace

// Lines 1 .. 9 of hls/spline_kernel.hpp. A product by a zero word is exact.
void SplineRoundings::set_anchor(const WordFormat& format, const Segment& segment,
                                 const SplineSeries& series, double v, double prediction) {
    const int width = format.coef_bits;
    const int shift = segment.lambda - segment.step_exponent;
    double along = 0;  // T . e(V)
    const double p = series.phi[0];
    for (int k = 0; k < 3; ++k) {
        const bool bent = segment.a[k] != 0;
        const bool turned = bent || segment.b[k] != 0;
        const bool moved = v > 0;
        const double mean = bent && moved ? half_bit(width - 2) : 0;
        anchor.V[k] = 2 * v * mean + (turned && moved ? half_bit(width - 1) : 0);
        anchor.W[k] =
            std::ldexp(2 * mean, -shift) + (turned && shift > 4 ? half_bit(width + 1) : 0);
        anchor.half_W[k] = anchor.W[k] / 2 + (turned ? half_bit(width - 1) : 0);
        anchor.a[k] = bent && shift > 0 ? half_bit(width - 1) : 0;
        anchor.six_a[k] = bent && shift > 2 ? half_bit(width + 1) : 0;
        along += std::abs(series.V[static_cast<std::size_t>(k)][0]) * p * anchor.V[k];
    }
    // phi -> phi + (1 - N phi phi) phi / 2: N, m, z and the sum are rounded; Newton squares what
    // the prediction missed.
    anchor.phi = p * p * along + p * p * p / 2 * half_bit(width - 1) +
                 p * p / 2 * half_bit(width - 1) + p / 2 * half_bit(width + 3) +
                 half_bit(width - 2) + 1.5 * p * prediction * prediction * (1 + prediction);
}

void SplineRoundings::expand(const WordFormat& format, const SplineSeries& s) {
    const int width = format.coef_bits;
    const double weight = half_bit(width - 1);
    const double p = std::abs(s.phi[0]);
    Terms dq_value{}, dq{}, dp{}, dphi{}, big_q{}, r{};
    std::array<Terms, 3> w{}, v{}, dv{};
    phi[0] = anchor.phi;
    for (int k = 0; k < 3; ++k) {
        v[static_cast<std::size_t>(k)][0] = anchor.V[k];
        w[static_cast<std::size_t>(k)][0] = anchor.W[k];
    }
    const double square = 2 * p * anchor.phi + half_bit(width - 3);
    big_q[0] = p * square + p * p * anchor.phi + half_bit(width - 4);
    r[0] = 3 * square + half_bit(width - 5);
    words = 1;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(format.order); ++i) {
        const double inverse = 1 / static_cast<double>(i);
        const double part = power_of_two(i) ? 0 : weight;  // error of the word of 1/i
        dq_value[i] = s.phi[i - 1];
        dq[i] = phi[i - 1];
        q[i] = i == 1 ? dq[1]
                      : rounded(s.q[i], dq[i] * inverse + std::abs(dq_value[i]) * part,
                                half_bit(width - 2));
        if (i == 1 || std::abs(s.q[i]) + q[i] > half_bit(width - 2)) words = static_cast<int>(i);
        dp[i] = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double dx = convolved(s.V[k], v[k], dq_value, dq, i) + half_bit(width - 2);
            x[k][i] = i == 1
                          ? dx
                          : rounded(s.x[k][i], dx * inverse + std::abs(s.x[k][i]) / inverse * part,
                                    half_bit(width - 2));
            dv[k][i] =
                rounded(s.DV[k][i], convolved(s.W[k], w[k], dq_value, dq, i), half_bit(width + 1));
            const double dpk = convolved(s.V[k], v[k], s.DV[k], dv[k], i);
            dp[i] += dpk > 0 || s.DV[k][i] != 0 ? dpk + half_bit(width + 1) : 0;
            v[k][i] = rounded(s.V[k][i], dv[k][i] * inverse + std::abs(s.DV[k][i]) * part,
                              half_bit(width - 1));
            const double six_a = std::abs(s.six_a[static_cast<int>(k)]);
            w[k][i] = rounded(s.W[k][i],
                              six_a * q[i] + anchor.six_a[static_cast<int>(k)] * std::abs(s.q[i]),
                              half_bit(width + 1));
        }
        dphi[i] = rounded(s.Dphi[i], convolved(s.Q, big_q, s.DP, dp, i), half_bit(width));
        phi[i] =
            rounded(s.phi[i], dphi[i] * inverse + std::abs(s.Dphi[i]) * part, half_bit(width - 2));
        const double dq_node = convolved(s.R, r, s.Dphi, dphi, i) + half_bit(width - 4);
        big_q[i] = rounded(s.Q[i], dq_node * inverse + std::abs(s.Q[i]) / inverse * part,
                           half_bit(width - 4));
        double squared = 0;
        for (std::size_t j = 0; j <= i; ++j) squared += std::abs(s.phi[j]) * phi[i - j];
        r[i] = 3 * (2 * squared + half_bit(width - 3)) + half_bit(width - 5);
    }
}

}  // namespace curvecore::ref
