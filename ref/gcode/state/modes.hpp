// SPDX-License-Identifier: Apache-2.0
// Modal state of a program besides the motion code and the coordinates.
#pragma once

#include <optional>

#include "ref/moves/move.hpp"

namespace curvecore::ref {

enum class FeedMode { kPerMinute, kInverseTime, kPerTurn };
enum class Turning { kNo, kClockwise, kCounterClockwise };

/// | field          | unit  | remark                                                 |
/// |----------------|-------|--------------------------------------------------------|
/// | normal_axis    |       | of the plane: 2 for G17, 1 for G18, 0 for G19          |
/// | path_tolerance | mm    | of G64                                                 |
/// | feed           |       | F as written: per minute, of degrees or of `feed_unit` |
/// | feed_unit      | mm    |                                                        |
/// | speed          | 1/min | of the spindle, without a sign                         |
/// | surface_speed  |       | G96: S is the surface's, in m/min or feet a minute     |
/// | retract_to_r   |       | G99: canned cycles end at R, not where the first began |
struct Modes {
    int normal_axis = 2;
    bool absolute_centre = false;
    bool exact_stop = false;
    double path_tolerance = kPathTolerance;
    FeedMode feed_mode = FeedMode::kPerMinute;
    std::optional<double> feed;
    double feed_unit = 1;
    double speed = 0;
    bool surface_speed = false;
    Turning turning = Turning::kNo;
    bool retract_to_r = true;
};

}  // namespace curvecore::ref
