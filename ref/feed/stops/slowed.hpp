// SPDX-License-Identifier: Apache-2.0
// Limits of a move's speed by the queues of a core.
#pragma once

#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {

/// Limits of a planned move by the core's queues: a speed, mm/s, and the least time of a ramp to
/// it, s.
struct Slowed {
    double speed = kUnlimitedSpeed;
    double ramp = 0;
};

}  // namespace curvecore::ref
