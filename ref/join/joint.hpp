// SPDX-License-Identifier: Apache-2.0
// What an idle move must meet where it leaves one working path and enters the next.
#pragma once

#include "ref/program/move.hpp"

namespace curvecore::ref {

/// The end of a working path, or its start.
///
/// | field     | symbol      | shape | unit | remark                                    |
/// |-----------|-------------|-------|------|-------------------------------------------|
/// | position  | r           | 3     | mm   |                                           |
/// | tangent   | T = dr/ds   | 3     | 1    | |T| = 1, the way the machine goes         |
/// | curvature | d2r/ds2     | 3     | 1/mm | kappa N, normal to T                      |
/// | feed      | v           |       | mm/s | along the path                            |
struct Joint {
    Vec3 position = Vec3::Zero();
    Vec3 tangent = Vec3::UnitX();
    Vec3 curvature = Vec3::Zero();
    double feed = 0;
};

/// A move at its end, or at its start. The move has a feed and moves X, Y or Z.
/// @throws InputError, with `file` and the move's line: no direction (a cusp, a standing end)
Joint joint_of(const std::string& file, const Move& move, bool at_end);

/// A move at the path length s of X Y Z, 0 .. length.
Joint point_of(const Move& move, double s);

/// The program without the rapids behind its last working move, or before its first: they are idle
/// moves themselves. Its end and its start are joints then.
/// @throws InputError: no working move; a dwell or a move of auxiliary axes at the joint
Program until_last_working_move(Program program);
Program from_first_working_move(Program program);

}  // namespace curvecore::ref
