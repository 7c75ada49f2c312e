// SPDX-License-Identifier: Apache-2.0
// The quickest stop on the path that the rate of time can make from a place of the profile.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/feed/pieces/profile_course.hpp"

namespace curvecore::ref {

using StopSteps = std::vector<StopStep>;

std::uint64_t ticks_of(const StopSteps& steps);

/// Steps from the rate 1 at `tick` of the profile to exactly 0, with the slope 0 again. Where the
/// limits leave nothing to subtract, as at full jerk across the path, the first change is 0. Empty:
/// there is no such stop.
///
/// With the rate r, its slope p <= 0 and the plan's v, a, j the motion has V = r v, alpha = r^2 a +
/// p v, u = r^3 j + 3 r p a + r'' v. Any constant r <= 1 keeps every limit that the plan keeps. So
/// in every step the rate takes the most negative r'' after which p can still come back to 0 within
/// the limits, rolled out along the known plan; the rolled-out step is a choice of the next one, so
/// there always is one.
///
/// Steps are of 2^n ticks, a small part of the stop; the last ones are shorter, so that whole words
/// end at 0.
///
/// The course must reach stop_reach() ticks beyond `tick`, or to the program's end.
StopSteps stop_steps(const ProfileCourse& course, std::uint64_t tick);
std::uint64_t stop_reach(const Machine& machine, double tick_s);

/// Share of the machine's limits that a stop takes: its steps miss less than the rest on a curve.
constexpr double kStopShare = 0.995;

}  // namespace curvecore::ref
