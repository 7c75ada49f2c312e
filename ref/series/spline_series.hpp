// SPDX-License-Identifier: Apache-2.0
// The spline network's series about one point, in the scale of hls/spline_network.hpp, as numbers.
#pragma once

#include <array>

#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// Series in tau = s / h of a step that starts at v(0), in its own parameter q:
///
///     v = v(0) + g q     W = dV/dq     6a' = dW/dq     g = h / 2^lambda
///
/// | series     | symbol            | orders | remark                                 |
/// |------------|-------------------|--------|----------------------------------------|
/// | parameter  | q                 | 0 .. K | q_0 = 0                                |
/// | velocity   | V, DV = i V_i     | 0 .. K | in 2^lambda per v, or h per q          |
/// | W          | W                 | 0 .. K | order 1 is 6a' q_1                     |
/// | position   | x                 | 1 .. K | displacement in h                      |
/// | others     | DP phi Dphi Q R   | 0 .. K | D of order i is i times the order      |
///
/// Source: [Chikurov] (30), R_i with its factor 6.
struct SplineSeries {
    static constexpr int kTop = 20;
    using Terms = std::array<double, kTop + 1>;

    Vec3 six_a;
    std::array<Terms, 3> W, V, DV, x;
    Terms q, phi, Dphi, Q, R, DP;

    /// Orders 0 .. top of a step of h = 2^lambda g units from v. top <= kTop.
    void expand(const Segment& segment, double v, double g, int top);

    /// Sum of terms from .. to.
    static double sum(const Terms& terms, int from, int to) {
        double total = 0;
        for (int i = to; i >= from; --i) total += terms[static_cast<std::size_t>(i)];
        return total;
    }
};

}  // namespace curvecore::ref
