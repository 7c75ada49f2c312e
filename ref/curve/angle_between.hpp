// SPDX-License-Identifier: Apache-2.0
// The angle between two directions.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// Angle in rad, 0 .. pi, between vectors of any length; 0 if one of them is 0.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace curvecore::ref
