// SPDX-License-Identifier: Apache-2.0
// A motion along a path in real numbers: phases of constant jerk, one after the other.
#pragma once

#include <vector>

namespace curvecore::ref {

/// Constant jerk for a time (mm, s); starts at path length s.
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

constexpr double kAtRest = 1e-6;  // mm/s: what is slower is a rest that was rounded

double duration(const std::vector<Phase>& phases);

/// At the end of a motion, 0 at rest.
double end_speed(const std::vector<Phase>& phases);

/// Time within a phase, not before `from`, at which the path is s.
double time_at(const Phase& phase, double from, double s);

constexpr long double kEnd = 1e30L;  // mm: a place beyond every motion

/// The motion between two places, from s = 0 on.
std::vector<Phase> part_of(const std::vector<Phase>& phases, long double from, long double to);

/// `part` from place s on.
void append_motion(std::vector<Phase>& phases, const std::vector<Phase>& part, long double s);

}  // namespace curvecore::ref
