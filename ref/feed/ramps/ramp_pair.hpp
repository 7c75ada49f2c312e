// SPDX-License-Identifier: Apache-2.0
// The fastest way between two settled speeds: up, along and down, within limits that vary.
#pragma once

#include "ref/feed/ramps/ramp.hpp"
#include "ref/feed/ramps/speed_zones.hpp"

namespace curvecore::ref {

/// The gap from s0 to s1 (mm), with speeds v0 and v1 and no acceleration at the ends. With
/// `acceleration`, `jerk` and speeds up to `cap` the motion violates no zone.
struct SpeedGap {
    long double s0, s1;
    double v0, v1;
    double acceleration, jerk;
    double cap;
};

/// Ramps up to `peak` and down from it, with `rest` mm between them.
struct RampPair {
    Ramp up, down;
    double peak;
    double rest;

    double duration() const { return up.duration() + down.duration() + rest / peak; }
};

/// Returns the gap's own motion, or one that takes less time, from a search over accelerations,
/// jerks and peaks. One side at a time gets other limits; they hold where the motion is: a zone
/// must allow the accelerations within it, and its neighbour's may be less.
RampPair best_pair(const Zones& zones, const SpeedGap& gap);

}  // namespace curvecore::ref
