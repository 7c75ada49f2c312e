// SPDX-License-Identifier: Apache-2.0
// A chain of Bezier pieces by its path length: points, tangents, curvatures.
#pragma once

#include "ref/join/idle_move.hpp"

namespace curvecore::ref {

/// | quantity  | symbol  | shape | unit | remark                                         |
/// |-----------|---------|-------|------|------------------------------------------------|
/// | path      | s       |       | mm   | 0 .. length()                                  |
/// | tangent   | dr/ds   | 3     | 1    | 0 where the curve stands still                 |
/// | curvature | d2r/ds2 | 3     | 1/mm | (r' x r'') x r' / |r'|^4; 0 there              |
///
/// Gauss's rule of five points in 32 parts of every piece: for figures and for cutting a path into
/// steps. Source: [Obukhov] (3).
class PathTable {
  public:
    explicit PathTable(std::vector<BezierPiece> pieces);

    struct Place {
        std::size_t piece = 0;
        double u = 0;
    };

    double length() const { return knots_.back(); }
    const std::vector<BezierPiece>& pieces() const { return pieces_; }
    /// Path length s at the start of every piece, and at the end.
    std::vector<double> starts() const;
    Place place(double s) const;
    Joint at(double s) const;  // without a feed
    /// Joint at a place: the two pieces that meet in a point may differ there.
    Joint at(const Place& place) const;

  private:
    double part(std::size_t piece, double from, double to) const;

    std::vector<BezierPiece> pieces_;
    std::vector<double> knots_;  // s at the ends of all parts
};

}  // namespace curvecore::ref
