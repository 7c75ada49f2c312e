// SPDX-License-Identifier: Apache-2.0
// Arcs that leave in a given direction, and two of them from one point and direction to another.
#pragma once

#include <array>
#include <optional>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// An arc of less than a turn in a plane of its own; a straight line where `angle` is 0.
///
/// | field   | symbol | unit   | remark                                          |
/// |---------|--------|--------|-------------------------------------------------|
/// | start   | p      | length |                                                 |
/// | end     | q      | length |                                                 |
/// | tangent | t      | 1      | at the start; a line's points to its end        |
/// | inward  | n      | 1      | from the start to the centre; 0 for a line      |
/// | radius  | R      | length | 0 for a line                                    |
/// | angle   |        | rad    | [0, 2 pi)                                       |
struct TangentArc {
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    Vec3 tangent = Vec3::UnitX();
    Vec3 inward = Vec3::Zero();
    double radius = 0;
    double angle = 0;

    double length() const;
    double curvature() const { return angle > 0 ? 1 / radius : 0; }
    /// Point at path length s: p + R (t sin a + n 2 sin^2(a/2)), a = s / R.
    Vec3 at(double s) const;
};

constexpr double kFlatRise = 1e-9;  // mm: an arc that rises less above its chord is a line

TangentArc straight(const Vec3& start, const Vec3& end);

/// The arc from `start` along the unit vector `tangent` to `end`, a different point.
TangentArc tangent_arc(const Vec3& start, const Vec3& tangent, const Vec3& end);

/// Two arcs that meet with one tangent, from `start` along `out` to `end` along `in` (unit
/// vectors). With q0 = start + d out, q1 = end - d in and |q1 - q0| = 2 d they meet in the middle
/// of q0 and q1, along q1 - q0 (Bolton 1975, in space: Sharrock 1987); so
///
///     2 (1 - out.in) d^2 + 2 d (v . (out + in)) - v^2 = 0,   v = end - start
///
/// Returns none unless the directions and the chord agree to less than a right angle.
std::optional<std::array<TangentArc, 2>> biarc(const Vec3& start, const Vec3& out, const Vec3& end,
                                               const Vec3& in);

}  // namespace curvecore::ref
