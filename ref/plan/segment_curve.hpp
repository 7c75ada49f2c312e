// SPDX-License-Identifier: Apache-2.0
// The exact curve of a plan's segment, sample by sample, with which the cores' output is compared.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ref/curve/arc_length.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// The cubic of a spline segment, in length units, 0 <= u <= 1; v = beta u.
inline Cubic to_cubic(const Segment& segment) {
    const double beta = segment.beta;
    const double unit = std::ldexp(1.0, segment.lambda);
    return {segment.a * (unit * beta * beta * beta), segment.b * (unit * beta * beta),
            segment.c * (unit * beta), segment.start};
}

/// Position in closed form, length units, from the segment's real numbers.
///
/// | quantity | symbol     | shape | unit  | domain and remark                                   |
/// |----------|------------|-------|-------|-----------------------------------------------------|
/// | path     | s          |       | units | 0 .. length / 2^16, local                           |
/// | tangent  | t          | 3     | 1     | at s = 0                                            |
/// | normal   | n          | 3     | 1     | outward, at s = 0                                   |
/// | angle    | a = phi s  |       | rad   | phi = cos_pitch / radius; at most a quarter turn    |
/// | position | r(s)       | 3     | units |                                                     |
///
///     r(s) = start + radius (t sin a - n 2 sin^2(a/2)) + advance s
///
/// The chord form has no centre: a large radius costs nothing. Error per axis: the roundings of
/// about eight operations, measured below 0.6 2^-50 max(|start|, s): below 1e-6 units for |start|,
/// s <= 2.1e9 units and any radius.
///
/// A spline is its cubic at the parameter of s, by quadrature: slow. A caller that needs every
/// sample keeps
/// an ArcLength of to_cubic(segment). Error: 1e-13 of the length.
inline Vec3 exact_position(const Segment& segment, double s) {
    if (segment.kind == Segment::Kind::kSpline) {
        const Cubic cubic = to_cubic(segment);
        return cubic.position(parameter_at(cubic, s));
    }
    Vec3 linear = segment.start + segment.advance * s;
    if (segment.radius == 0) {
        return linear;
    }
    const double half = s * segment.cos_pitch / (2 * segment.radius);
    const double sin_half = std::sin(half);
    const double cos_half = std::cos(half);
    const double chord = 2 * segment.radius * sin_half;
    return linear + (segment.tangent * cos_half - segment.normal * sin_half) * chord;
}

/// Position of auxiliary axis `axis`, linear in s; its unit is the plan's.
inline double exact_aux(const Segment& segment, std::size_t axis, double s) {
    return segment.aux_start[axis] + segment.aux_advance[axis] * s;
}

using AxisPoint = std::array<double, kMachineAxes>;

/// Position of all axes, given X Y Z; rotary axes with all their turns, as in the program.
inline AxisPoint exact_point(const Segment& segment, const Vec3& xyz, double s) {
    AxisPoint point{xyz.x(), xyz.y(), xyz.z()};
    for (std::size_t axis = 0; axis < kAuxAxes; ++axis) {
        point[3 + axis] = exact_aux(segment, axis, s) + segment.aux_turned[axis];
    }
    return point;
}

}  // namespace curvecore::ref
