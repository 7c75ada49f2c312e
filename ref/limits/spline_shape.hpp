// SPDX-License-Identifier: Apache-2.0
// Stretches of a cubic with bounds of its curvature, for the speed along it.
#pragma once

#include <vector>

#include "ref/curve/arc_length.hpp"
#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

/// Distance from a standstill up to which the curve counts as sharp as where it is fastest.
constexpr double kTipLength = 1e-5;  // mm

/// Returns the parameters 0 <= u <= 1, ascending, at which the curve stands still: V = 0, or a tip
/// of less than 1e-8 mm radius. The machine stops there.
std::vector<double> standstills(const Cubic& cubic);

/// A stretch from u0 to u1, and bounds that hold all along it.
///
/// | field of shape | bounds                                                                     |
/// |----------------|----------------------------------------------------------------------------|
/// | curvature      | k = |M| / v^3,           M = V x W, v = |V|                                |
/// | twist          | k as well: r''' along the path is -k^2                                     |
/// | swerve         | |r''' across the path| = |G| / v^6,  G = v^2 M' - 3 (V.W) M                |
/// | swing          | components of V / v, r'' / curvature and the swerving part of r''' / swerve |
/// | along          | components of V / v                                                        |
///
/// Each is the convex hull of a polynomial over a power of the least speed. Within kTipLength of a
/// standstill, where k grows as s^-1/2, they are those of the stretch's fastest point: from rest
/// the speed grows as s^2/3, so the loads vanish. Source: Frenet's formulas.
struct SplineStretch {
    double u0 = 0;
    double u1 = 1;
    PathShape shape;
};

/// Returns stretches that lose no more than 40 % of the speed that the machine and the move's feed
/// allow at any of their points, in order, at least 1e-6 mm long. `arc` is that of move.cubic (mm).
std::vector<SplineStretch> spline_stretches(const Move& move, const ArcLength& arc,
                                            const Machine& machine, double u0, double u1);

}  // namespace curvecore::ref
