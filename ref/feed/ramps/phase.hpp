// SPDX-License-Identifier: Apache-2.0
// A motion along a path in real numbers: phases of constant jerk in a row.
#pragma once

#include <vector>

namespace curvecore::ref {

/// A phase of constant jerk (mm, s) that starts at path length s.
struct Phase {
    double duration = 0;
    long double s = 0;
    double v = 0;
    double a = 0;
    double j = 0;

    /// Path length t seconds after its start, mm.
    long double place(double t) const { return s + ((j / 6 * t + a / 2) * t + v) * t; }
    double speed(double t) const { return (j / 2 * t + a) * t + v; }
    double acceleration(double t) const { return a + j * t; }
    /// The same phase in `factor` times its duration.
    Phase slower(double factor) const {
        const double square = factor * factor;
        return {duration * factor, s, v / factor, a / square, j / (square * factor)};
    }
};

/// The cubic s(t) with path and speed at both ends.
Phase phase_between(long double s, double length, double v0, double v1, double duration);

constexpr double kAtRest = 1e-6;  // mm/s, below this a rest that was rounded

double duration(const std::vector<Phase>& phases);

/// Speed at the end of a motion, mm/s; 0 at rest.
double end_speed(const std::vector<Phase>& phases);

/// Time within a phase, s, not before `from`, at which the path is s.
double time_at(const Phase& phase, double from, double s);

constexpr long double kEnd = 1e30L;  // mm: a place beyond every motion

/// The motion between two places, with s from 0 on.
std::vector<Phase> part_of(const std::vector<Phase>& phases, long double from, long double to);

/// Appends `part` from place s on.
void append_motion(std::vector<Phase>& phases, const std::vector<Phase>& part, long double s);

}  // namespace curvecore::ref
