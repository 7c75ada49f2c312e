// SPDX-License-Identifier: Apache-2.0
// Limits of a motion on an interval of a path, and its distance from them.
#pragma once

#include <algorithm>
#include <vector>

#include "ref/feed/optimum/speed_spline.hpp"

namespace curvecore::ref {

/// Calls velocity(x, v), acceleration(x, limit, most) and jerk(x, limit, mean, most) for every
/// place of interval k, x mm after that of SpeedSpline::motion(k).
template <class Velocity, class Acceleration, class Jerk>
void each_limit_at(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k,
                   Velocity velocity, Acceleration acceleration, Jerk jerk) {
    const PathInterval& on = path[k];
    const bool rests = spline.rests(k);
    if (k + 1 < path.size()) {
        velocity(rests ? 0 : on.length, std::min(on.speed * on.end_velocity,
                                                 path[k + 1].speed * path[k + 1].start_velocity));
    }
    if (!rests) velocity(on.length / 2, on.speed * on.velocity);
    for (const LimitedPlace& place : on.places) {
        const double x = rests ? 0 : place.x;
        const PlaceLimit& limit = place.limit;
        if (place.acceleration) acceleration(x, limit, on.share * limit.acceleration);
        if (place.jerk) jerk(x, limit, place.mean, on.share * limit.jerk);
    }
}

/// Factor for q in interval k at which every limit is kept with this share of it.
double slower(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k,
              double share);

/// Largest share of the whole limits of acceleration and jerk that interval k takes.
double load(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k);

/// Largest share of its velocities that interval k takes.
double speed_load(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k);

/// Sets LimitedPlace::mean of interval k, unless that would violate a limit.
void set_means(std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k);

}  // namespace curvecore::ref
