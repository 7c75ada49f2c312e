// SPDX-License-Identifier: Apache-2.0
// The conditions on an idle move where it leaves one working path and enters the next.
#pragma once

#include "ref/moves/move_part.hpp"

namespace curvecore::ref {

/// The end of a working path, or its start.
///
/// Its `feed` v is in mm/s along the path, in the machine's direction.
struct Joint : MovePlace {
    double feed = 0;
};

/// Returns the joint at a move's end, or at its start. The move has a feed and moves X, Y or Z.
/// @throws InputError, with `file` and the move's line: no direction (a cusp, a standing end)
Joint joint_of(const std::string& file, const Move& move, bool at_end);

/// Returns the program without the rapids behind its last working move, or before its first: they
/// are idle moves themselves. Its end and its start are joints then.
/// @throws InputError: no working move; a dwell or a move of auxiliary axes at the joint
Program until_last_working_move(Program program);
Program from_first_working_move(Program program);

}  // namespace curvecore::ref
