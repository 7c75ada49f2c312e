// SPDX-License-Identifier: Apache-2.0
// A NURBS (G5.2), with LinuxCNC's knots or its own, as rational curves and as cubics.
#pragma once

#include <string>
#include <vector>

#include "ref/curve/fit/rational_bezier.hpp"

namespace curvecore::ref {

constexpr int kHighestOrder = 16;

/// | field   | unit   | domain                                              |
/// |---------|--------|-----------------------------------------------------|
/// | order   | 1      | degree + 1; 2 .. number of points                   |
/// | points  | length | as many as weights                                  |
/// | weights | 1      | > 0                                                 |
/// | knots   | 1      | why_no_knots(); none: uniform and clamped, 0 order  |
/// |         |        | times, 1, 2, .., and the last order times           |
struct Nurbs {
    int order = 3;
    std::vector<Vec3> points;
    std::vector<double> weights;
    std::vector<double> knots = {};
};

/// Returns the reason why the knots are invalid, empty if they are valid. Valid: the number of
/// points plus the order, not falling, the first and the last `order` times and none between as
/// often, so that the curve runs from its first point to its last in one.
std::string why_no_knots(const Nurbs& nurbs);

/// Its spans from knot to knot that have a length, by the polar form (knot insertion, [Boehm]);
/// exact up to roundings.
std::vector<RationalBezier> spans(const Nurbs& nurbs);

/// The curve as cubics in its order. Polynomials up to degree 3 are exact; others are within
/// `tolerance` of the curve (fit_cubics).
std::vector<Cubic> cubics_of(const Nurbs& nurbs, double tolerance);

}  // namespace curvecore::ref
