// SPDX-License-Identifier: Apache-2.0
// A cubic curve in space: position, derivatives, the range of its speed, its parts.
#pragma once

#include <array>
#include <vector>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// | quantity     | symbol           | shape | unit     | domain and remark                     |
/// |--------------|------------------|-------|----------|---------------------------------------|
/// | coefficients | a, b, c, d       | 3     | length   | any one unit of length                |
/// | parameter    | u                |       | 1        | 0 .. 1                                |
/// | position     | r(u)             | 3     | length   |                                       |
/// | velocity     | V = dr/du        | 3     | length   | 0 at a cusp or doubled point          |
/// | speed        | v = |V| = ds/du  |       | length   |                                       |
/// | acceleration | W = dV/du        | 3     | length   |                                       |
/// | jerk         | J = dW/du = 6 a  | 3     | length   | constant                              |
///
///     r(u) = ((a u + b) u + c) u + d
///
/// Error: roundings, position below 2^-50 (|a| + |b| + |c| + |d|).
/// Source: [Chikurov] (20)-(22).
struct Cubic {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
    Vec3 c = Vec3::Zero();
    Vec3 d = Vec3::Zero();

    Vec3 position(double u) const { return ((a * u + b) * u + c) * u + d; }
    Vec3 velocity(double u) const { return (3 * u * a + 2 * b) * u + c; }
    Vec3 acceleration(double u) const { return 6 * u * a + 2 * b; }
    Vec3 jerk() const { return 6 * a; }
    double speed(double u) const { return velocity(u).norm(); }
};

/// Derivatives by path length s, all infinite or undefined where V = 0.
///
/// | function         | equation                                                   | unit       |
/// |------------------|------------------------------------------------------------|------------|
/// | tangent          | T = dr/ds = V / v                                          | 1          |
/// | curvature_vector | d2r/ds2 = (W v^2 - V (V.W)) / v^4, normal to T             | length^-1  |
/// | curvature        | k = |V x W| / v^3, the length of the above                 | length^-1  |
/// | curvature_rate   | d3r/ds3 = -k^2 T + (dk/ds) N + k torsion B                 | length^-2  |
Vec3 tangent(const Cubic& cubic, double u);
Vec3 curvature_vector(const Cubic& cubic, double u);
double curvature(const Cubic& cubic, double u);
Vec3 curvature_rate(const Cubic& cubic, double u);

/// Parameters in (0, 1), ascending, where the speed changes from rising to falling or back: at most
/// three, the zeros of V.W at which it changes its sign. Error: that of a root of a polynomial with
/// rounded coefficients.
std::vector<double> speed_extrema(const Cubic& cubic);

/// Slowest and fastest point of 0 <= u <= 1.
///
/// | field  | symbol       | unit   | error                          |
/// |--------|--------------|--------|--------------------------------|
/// | min    | min v        | length | relative 1e-14, or 1e-14 max v |
/// | max    | max v        | length | relative 1e-14                 |
/// | at_min | u of min     | 1      |                                |
/// | at_max | u of max     | 1      |                                |
struct SpeedRange {
    double min = 0;
    double max = 0;
    double at_min = 0;
    double at_max = 0;
};
SpeedRange speed_range(const Cubic& cubic);

/// Returns true if the curve all but stands still somewhere, min v <= relative * max v: at a cusp,
/// a doubled end point, a zero end tangent, or because it is one point.
bool has_cusp(const Cubic& cubic, double relative = 1e-9);

/// The part u0 .. u1 as a curve of its own, 0 .. 1; u1 < u0 reverses it.
/// Error: r(u0) exact, r(u1) to 2^-49 (|a| + |b| + |c| + |d|), derivatives relative to their terms.
Cubic sub_cubic(const Cubic& cubic, double u0, double u1);

/// Control points of Bernstein's form; the curve starts at the first and ends at the last.
using Bezier = std::array<Vec3, 4>;
Cubic from_bezier(const Bezier& points);
Bezier to_bezier(const Cubic& cubic);

}  // namespace curvecore::ref
