// SPDX-License-Identifier: Apache-2.0
// Look-ahead: from speed limits along a path to a jerk-limited motion in real numbers.
#pragma once

#include <vector>

namespace curvecore::ref {

/// A stretch of path with one set of limits (mm, s); a joint is a zone without length.
struct Zone {
    double length = 0;
    double velocity = 0;
    double acceleration = 0;  // along the path
    double jerk = 0;
};

/// Constant jerk for a time; starts at path length s. The last phase of a run ends at rest.
struct Phase {
    double duration = 0;
    long double s = 0;
    double v = 0;
    double a = 0;
    double j = 0;

    /// After t seconds of it.
    long double place(double t) const { return s + ((j / 6 * t + a / 2) * t + v) * t; }
    double speed(double t) const { return (j / 2 * t + a) * t + v; }
    double acceleration(double t) const { return a + j * t; }
};

inline double duration(const std::vector<Phase>& phases) {
    double time = 0;
    for (const Phase& phase : phases) time += phase.duration;
    return time;
}

/// Motion from rest to rest over all zones.
///
/// Acceleration is zero where a speed limit is met and wherever two ramps join; between such places
/// the motion is at least as fast as the fastest one with the least acceleration and jerk of the
/// zones that it crosses (ref/feed/ramp_pair.hpp). A ramp runs over any number of zones whose
/// limits it does not touch, so a chain of short moves costs nothing.
std::vector<Phase> plan_speed(const std::vector<Zone>& zones);

}  // namespace curvecore::ref
