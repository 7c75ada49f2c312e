// SPDX-License-Identifier: Apache-2.0
// An idle move through control points, from the end of one working path to the start of another.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "ref/join/joint.hpp"

namespace curvecore::ref {

/// | fit     | at the joints               | control points | source                          |
/// |---------|-----------------------------|----------------|---------------------------------|
/// | cubic   | tangent                     | C1             | [Petrakov] (2), slopes by (1)   |
/// | moments | curvature, not the tangent  | C0             | (3)-(5), M by (1) twice         |
/// | c2      | tangent                     | C2             | (3)-(5), M solved               |
/// | quintic | tangent and curvature       | C4             | announced; quintic_slopes.hpp   |
enum class JoinFit { kCubic, kMoments, kC2, kQuintic };
constexpr std::array<std::string_view, 4> kJoinFitNames = {"cubic", "moments", "c2", "quintic"};

/// A polynomial in Bernstein's form over h > 0 of the parameter t; degree 3 or 5.
struct BezierPiece {
    double h = 1;
    std::vector<Vec3> points;

    struct Point {
        Vec3 r, d1, d2;  // position, derivatives by t
    };
    int degree() const { return static_cast<int>(points.size()) - 1; }
    Point at(double u) const;  // 0 <= u <= 1
};

/// | field  | symbol          | unit | domain                                                   |
/// |--------|-----------------|------|----------------------------------------------------------|
/// | t      | t_0 .. t_{N+1}  | mm   | ascending from 0: of the start, the N points, the end    |
/// | points | y_1 .. y_N      | mm   | control points, which the move goes through              |
///
/// At the ends dr/dt is the unit tangent, so t is path length there and nearly so between.
struct IdleMove {
    Joint start, end;
    JoinFit fit = JoinFit::kQuintic;
    std::vector<double> t;
    std::vector<Vec3> points;

    /// Start, control points, end.
    std::vector<Vec3> positions() const;
    std::vector<BezierPiece> pieces() const;
};

/// Places `count` points evenly in t on the quintic without curvature at its ends whose t_{N+1} is
/// its own length (a straight line if the tangents allow it).
IdleMove default_idle_move(const Joint& start, const Joint& end, JoinFit fit, int count);

}  // namespace curvecore::ref
