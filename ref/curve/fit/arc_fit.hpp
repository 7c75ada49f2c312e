// SPDX-License-Identifier: Apache-2.0
// A cubic as tangent arcs in space, or as chords, within a proven tolerance.
#pragma once

#include <vector>

#include "ref/curve/cubic.hpp"
#include "ref/curve/fit/biarc.hpp"

namespace curvecore::ref {

struct ArcFit {
    std::vector<TangentArc> arcs;
    double deviation = 0;  // a bound: no point of either curve is farther from the other
};

/// Fits biarcs on points of the cubic, with its tangents there, each as long as the tolerance
/// allows: [Chikurov], introduction of the spherical interpolator ("approximates any curve by
/// arcs").
///
/// Both curves are traversed at constant speed, tau = 0 .. 1. Their distance e is calculated at n +
/// 1 even points; between two it exceeds the greater one by at most
///
///     |e''| / (8 n^2),   |e''| <= L_cubic^2 max |r''| / min |r'|^2 + L_biarc^2 max curvature
///
/// with bounds of r' and r'' from the control points. Where the cubic all but stands still there is
/// no such bound: there it becomes a line, shorter than the tolerance.
///
/// @param tolerance in the cubic's unit, above 2^-40 of its coordinates
ArcFit fit_arcs(const Cubic& cubic, double tolerance);

/// Returns parameters of points on the cubic, from 0 to 1, whose chords are within the tolerance,
/// |r''| h^2 / 8 from the control points.
std::vector<double> fit_chords(const Cubic& cubic, double tolerance);

}  // namespace curvecore::ref
