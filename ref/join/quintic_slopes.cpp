// SPDX-License-Identifier: Apache-2.0
#include "ref/join/quintic_slopes.hpp"

#include <Eigen/Cholesky>

namespace curvecore::ref {
namespace {

using Ends = Eigen::Matrix<double, 4, 3>;  // m_0, M_0, m_1, M_1 of a piece

/// Gradient of half a piece's integral of |r'''|^2 by its ends' m and M, c = y_1 - y_0:
///
///     by m_0, M_0:     r''''(0), -r'''(0)
///     r'''(0)  =   60 c/h^3 - (36 m_0 + 24 m_1)/h^2 - (9 M_0 - 3 M_1)/h
///     r''''(0) = -360 c/h^4 + (192 m_0 + 168 m_1)/h^3 + (36 M_0 - 24 M_1)/h^2
///
/// and at the other end the same with t, m and r''' of the opposite sign.
struct Gradient {
    Eigen::Matrix4d by_ends;
    Ends by_chord;
};

Gradient gradient(double h, const Vec3& chord) {
    Gradient found;
    found.by_ends << 192 / h, 36, 168 / h, -24,  //
        36, 9 * h, 24, -3 * h,                   //
        168 / h, 24, 192 / h, -36,               //
        -24, -3 * h, -36, 9 * h;
    found.by_ends /= h * h;
    const Eigen::Vector4d of_chord(-360 / h, -60, -360 / h, 60);
    found.by_chord = of_chord / (h * h * h) * chord.transpose();
    return found;
}

}  // namespace

QuinticSlopes quintic_slopes(const Vectors& y, const std::vector<double>& t,
                             const QuinticSlopes& ends) {
    const auto points = static_cast<Eigen::Index>(y.size());
    // All m_i and M_i, a row each; the gradient by the inner ones is zero.
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(2 * points, 3);
    all.topRows<2>() << ends.m.front().transpose(), ends.second.front().transpose();
    all.bottomRows<2>() << ends.m.back().transpose(), ends.second.back().transpose();
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(2 * points, 2 * points);
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(2 * points, 3);
    for (Eigen::Index i = 0; i + 1 < points; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Gradient part = gradient(t[k + 1] - t[k], y[k + 1] - y[k]);
        by.block<4, 4>(2 * i, 2 * i) += part.by_ends;
        rest.middleRows<4>(2 * i) += part.by_chord;
    }
    const Eigen::Index free = 2 * (points - 2);
    if (free > 0) {
        const Eigen::MatrixXd known = rest + by * all;
        all.middleRows(2, free) =
            -by.block(2, 2, free, free).ldlt().solve(known.middleRows(2, free));
    }
    QuinticSlopes found;
    for (Eigen::Index i = 0; i < points; ++i) {
        found.m.emplace_back(all.row(2 * i).transpose());
        found.second.emplace_back(all.row(2 * i + 1).transpose());
    }
    return found;
}

}  // namespace curvecore::ref
