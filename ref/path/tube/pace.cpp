// SPDX-License-Identifier: Apache-2.0
#include "ref/path/tube/pace.hpp"

#include <cmath>

#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

PaceLimit limit(double share, double path, const Machine& machine, double AxisLimits::*of) {
    const auto axis = [&](std::size_t i) { return share * (machine.axis[i].*of); };
    return {share * path, {axis(0), axis(1), axis(2)}};
}

}  // namespace

Pace::Pace(const Machine& machine)
    : velocity(limit(1, machine.velocity, machine, &AxisLimits::velocity)),
      acceleration(
          limit(kAccelerationShare, machine.acceleration, machine, &AxisLimits::acceleration)),
      jerk(limit(kJerkShare, machine.jerk, machine, &AxisLimits::jerk)),
      joint_time(machine.joint_time) {}

double Pace::at(const Vec3& direction, const Vec3& bend, const Vec3& swerve) const {
    double v = velocity.along(direction);
    const double square = bend.squaredNorm();
    if (square > 0) {
        v = std::min(
            {v, std::sqrt(1 / acceleration.load(bend)), std::cbrt(jerk.along(direction) / square)});
    }
    return swerve.squaredNorm() > 0 ? std::min(v, std::cbrt(1 / jerk.load(swerve))) : v;
}

void Pace::sweep(std::vector<PacePlace>& places) const {
    const auto join = [&](const PacePlace& from, PacePlace& to) {
        const double gain = std::min(acceleration.along(from.direction),
                                     std::sqrt(jerk.along(from.direction) * from.speed));
        const double most = from.speed * from.speed + 2 * gain * std::abs(to.s - from.s);
        to.speed = std::min(to.speed, std::sqrt(most));
    };
    for (std::size_t i = 1; i < places.size(); ++i) join(places[i - 1], places[i]);
    for (std::size_t i = places.size(); i-- > 1;) join(places[i], places[i - 1]);
}

}  // namespace curvecore::ref
