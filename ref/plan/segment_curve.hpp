// SPDX-License-Identifier: Apache-2.0
// The exact curve of a plan's segment, sample by sample, with which the cores' output is compared.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// Returns the exact curve of a segment in X Y Z.
inline std::unique_ptr<PathCurve> exact_curve(const Segment& segment) {
    const double length = std::ldexp(static_cast<double>(segment.length), -16);
    return std::visit([&](const auto& piece) { return piece.path(segment.start, length); },
                      segment.curve);
}

/// Position at s, length units; a caller that needs every sample keeps the curve.
inline Vec3 exact_position(const Segment& segment, double s) {
    return exact_curve(segment)->position(s);
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
