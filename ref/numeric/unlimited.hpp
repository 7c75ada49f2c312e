// SPDX-License-Identifier: Apache-2.0
// Constants that stand for no limit, finite for quantities that are calculated with.
#pragma once

#include <limits>

namespace curvecore::ref {

/// No limit of what is only compared: the least of it and another value is the other.
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// No limit of an acceleration or a jerk, mm/s^2 and mm/s^3: a finite number, since the ratio of
/// both is the time of a ramp.
constexpr double kUnlimitedChange = 1e300;

/// No limit of a speed, mm/s: finite, since it is multiplied by times, which may be 0.
constexpr double kUnlimitedSpeed = 1e9;

/// LinuxCNC's travel of an axis without limits, mm: finite, since the report has it as a number,
/// and the digest of a machine its bits.
constexpr double kUnlimitedTravel = 1e99;

}  // namespace curvecore::ref
