// SPDX-License-Identifier: Apache-2.0
// A rational curve in Bernstein's form, any degree: one span of a NURBS, or a quintic.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

/// | field  | symbol          | shape | unit   | domain and remark                        |
/// |--------|-----------------|-------|--------|------------------------------------------|
/// | origin |                 | 3     | length | points are held relative to it           |
/// | points | (w_i P_i, w_i)  | 4     | length | homogeneous, w_i > 0; degree + 1 of them |
///
///     r(t) = origin + sum w_i P_i B_i(t) / sum w_i B_i(t)      0 <= t <= 1
///
/// Evaluation is de Casteljau's, a convex combination: position errs by a few roundings of the
/// distance from the origin, whatever the weights.
struct RationalBezier {
    Vec3 origin = Vec3::Zero();
    std::vector<Eigen::Vector4d> points;

    struct Point {
        Vec3 position;
        Vec3 derivative;  // by t
    };

    int degree() const { return static_cast<int>(points.size()) - 1; }
    Point at(double t) const;
    /// Returns true if all weights are equal.
    bool polynomial() const;
    /// Returns the same curve as a cubic. Only for degree 1 with any weights, which is a straight
    /// line, and for polynomials of degree 2 and 3.
    Cubic exact_cubic() const;
};

}  // namespace curvecore::ref
