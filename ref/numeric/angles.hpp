// SPDX-License-Identifier: Apache-2.0
// A turn and a degree.
#pragma once

namespace curvecore::ref {

constexpr double kTurnDegrees = 360;
constexpr double kTurnRadians = 2 * 3.14159265358979323846;
constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

}  // namespace curvecore::ref
