// SPDX-License-Identifier: Apache-2.0
// What the queues of a core leave of a move's speed.
#pragma once

namespace curvecore::ref {

/// What the core's queues leave a planned move: a speed, mm/s; and how long a ramp to it lasts at
/// least, s.
struct Slowed {
    double speed = 1e9;
    double ramp = 0;
};

}  // namespace curvecore::ref
