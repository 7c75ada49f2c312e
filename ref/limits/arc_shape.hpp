// SPDX-License-Identifier: Apache-2.0
// Stretches of an arc: where axes are slower than the path, the direction says how fast it may be.
#pragma once

#include <vector>

#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

/// Between two parts of the move's length.
struct ArcStretch {
    double from = 0;
    double to = 1;
    PathShape shape;
};

/// Stretches that lose no more than 40 % of the speed that the machine and the move's feed allow at
/// any of their points, in order; all of the arc where no axis is slow.
std::vector<ArcStretch> arc_stretches(const Move& move, const Machine& machine);

}  // namespace curvecore::ref
