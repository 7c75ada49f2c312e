// SPDX-License-Identifier: Apache-2.0
// Stretches of what joints do along a tool's path, with bounds of the derivatives of both.
#pragma once

#include <vector>

#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

/// A stretch between two places, mm from the piece's start on the path that the core draws, and
/// bounds that hold all along it: what the sums of the series' magnitudes cannot exceed.
struct JointStretch {
    double from = 0;
    double to = 0;
    PathShape shape;
};

/// Returns stretches that lose no more than 40 % of the speed that machine and feed allow at any of
/// their places, in order; of a move of Kind::kJoints.
std::vector<JointStretch> joint_stretches(const Move& move, const Machine& machine);

}  // namespace curvecore::ref
