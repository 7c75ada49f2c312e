// SPDX-License-Identifier: Apache-2.0
// A cubic as tangent arcs in space, or as chords, within a tolerance that is proven.
#pragma once

#include <vector>

#include "ref/curve/cubic.hpp"
#include "ref/curve/fit/biarc.hpp"

namespace curvecore::ref {

struct ArcFit {
    std::vector<TangentArc> arcs;
    double deviation = 0;  // a bound: no point of either curve is farther from the other
};

/// Biarcs on points of the cubic, with its tangents there, each as long as the tolerance allows:
/// [Chikurov], introduction of the spherical interpolator ("approximates any curve by arcs").
///
/// Both curves are run through at constant speed, tau = 0 .. 1. At n + 1 even points their distance
/// e is calculated; between two it exceeds the greater one by at most
///
///     |e''| / (8 n^2),   |e''| <= L_cubic^2 max |r''| / min |r'|^2 + L_biarc^2 max curvature
///
/// with bounds of r' and r'' by the control points. Where the cubic all but stands still no such
/// bound is to be had: there it becomes a line, shorter than the tolerance.
///
/// @param tolerance in the cubic's unit, above 2^-40 of its coordinates
ArcFit fit_arcs(const Cubic& cubic, double tolerance);

/// Parameters of points on the cubic, from 0 to 1, whose chords are within the tolerance: |r''| h^2
/// / 8 by the control points.
std::vector<double> fit_chords(const Cubic& cubic, double tolerance);

}  // namespace curvecore::ref
