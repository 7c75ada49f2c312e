// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/ramps/ramp.hpp"

namespace curvecore::ref {
namespace {

constexpr double kExact = 1e-14;  // share of the speed
constexpr int kRounds = 60;

/// Length of a ramp from v to the speed p above it, and its derivative by p.
struct Rise {
    double length, slope;

    Rise(double v, double p, const RampLimits& limits) {
        const double change = p - v;
        const double full = limits.acceleration / limits.jerk;
        const bool flat = change > limits.acceleration * full;
        const double root = flat ? 0 : std::sqrt(change / limits.jerk);
        const double time = flat ? change / limits.acceleration + full : 2 * root;
        const double time_slope = flat ? 1 / limits.acceleration : 1 / (limits.jerk * root);
        length = (v + p) / 2 * time;
        slope = time / 2 + (v + p) / 2 * time_slope;
    }
};

}  // namespace

/// Finds the peak by Newton's method in a bracket whose low end fits.
double peak_speed(double v0, double v1, double length, const RampLimits& up, const RampLimits& down,
                  double cap) {
    const auto rest = [&](double peak) {
        return length - Ramp(v0, peak, up.acceleration, up.jerk).length() -
               Ramp(peak, v1, down.acceleration, down.jerk).length();
    };
    const double rest_at_cap = rest(cap);
    if (rest_at_cap >= 0) return cap;
    double low = std::max(v0, v1);
    const double rest_at_low = rest(low);
    if (rest_at_low <= 0) return low;
    double high = cap;
    double peak = low + (high - low) * rest_at_low / (rest_at_low - rest_at_cap);
    for (int round = 0; round < kRounds && high - low > kExact * high; ++round) {
        const Rise rise(v0, peak, up);
        const Rise fall(v1, peak, down);
        const double left = length - rise.length - fall.length;
        (left < 0 ? high : low) = peak;
        const double more = left / (rise.slope + fall.slope);
        // A little less than where it is met, so that this end of the bracket moves too.
        const double next = peak + more - kExact * peak;
        peak = next > low && next < high ? next : low + (high - low) / 2;
        if (left >= 0 && std::abs(more) <= 4 * kExact * peak) break;
    }
    return low;
}

}  // namespace curvecore::ref
