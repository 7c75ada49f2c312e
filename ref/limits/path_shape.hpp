// SPDX-License-Identifier: Apache-2.0
// A move as a function of path length: its derivatives' loads on the axes.
#pragma once

#include <array>
#include <optional>

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// The tool's path where X Y Z are joints of a machine, with bounds of its derivatives by the path
/// that the core draws.
struct ToolShape {
    double rate = 1;       // |r'| where it moves
    double curvature = 0;  // |r''|, 1/mm
    double swerve = 0;     // |r'''|, but its part along the path that a circle has, 1/mm^2
    Vec3 tangent_start = Vec3::Zero();
    Vec3 tangent_end = Vec3::Zero();
    Vec3 bend_start = Vec3::Zero();
    Vec3 bend_end = Vec3::Zero();
};

/// Derivatives of the path by its length:
///
///     r' = turn t + advance      r'' = -curvature n      r''' = -curvature twist t + swerve m
///
/// with unit vectors t, n and m, the latter two at right angles to t; |r'| <= 1. Lines and arcs are
/// exactly so; for a stretch of a spline (ref/limits/spline_shape.hpp) the values are bounds. Of
/// joints (ref/limits/joint_shape.hpp), whose derivatives are at no such angles, they are, too: any
/// load of an axis is at most that of the form above with its swing.
///
/// | field     | unit    | remark                                                            |
/// |-----------|---------|-------------------------------------------------------------------|
/// | length    | mm      | of the path; stretched where an auxiliary axis is the fastest      |
/// | rate      | 1       | programmed length / length, <= 1                                  |
/// | turn      | 1       | |circular part of r'|; 0 for lines                                |
/// | twist     | rad/mm  | turn / radius                                                     |
/// | curvature | 1/mm    | turn twist                                                        |
/// | swerve    | 1/mm^2  | of r''' across the path: 0 for lines and arcs                     |
/// | swing     | 1       | per axis: largest component of t, n and m along the move          |
/// | advance   | 1       | per axis: constant part of r'                                     |
/// | drift     | 1       | |its part in the plane of t and n|: of arcs whose radii at both   |
/// |           |         | ends differ; the rest is at right angles to that plane            |
/// | along     | 1       | per axis: largest |r'|                                            |
struct PathShape {
    double length = 0;
    double rate = 1;
    double turn = 0;
    double twist = 0;
    double curvature = 0;
    double swerve = 0;
    bool linear = true;  // X Y Z or U V W move: the machine's own limits hold along the path
    AxisVector swing{};
    AxisVector advance{};
    double drift = 0;
    AxisVector along{};
    AxisVector tangent_start{};  // r'
    AxisVector tangent_end{};
    Vec3 bend_start = Vec3::Zero();  // r''
    Vec3 bend_end = Vec3::Zero();
    std::optional<ToolShape> tool;  // of joints: the path whose own limits hold
};

/// Shape of a line or an arc, or of the stretch between two parts of its length.
PathShape path_shape(const Move& move, double from = 0, double to = 1);

}  // namespace curvecore::ref
