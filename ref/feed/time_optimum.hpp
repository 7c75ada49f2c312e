// SPDX-License-Identifier: Apache-2.0
// The fastest motion along a path under limits of velocity, acceleration and jerk.
#pragma once

#include <array>
#include <vector>

#include "ref/feed/place_limit.hpp"

namespace curvecore::ref {

/// From one knot to the next. The same limits, in the same order, seen from within at its start, in
/// its middle and at its end.
struct PathInterval {
    double length = 0;        // mm
    double velocity = 0;      // mm/s, at both ends
    double end_velocity = 0;  // at its end, besides
    std::array<std::vector<PlaceLimit>, 3> limits;
};

/// At a knot: q = v^2 and the acceleration; the acceleration goes linearly with path length to the
/// next knot, but from rest (the first interval) and to it (the last), where the jerk is constant.
struct KnotMotion {
    double q = 0;
    double a = 0;
};

/// Minimises int ds / sqrt(q) over the quadratic splines q(s), q = v^2, a = q'/2, which are 0 at
/// both ends, so that
///
///     q <= V^2, |r' a + r'' q| <= A               at both ends of every interval
///     |r' a' + 3 r'' a + r''' q| <= J / sqrt(q)   in its middle; in the first and the last one at
///                                                 the end that is not at rest
///
/// Between two knots a' is constant and sqrt(q) is not: the jerk that keeps its limit is the mean
/// one, and that is the jerk of a cubic s(t) through both knots.
///
/// A spline's control point belongs to an interval; at the knot between intervals k - 1 and k
///
///     q = (h_k c_{k-1} + h_{k-1} c_k) / (h_{k-1} + h_k)     a = (c_k - c_{k-1}) / (h_{k-1} + h_k)
///
/// Next to rest q goes with s^(4/3), so a = 2/3 q / s: this ties the first control point to the
/// second, and the last to the one before it.
///
/// Method: logarithmic barrier, Newton's method with a banded Cholesky decomposition. Only 1 /
/// sqrt(q) is not concave; its tangent at the iterate lies below it, so what it allows is allowed.
/// Every iterate keeps all limits, and the time falls from stage to stage. (Verscheure et al. 2009
/// for q(s); the tangent as in Debrouwere et al. 2013; feasible iterates as in Tran-Dinh et al.)
///
/// @param intervals at least 4
/// @param start a motion at every knot, at rest at both ends; slowed until it keeps all limits
/// @param gap stop where the barrier costs at most this share of the time
std::vector<KnotMotion> time_optimum(const std::vector<PathInterval>& intervals,
                                     const std::vector<KnotMotion>& start, double gap);

}  // namespace curvecore::ref
