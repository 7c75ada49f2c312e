// SPDX-License-Identifier: Apache-2.0
// A change of speed with bounded acceleration and jerk, acceleration zero at both ends.
#pragma once

#include <algorithm>
#include <cmath>

namespace curvecore::ref {

/// A seven-phase motion is two of these around a cruise. Units: mm, s.
///
/// Speed changes by `change` = |v1 - v0|: jerk for `jerk_time`, constant acceleration for
/// `flat_time`, jerk back for `jerk_time`. The motion is symmetric about its middle, so its length
/// is the mean speed times its duration.
struct Ramp {
    double low, high;  // speeds at its ends, low <= high
    double jerk;
    double jerk_time = 0;
    double flat_time = 0;

    Ramp(double v0, double v1, double acceleration, double jerk_limit)
        : low(std::min(v0, v1)), high(std::max(v0, v1)), jerk(jerk_limit) {
        const double change = high - low;
        const double full = acceleration / jerk;
        if (change <= acceleration * full) {
            jerk_time = std::sqrt(change / jerk);
        } else {
            jerk_time = full;
            flat_time = change / acceleration - full;
        }
    }

    double duration() const { return 2 * jerk_time + flat_time; }
    double length() const { return 0.5 * (low + high) * duration(); }

    /// Length from the slow end to the place where the speed is v, low <= v <= high.
    double length_to(double v) const {
        const double bend = 0.5 * jerk * jerk_time * jerk_time;  // gained in each jerk phase
        if (v - low <= bend) {
            const double t = std::sqrt(2 * std::max(0.0, v - low) / jerk);
            return (low + jerk * t * t / 6) * t;
        }
        if (high - v <= bend) {
            const double t = std::sqrt(2 * std::max(0.0, high - v) / jerk);
            return length() - (high - jerk * t * t / 6) * t;
        }
        const double first = (low + jerk * jerk_time * jerk_time / 6) * jerk_time;
        return first + 0.5 * (low + bend + v) * (v - low - bend) / (jerk * jerk_time);
    }
};

struct RampLimits {
    double acceleration, jerk;
};

/// Highest speed between v0 and v1, at most cap, for which both ramps, to it and from it, fit into
/// a length; the larger of v0 and v1 if none does.
double peak_speed(double v0, double v1, double length, const RampLimits& up, const RampLimits& down,
                  double cap);

inline double peak_speed(double v0, double v1, double length, double acceleration, double jerk,
                         double cap) {
    return peak_speed(v0, v1, length, {acceleration, jerk}, {acceleration, jerk}, cap);
}

}  // namespace curvecore::ref
