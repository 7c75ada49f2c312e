// SPDX-License-Identifier: Apache-2.0
// The curve that a block with an arc asks for, from the block's own numbers: what the move that was
// made of them (ref/moves/arc_geometry.hpp) is held against. The two share no code.
#pragma once

#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// | field  | unit | remark                                                                    |
/// |--------|------|---------------------------------------------------------------------------|
/// | start  | mm   |                                                                           |
/// | end    | mm   | maybe elsewhere along the normal (helix), maybe not on the circle         |
/// | centre | mm   | as given, at any place along the normal                                   |
/// | normal | 1    | counter-clockwise about it                                                |
/// | turns  |      | that are begun; ends in one direction from the centre are a whole turn    |
/// | loose  | mm   | how far roundings of the numbers move the centre                          |
struct AskedArc {
    Vec3 start;
    Vec3 end;
    Vec3 centre;
    Vec3 normal;
    int turns;
    double loose = 0;

    /// Of a given radius: negative beyond half a turn. About the middle where it is too small.
    static AskedArc of_radius(const Vec3& start, const Vec3& end, double radius, const Vec3& normal,
                              int turns);
};

/// mm: the greatest distance of a move from it at equal shares of their angles, 32 a turn, where
/// the asked one is the circle of the start's radius about the centre, and what lacks to the end
/// goes along evenly. 0 where only roundings are between them.
double distance(const AskedArc& asked, const Move& move);

}  // namespace curvecore::ref
