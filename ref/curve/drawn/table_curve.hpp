// SPDX-License-Identifier: Apache-2.0
// The exact curve of a table, by the power series of its steps in double precision.
#pragma once

#include <vector>

#include "ref/curve/drawn/table_piece.hpp"

namespace curvecore::ref {

/// A curve in the steps of one length in which its series of 16 orders converge. Error of a
/// position: some 1e-13 of the length.
class TableCurve final : public PathCurve {
  public:
    /// @throws std::domain_error if no step is short enough
    TableCurve(const TablePiece& piece, const Vec3& start, double length);

    Vec3 position(double s) const override { return derivative(s, 0); }
    Vec3 direction(double s) const override { return derivative(s, 1); }
    Vec3 bend(double s) const override { return derivative(s, 2); }
    /// r''', 1/units^2.
    Vec3 bend_rate(double s) const { return derivative(s, 3); }
    double curvature(double s) const override { return bend(s).norm(); }
    SharpestPlace sharpest() const override;
    bool straight() const override { return false; }

    /// Checks that it is a curve of path length. @throws std::domain_error: |r'| is not 1
    void check_path() const;

    double length() const { return length_; }
    /// Returns whether any order of a step moves an axis.
    bool moves(int axis) const;
    /// Places at which the steps end, from 0 to the length.
    std::vector<double> step_ends() const;
    /// Upper bound of |d^n r / ds^n| in the step that begins at a place, n = 1 ..
    double most_derivative(double s, int n) const;
    /// The rows at s: those of a piece that begins there.
    TablePiece piece_at(double s) const;

  private:
    static constexpr int kOrder = 16;

    struct Step {
        TablePiece piece;  // at its start
        Vec3 origin;
        Eigen::Matrix<double, 3, kOrder + 1> series;  // of the position in tau, units
    };

    bool made_in_steps(const Vec3& start, double h);
    std::size_t step_at(double s) const;
    Vec3 derivative(double s, int n) const;

    TablePiece piece_;
    double length_;
    double h_ = 0;  // units
    std::vector<Step> steps_;
};

}  // namespace curvecore::ref
