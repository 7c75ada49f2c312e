// SPDX-License-Identifier: Apache-2.0
#include "ref/series/spline_series.hpp"

namespace curvecore::ref {
namespace {

/// Sum of u_j ds_{i-j}, j = 0 .. i-1.
double convolve(const SplineSeries::Terms& u, const SplineSeries::Terms& ds, std::size_t i) {
    double sum = 0;
    for (std::size_t j = 0; j < i; ++j) sum += u[j] * ds[i - j];
    return sum;
}

}  // namespace

void SplineSeries::expand(const Segment& segment, double v, double g, int top) {
    six_a = 6 * g * g * segment.a;
    const Vec3 velocity = segment.c + v * (2 * segment.b + 3 * v * segment.a);
    const Vec3 bend = g * (2 * segment.b + 6 * v * segment.a);
    for (std::size_t k = 0; k < 3; ++k) {
        V[k][0] = velocity[static_cast<int>(k)];
        W[k][0] = bend[static_cast<int>(k)];
        x[k][0] = 0;
        DV[k][0] = 0;
    }
    phi[0] = 1 / velocity.norm();
    Q[0] = -phi[0] * phi[0] * phi[0];
    R[0] = -3 * phi[0] * phi[0];
    q[0] = Dphi[0] = DP[0] = 0;
    Terms dq{};
    for (std::size_t i = 1; i <= static_cast<std::size_t>(top); ++i) {
        const double order = static_cast<double>(i);
        dq[i] = phi[i - 1];
        q[i] = dq[i] / order;
        DP[i] = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            x[k][i] = convolve(V[k], dq, i) / order;
            DV[k][i] = convolve(W[k], dq, i);
            DP[i] += convolve(V[k], DV[k], i);
            V[k][i] = DV[k][i] / order;
            W[k][i] = six_a[static_cast<int>(k)] * q[i];
        }
        Dphi[i] = convolve(Q, DP, i);
        phi[i] = Dphi[i] / order;
        Q[i] = convolve(R, Dphi, i) / order;
        R[i] = -6 * convolve(phi, Dphi, i) / order;
    }
}

}  // namespace curvecore::ref
