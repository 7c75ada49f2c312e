// SPDX-License-Identifier: Apache-2.0
// Places on a move, and its parts.
#pragma once

#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// | field     | symbol    | shape | unit | remark                                             |
/// |-----------|-----------|-------|------|----------------------------------------------------|
/// | position  | r         | 3     | mm   |                                                    |
/// | tangent   | T = dr/ds | 3     | 1    | |T| = 1, <= 1 on an arc with an advance in its     |
/// |           |           |       |      | plane; of joints as they go                        |
/// | curvature | d2r/ds2   | 3     | 1/mm | kappa N; normal to T where |T| = 1 all along       |
struct MovePlace {
    Vec3 position = Vec3::Zero();
    Vec3 tangent = Vec3::UnitX();
    Vec3 curvature = Vec3::Zero();

    /// Returns the place by the curve's own length: |T| = 1, and kappa N.
    MovePlace by_length() const;
};

/// Returns the place on a move at the path length s of X Y Z, 0 .. length.
MovePlace place_on(const Move& move, double s);

/// Returns the part of a move between two path lengths. The stop and the dwell stay behind its own
/// end.
Move part_of(const Move& move, double from, double to);

}  // namespace curvecore::ref
