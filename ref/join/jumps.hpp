// SPDX-License-Identifier: Apache-2.0
// The speed along an idle move, and its jumps where it meets the working paths.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ref/join/path_table.hpp"

namespace curvecore::ref {

constexpr double kGravity = 9806.65;  // mm/s^2

/// Course of the speed from v0 to v1 along the move, x = s / length:
///
///     even     v^2 = v0^2 + (v1^2 - v0^2) x                  constant acceleration, jumps at ends
///     smooth   v = v0 + (v1 - v0) (10 x^3 - 15 x^4 + 6 x^5)  acceleration 0 at both ends
enum class SpeedLaw { kSmooth, kEven };
constexpr std::array<std::string_view, 2> kSpeedLawNames = {"smooth", "even"};

struct SpeedCourse {
    SpeedLaw law = SpeedLaw::kSmooth;
    double v0 = 0;  // mm/s
    double v1 = 0;
    double length = 1;  // mm

    double speed(double s) const;
    double acceleration(double s) const;  // along the path, dv/dt = v dv/ds
};

/// Jumps at a joint; 0 where they are rounding only.
///
/// | field     | equation                    | unit | remark                               |
/// |-----------|-----------------------------|------|--------------------------------------|
/// | slope     | angle between the tangents  | rad  | a corner: the machine must stop      |
/// | curvature | |change of d2r/ds2|         | 1/mm |                                      |
/// | across    | v^2 curvature / g           | 1    | [Petrakov]'s 0.04 g, as centripetal  |
/// | along     | |change of dv/dt| / g       | 1    | the same, as a change of speed       |
struct Jump {
    double slope = 0;
    double curvature = 0;
    double across = 0;
    double along = 0;
};

/// `acceleration`: along the idle move at the joint; the working paths keep their feed.
Jump jump(const Joint& working, const Joint& idle, double acceleration);

struct JoinJumps {
    std::string name;
    double length = 0;  // mm, length of the idle move
    Jump start, end;
};

/// Jumps of the move itself.
JoinJumps jumps(const IdleMove& move, SpeedLaw law);

/// Largest jump at the move's own control points.
Jump worst_inside(const IdleMove& move, SpeedLaw law);

/// Jumps of a straight line, of the arc that leaves along the first tangent, and of every fit
/// through the
/// same control points.
std::vector<JoinJumps> compare_joins(const IdleMove& move, SpeedLaw law);

}  // namespace curvecore::ref
