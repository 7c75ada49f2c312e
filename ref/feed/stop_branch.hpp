// SPDX-License-Identifier: Apache-2.0
// The quickest stop on the path that time's rate can make from a place of the profile.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/feed/profile_course.hpp"

namespace curvecore::ref {

/// So many ticks in each of which the rate's slope changes by `change`, 2^-32 per tick, and the
/// rate then moves by its slope.
struct StopStep {
    std::uint32_t ticks = 1;
    std::int32_t change = 0;
};

/// From the rate 1 at `tick` of the profile to exactly 0, the slope 0 again. The first change is
/// not 0; empty: there is no such stop.
struct StopBranch {
    std::uint64_t tick = 0;
    std::vector<StopStep> steps;

    std::uint64_t ticks() const;
};

constexpr std::size_t kMostStopSteps = 512;  // before equal neighbours are one

/// The stop that begins at `tick` or, where the limits leave nothing to subtract, as at full jerk
/// across the path, as soon as they do.
///
/// With the rate r, its slope p <= 0 and the plan's v, a, j the motion has V = r v, alpha = r^2 a +
/// p v, u = r^3 j + 3 r p a + r'' v. Any constant r <= 1 keeps every limit that the plan keeps. So
/// in every step the rate takes the most negative r'' after which p can still come back to 0 within
/// the limits, rolled out along the plan that is known; what is rolled out is a choice of the next
/// step, so there always is one.
///
/// Steps are of 2^n ticks, a small part of the time to full acceleration or from full speed; the
/// last ones are shorter, so that whole words end at 0.
///
/// The course must reach stop_reach() ticks beyond `tick`, or to the program's end.
StopBranch stop_branch(const ProfileCourse& course, std::uint64_t tick);
std::uint64_t stop_reach(const Machine& machine, double tick_s);

/// Share of the machine's limits that a stop takes: what its steps miss of a curve is less.
constexpr double kStopShare = 0.995;

/// A branch every so many ticks of the plan from its start on, where there is one. Memory for the
/// course of one stop.
std::vector<StopBranch> stop_branches(const Program& program, const Machine& machine,
                                      const Geometry& geometry, const Plan& plan,
                                      std::uint64_t every);

}  // namespace curvecore::ref
