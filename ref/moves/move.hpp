// SPDX-License-Identifier: Apache-2.0
// A program's moves in mm, mm/s, degrees for rotary axes, with the lines that asked for them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ref/curve/axes.hpp"
#include "ref/curve/cubic.hpp"
#include "ref/curve/drawn/table_piece.hpp"
#include "ref/curve/joint_path.hpp"

namespace curvecore::ref {

/// Largest distance of a G-code program's path from the programmed one where it states none: in G64
/// without P, and before any mode.
constexpr double kPathTolerance = 0.01;  // mm

/// A straight line, an arc (circle, helix, any plane), a cubic, the curve of a table, or what a
/// machine's joints do along a piece of these; with auxiliary axes linear in path length.
///
/// | field    | unit    | remark                                                             |
/// |----------|---------|--------------------------------------------------------------------|
/// | centre   | mm      | arcs: r(0) = start; on the plane through start normal to `normal`   |
/// | normal   | 1       | |normal| = 1; counter-clockwise about it                            |
/// | angle    | rad     | > 0, whole turns included                                          |
/// | advance  | mm      | travel over the whole arc besides the turning: along `normal` of a  |
/// |          |         | helix, in the plane where the radii at both ends differ             |
/// | cubic    | mm      | its ends are `start` and `end` to 1e-8 mm; length > 0, may stand    |
/// |          |         | still in points (cusps)                                            |
/// | table    | mm      | its rows at `start`; its end is `end` to 1e-6 mm                   |
/// | table_length | mm  | of a table's curve                                                 |
/// | joints   |         | X Y Z are joints of a machine: start and end are theirs, feed is    |
/// |          |         | by the path that is drawn                                          |
/// | feed     | mm/s    | along the path; 0 = rapid: as fast as the machine allows            |
/// | from, to | mm      | the programmed path that it draws, by the length of all moves       |
struct Move {
    enum class Kind { kLine, kArc, kCubic, kTable, kJoints };

    Kind kind = Kind::kLine;
    int line = 0;  // in the program's file, from 1
    bool rapid = false;
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    Vec3 centre = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double angle = 0;
    Vec3 advance = Vec3::Zero();
    Cubic cubic;
    TablePiece table;
    double table_length = 0;
    JointPath joints;
    Aux aux_start{};
    Aux aux_end{};
    double feed = 0;
    bool exact_stop = false;  // the machine stops at the end of this move
    double dwell = 0;         // s, rest after it (implies a stop)
    double tolerance = 0;     // mm: allowed distance from where it is programmed (G64 P)
    double deviation = 0;     // mm: bound of that distance
    double from = 0;
    double to = 0;

    /// Length along the path, mm: of X Y Z if they move, else of U V W, else of A B C (1 degree = 1
    /// mm). An arc with an advance in its plane has |dr/ds| <= 1, with 1 where it is fastest, so it
    /// is up to twice that advance longer than the curve.
    double length() const;
};

/// Upper limit of the move's speed, mm/s, without the machine's limits.
double fastest_motion(const Move& move);
/// Least time that it takes at no more than a machine's speed, mm/s.
double least_time(const Move& move, double fastest);

struct Program {
    std::string file;
    std::vector<Move> moves;
    std::vector<std::string> warnings;  // "FILE:LINE: warning: text"
    int aux_axes = 0;                   // auxiliary axes in use: highest index + 1
};

}  // namespace curvecore::ref
