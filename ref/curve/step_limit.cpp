// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/step_limit.hpp"

#include <cmath>

namespace curvecore::ref {

double step_limit(const Cubic& cubic, double u) {
    const double speed = cubic.speed(u);
    if (speed == 0) {
        return 0;
    }
    const double change = (std::sqrt(2.0) - 1) * speed;
    const double slope = cubic.acceleration(u).norm();
    // The quadratic's positive root in the form that a = 0 or W = 0 leave finite.
    const double d = 2 * change / (slope + std::sqrt(slope * slope + 12 * cubic.a.norm() * change));
    return speed * d;
}

}  // namespace curvecore::ref
