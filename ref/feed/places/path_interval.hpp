// SPDX-License-Identifier: Apache-2.0
// A path as intervals between knots, and a motion at these knots.
#pragma once

#include <vector>

#include "ref/feed/places/place_limit.hpp"

namespace curvecore::ref {

/// A limit at a place x mm after the interval's start: of acceleration, of jerk or of both.
struct LimitedPlace {
    double x = 0;
    bool acceleration = true;
    bool jerk = true;
    PlaceLimit limit;
    double mean = 1;  // ratio of the speed in the interval's middle to that at the place
};

/// The interval from one knot to the next.
struct PathInterval {
    double length = 0;          // mm
    double start_velocity = 0;  // mm/s, at its start
    double velocity = 0;        // mm/s, in its middle
    double end_velocity = 0;    // mm/s, at its end
    double speed = 1;           // share of these velocities
    double share = 1;           // share of the limits below
    std::vector<LimitedPlace> places;
};

/// q = v^2, mm^2/s^2, and the acceleration, mm/s^2.
struct KnotMotion {
    double q = 0;
    double a = 0;
};

}  // namespace curvecore::ref
