// SPDX-License-Identifier: Apache-2.0
// A corner of two lines, rounded by one cubic.
#pragma once

#include <cmath>

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

/// [v - d t1, v, v, v + d t2]: both inner points on the corner v, so its curvature is 0 at the
/// ends. It is the time of two overlapping ramps of constant jerk: at its best the speed dips in
/// the middle as for a stop, and never reaches 0.
///
/// Its half is paired with its line by B = v + p (1 - u)^3 + r u^3, p = -d t1, r = d t2, and
/// v + p ((1 - u)^3 - u^3): they differ by u^3 (p + r), u <= 1/2. So each keeps |p + r| / 8 =
/// d sin(turn / 2) / 4 from the other, which is reached at the corner.
struct Corner {
    Vec3 vertex;
    Vec3 before;   // t1, the tangents
    Vec3 after;    // t2
    double reach;  // d, mm of each line

    Bezier points() const {
        return {vertex - reach * before, vertex, vertex, vertex + reach * after};
    }
    double deviation() const { return reach * (after - before).norm() / 8; }
};

/// Reach whose deviation is the tolerance, for a turn in rad.
inline double corner_reach(double turn, double tolerance) {
    return 4 * tolerance / std::sin(turn / 2);
}

}  // namespace curvecore::ref
