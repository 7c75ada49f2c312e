// SPDX-License-Identifier: Apache-2.0
// A rational curve as a chain of cubics within a tolerance, with its tangents at their joints.
#pragma once

#include <vector>

#include "ref/curve/fit/rational_bezier.hpp"

namespace curvecore::ref {

/// The default: 0.02 of the finest length unit, 1 nm; with the cores' bound less than 0.1 unit.
constexpr double kFitTolerance = 2e-8;  // mm

/// Fits cubics: each begins and ends on the curve with the curve's direction. Its two end speeds
/// are free and chosen for the smallest distance, which then falls with the sixth power of a plane
/// piece's length; the curve's own speeds give the fourth. The pieces halve the parameter until the
/// distance of 31 points of each, with a margin of 10 % for what lies between them, is within
/// `tolerance`. At a cusp the curve's own derivatives are taken, the end speed is 0, and the pieces
/// get short: each of them stays within the tolerance as well.
///
/// Measured at 2e-8 mm: a quarter circle of radius 10 mm is 8 pieces, of 25 mm 12, of 1 m 16; their
/// curvature is within 7e-6 of the circle's and jumps by 5e-6 at most. Random plane curves of spans
/// of 20 mm take a piece for 1 to 2 mm, curves in space for 0.7 mm.
///
/// `tolerance` is a length, > 0; the roundings, 2^-46 of the distance from 0, are its floor.
std::vector<Cubic> fit_cubics(const RationalBezier& curve, double tolerance);

/// Distance of the cubic from the part t0 .. t1 of the curve, over `points` points of the cubic.
double distance(const Cubic& cubic, const RationalBezier& curve, double t0, double t1, int points);

}  // namespace curvecore::ref
