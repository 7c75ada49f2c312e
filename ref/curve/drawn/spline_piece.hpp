// SPDX-License-Identifier: Apache-2.0
// A piece of a cubic at constant path speed, as a core draws it.
#pragma once

#include <memory>

#include "ref/curve/cubic.hpp"
#include "ref/curve/drawn/path_curve.hpp"

namespace curvecore::ref {

/// A cubic in a parameter v of its own, in length units:
///
///     r(v) = start + 2^lambda ((a v + b) v + c) v       0 <= v <= beta,  v(s) by path length
///
/// with 1/2 < |dr/dv| / 2^lambda < 1 (ref/segment/spline_segment.hpp). Error of a position: 1e-13
/// of the length; derivatives: roundings.
struct SplinePiece {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
    Vec3 c = Vec3::Zero();
    int lambda = 0;
    double beta = 0;

    /// Returns the same curve for 0 <= u <= 1, v = beta u.
    Cubic cubic(const Vec3& start) const;

    const char* name() const { return "spline"; }
    std::unique_ptr<PathCurve> path(const Vec3& start, double length) const;
};

}  // namespace curvecore::ref
