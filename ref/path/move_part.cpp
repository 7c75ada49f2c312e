// SPDX-License-Identifier: Apache-2.0
#include "ref/path/move_part.hpp"

#include <Eigen/Geometry>

namespace curvecore::ref {

MovePlace place_on(const Move& move, double part) {
    const double length = move.length();
    if (move.kind == Move::Kind::kLine) {
        const Vec3 way = move.end - move.start;
        return {part == 1 ? move.end : Vec3(move.start + part * way), way / length, Vec3::Zero()};
    }
    const Vec3 arm = move.start - move.centre;
    const Vec3 out = Eigen::AngleAxisd(part * move.angle, move.normal) * arm;
    const double twist = move.angle / length;
    // From the start, so that a far centre costs no digits.
    const Vec3 position = move.start + (out - arm) + part * move.advance * move.normal;
    return {part == 1 ? move.end : position,
            twist * move.normal.cross(out) + move.advance / length * move.normal,
            -twist * twist * out};
}

Move part_of(const Move& move, double from, double to) {
    Move part = move;
    part.start = place_on(move, from).position;
    part.end = place_on(move, to).position;
    part.centre += from * move.advance * move.normal;
    part.angle *= to - from;
    part.advance *= to - from;
    if (to < 1) {
        part.exact_stop = false;
        part.dwell = 0;
    }
    return part;
}

}  // namespace curvecore::ref
