// SPDX-License-Identifier: Apache-2.0
// Stretches of an arc: where axes are slower than the path, its speed depends on the direction.
#pragma once

#include <vector>

#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

/// A stretch between two parts of the move's length.
struct ArcStretch {
    double from = 0;
    double to = 1;
    PathShape shape;
};

/// Returns stretches that lose no more than 40 % of the speed that the machine and the move's feed
/// allow at any of their points, in order; all of the arc where no axis is slow.
std::vector<ArcStretch> arc_stretches(const Move& move, const Machine& machine);

}  // namespace curvecore::ref
