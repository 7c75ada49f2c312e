// SPDX-License-Identifier: Apache-2.0
// Slopes and second derivatives of the quintic spline through points.
#pragma once

#include "ref/curve/fit/point_slopes.hpp"

namespace curvecore::ref {

struct QuinticSlopes {
    Vectors m;       // dr/dt
    Vectors second;  // d2r/dt2
};

/// Slopes of the spline through y at ascending t with continuous third and fourth derivatives at
/// every inner point; slopes and second derivatives at its ends are those of `ends`. Among all
/// curves through the same it has the least integral of |r'''|^2 dt; through points of one quintic
/// it is that quintic.
QuinticSlopes quintic_slopes(const Vectors& y, const std::vector<double>& t,
                             const QuinticSlopes& ends);

}  // namespace curvecore::ref
