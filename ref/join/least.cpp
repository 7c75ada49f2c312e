// SPDX-License-Identifier: Apache-2.0
#include "ref/join/least.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <stdexcept>

namespace curvecore::ref {
namespace {

using Eigen::MatrixXd;

constexpr double kMet = 1e-6;  // 1 and 1/mm: of slope and curvature at the joints

/// Third derivative by t, for degrees above 3 by differences of control points.
Vec3 third_derivative(const BezierPiece& piece, double u) {
    BezierPiece difference{piece.h, {}};
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
        difference.points.emplace_back(piece.degree() / piece.h *
                                       (piece.points[i + 1] - piece.points[i]));
    }
    return difference.at(u).d2;
}

/// Rows to be minimised, a column per axis: their squares add up to the integral. Gauss's rule of
/// four points is exact for the squares of polynomials of degree 3.
MatrixXd bends(const std::vector<BezierPiece>& pieces, Least least) {
    using Gauss = boost::math::quadrature::gauss<double, 4>;
    MatrixXd rows(4 * pieces.size(), 3);
    Eigen::Index row = 0;
    for (const BezierPiece& piece : pieces) {
        for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
            for (const double sign : {1.0, -1.0}) {
                const double u = (1 + sign * Gauss::abscissa()[i]) / 2;
                const Vec3 value =
                    least == Least::kCurvature ? piece.at(u).d2 : third_derivative(piece, u);
                rows.row(row++) = std::sqrt(Gauss::weights()[i] * piece.h / 2) * value;
            }
        }
    }
    return rows;
}

/// Rows to be zero: errors of slope and second derivative at both ends.
MatrixXd misses(const IdleMove& move, const std::vector<BezierPiece>& pieces) {
    const BezierPiece::Point first = pieces.front().at(0);
    const BezierPiece::Point last = pieces.back().at(1);
    MatrixXd rows(4, 3);
    rows << (first.d1 - move.start.tangent).transpose(),
        (first.d2 - move.start.curvature).transpose(), (last.d1 - move.end.tangent).transpose(),
        (last.d2 - move.end.curvature).transpose();
    return rows;
}

}  // namespace

IdleMove with_least(const IdleMove& move, Least least) {
    const auto count = static_cast<Eigen::Index>(move.points.size());
    const std::vector<BezierPiece> pieces = move.pieces();
    const MatrixXd bend = bends(pieces, least);
    const MatrixXd miss = misses(move, pieces);
    MatrixXd bend_by(bend.rows(), count);  // derivatives by every control point; axes do not mix
    MatrixXd miss_by(miss.rows(), count);
    for (Eigen::Index i = 0; i < count; ++i) {
        IdleMove moved = move;
        moved.points[static_cast<std::size_t>(i)].x() += 1;
        const std::vector<BezierPiece> other = moved.pieces();
        bend_by.col(i) = (bends(other, least) - bend).col(0);
        miss_by.col(i) = (misses(moved, other) - miss).col(0);
    }
    MatrixXd change = MatrixXd::Zero(count, 3);
    if (count > 0) {
        Eigen::JacobiSVD<MatrixXd> met(miss_by, Eigen::ComputeThinU | Eigen::ComputeFullV);
        met.setThreshold(1e-9);
        change = met.solve(-miss);
        const MatrixXd free = met.matrixV().rightCols(count - met.rank());
        if (free.cols() > 0) {
            const MatrixXd left = bend + bend_by * change;
            change -= free * (bend_by * free).completeOrthogonalDecomposition().solve(left);
        }
    }
    if (!((miss + miss_by * change).cwiseAbs().maxCoeff() <= kMet)) {
        throw std::invalid_argument("too few control points to meet tangent and curvature");
    }
    IdleMove best = move;
    for (Eigen::Index i = 0; i < count; ++i) {
        best.points[static_cast<std::size_t>(i)] += change.row(i).transpose();
    }
    return best;
}

}  // namespace curvecore::ref
