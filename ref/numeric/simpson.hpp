// SPDX-License-Identifier: Apache-2.0
// Arc length by Simpson's rule with Runge's a-posteriori estimate: [Obukhov] (3), (4), as written.
// It serves comparison: ref/curve/arc_length.hpp does not stop too early.
#pragma once

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

struct SimpsonLength {
    double length = 0;    // z = z_2n + (z_2n - z_n) / 15
    double estimate = 0;  // |(z_2n - z_n) / 15|, estimated error of z_2n
    int intervals = 0;    // 2 n
};

/// Composite Simpson rule for |r'| with n intervals, n even; negative if u1 < u0.
double simpson(const Cubic& cubic, double u0, double u1, int n);

/// Doubles n from `first` until the estimate is below `tolerance` (or n reaches 2^20). The estimate
/// may be wrong: near a tip it is too small, and the stop comes too early.
SimpsonLength simpson_runge(const Cubic& cubic, double u0, double u1, double tolerance,
                            int first = 2);

}  // namespace curvecore::ref
