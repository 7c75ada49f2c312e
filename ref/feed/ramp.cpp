// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/ramp.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace curvecore::ref {

double peak_speed(double v0, double v1, double length, const RampLimits& up, const RampLimits& down,
                  double cap) {
    const auto rest = [&](double peak) {
        return length - Ramp(v0, peak, up.acceleration, up.jerk).length() -
               Ramp(peak, v1, down.acceleration, down.jerk).length();
    };
    const double rest_at_cap = rest(cap);
    if (rest_at_cap >= 0) return cap;
    const double low = std::max(v0, v1);
    const double rest_at_low = rest(low);
    if (rest_at_low <= 0) return low;
    std::uintmax_t rounds = 60;
    // It falls from the bracket's first end, which fits, to its second.
    return boost::math::tools::toms748_solve(rest, low, cap, rest_at_low, rest_at_cap,
                                             boost::math::tools::eps_tolerance<double>(), rounds)
        .first;
}

}  // namespace curvecore::ref
