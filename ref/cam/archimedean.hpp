// SPDX-License-Identifier: Apache-2.0
// The longest piece of an Archimedean spiral that stays within delta of a curve rho = f(theta),
// [Tamm] (6)-(14). A spiral rho = k theta + e is a chord in (theta, rho).
#pragma once

#include <Eigen/Core>

namespace curvecore::ref {

/// rho = sum of f[i] w^i in an angle w of its own; [Tamm] (6) has f = (d, c, b, a, 0, 0, 0). On a
/// helix over a bicubic surface the curve is of degree 6.
using PolarCurve = Eigen::Matrix<double, 7, 1>;

double value(const PolarCurve& f, double w);

/// Largest |f - chord| between w0 and w1, along rho.
double chord_deviation(const PolarCurve& f, double w0, double w1);

/// End w1 of the longest piece from w0 that goes no further than `end` and deviates by at most
/// delta.
///
/// A cubic: for both signs of delta, the abscissa w' of the greatest deviation solves (12), k is
/// (10), and w1 is the other meeting of (13) and (14); the largest w1 that keeps delta on all of
/// its piece is taken. The paper cuts a piece at the knot without looking again: with an inflexion
/// inside, the shorter chord may deviate by more (1.29 delta was seen); here it is shortened. A
/// higher degree: the same from its cubic part at w0, then shortened or lengthened until it keeps
/// delta and uses nine tenths of it.
double longest_piece(const PolarCurve& f, double w0, double end, double delta);

}  // namespace curvecore::ref
