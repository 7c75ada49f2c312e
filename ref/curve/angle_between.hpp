// SPDX-License-Identifier: Apache-2.0
// The angle between two directions.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// rad, 0 .. pi, of vectors of any length; 0 where one of them is 0.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace curvecore::ref
