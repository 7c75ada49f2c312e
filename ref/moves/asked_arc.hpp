// SPDX-License-Identifier: Apache-2.0
// The curve that a block with an arc asks for, from the block's own numbers: the check of the move
// that was made from them (ref/moves/arc_geometry.hpp). The two share no code.
#pragma once

#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// | field  | unit | remark                                                                    |
/// |--------|------|---------------------------------------------------------------------------|
/// | start  | mm   |                                                                           |
/// | end    | mm   | perhaps elsewhere along the normal (helix) or off the circle              |
/// | centre | mm   | as given, at any place along the normal                                   |
/// | normal | 1    | counter-clockwise about it                                                |
/// | turns  |      | begun turns; ends in one direction from the centre are a whole turn       |
/// | loose  | mm   | distance by which roundings of the numbers move the centre                |
struct AskedArc {
    Vec3 start;
    Vec3 end;
    Vec3 centre;
    Vec3 normal;
    int turns;
    double loose = 0;

    /// Makes an arc of a given radius, negative beyond half a turn; about the middle if it is too
    /// small.
    static AskedArc of_radius(const Vec3& start, const Vec3& end, double radius, const Vec3& normal,
                              int turns);
};

/// Greatest distance of a move from it, mm, at equal shares of their angles, 32 a turn. The asked
/// curve is the circle of the start's radius about the centre, with the rest to the end added
/// evenly. 0 where only roundings are between them.
double distance(const AskedArc& asked, const Move& move);

}  // namespace curvecore::ref
