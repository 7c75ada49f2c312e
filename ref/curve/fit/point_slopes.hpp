// SPDX-License-Identifier: Apache-2.0
// Slopes of splines through points, per axis or for the vector as a whole.
#pragma once

#include <optional>
#include <vector>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// | symbol | meaning                                  | unit       |
/// |--------|------------------------------------------|------------|
/// | y_i    | point i                                  | length     |
/// | t_i    | its parameter, ascending                 | that of t  |
/// | d_i    | t_{i+1} - t_i                            | that of t  |
/// | s_i    | (y_{i+1} - y_i) / d_i                    | length / t |
/// | m_i    | slope at point i, the result              | length / t |
///
/// Every function needs at least two points; two make a straight line.
using Vectors = std::vector<Vec3>;

/// Slopes of the parabola through three neighbours (Bessel; [Petrakov] (1); [Obukhov] (2), who
/// calls it Akima):
///
///     m_i = (s_{i-1} d_i + s_i d_{i-1}) / (d_{i-1} + d_i)
///
/// The ends, which the paper leaves open, have that of the first or last three points:
///
///     m_0 = ((2 d_0 + d_1) s_0 - d_0 s_1) / (d_0 + d_1)
Vectors bessel_slopes(const Vectors& points, const std::vector<double>& t);

/// Akima's slopes, J. ACM 17 (1970), with s continued linearly by two at either end:
///
///     m_i = (|s_{i+1} - s_i| s_{i-1} + |s_{i-1} - s_{i-2}| s_i) / (sum of both weights)
///
/// or the mean of s_{i-1} and s_i where both weights are 0. The weights are lengths of vectors, so
/// the curve does not depend on the axes; along one axis they are Akima's.
Vectors akima_slopes(const Vectors& points, const std::vector<double>& t);

/// Condition at an end of a C2 spline: its slope, or else its second derivative ("natural": 0).
struct SplineEnd {
    std::optional<Vec3> slope;
    Vec3 second = Vec3::Zero();
};

/// The C2 spline: the slopes m that make the second derivative continuous,
///
///     d_i m_{i-1} + 2 (d_{i-1} + d_i) m_i + d_{i-1} m_{i+1} = 3 (s_{i-1} d_i + s_i d_{i-1})
Vectors smooth_slopes(const Vectors& points, const std::vector<double>& t, const SplineEnd& start,
                      const SplineEnd& end);

/// Slopes of the closed C2 spline, smooth at its seam as well: the last point is the first. At
/// least four points.
Vectors closed_slopes(const Vectors& points, const std::vector<double>& t);

}  // namespace curvecore::ref
