// SPDX-License-Identifier: Apache-2.0
// A point or a direction in X Y Z.
#pragma once

#include <Eigen/Core>

namespace curvecore::ref {

using Vec3 = Eigen::Vector3d;

}  // namespace curvecore::ref
