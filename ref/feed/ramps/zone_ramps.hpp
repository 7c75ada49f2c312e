// SPDX-License-Identifier: Apache-2.0
// Look-ahead: speed limits along a path become a jerk-limited motion in real numbers.
#pragma once

#include "ref/feed/ramps/phase.hpp"

namespace curvecore::ref {

/// A stretch of path with one set of limits (mm, s); a joint is a zone without length.
struct Zone {
    double length = 0;
    double velocity = 0;
    double acceleration = 0;  // along the path
    double jerk = 0;
};

/// Makes a motion from zones: over all of them, from rest to rest.
///
/// Acceleration is zero where a speed limit is met and wherever two ramps join; between such places
/// the motion is at least as fast as the fastest one with the least acceleration and jerk of the
/// zones that it crosses (ref/feed/ramps/ramp_pair.hpp). A ramp runs over any number of zones whose
/// limits it does not touch, so a chain of short moves costs nothing.
std::vector<Phase> ramps_over(const std::vector<Zone>& zones);

}  // namespace curvecore::ref
