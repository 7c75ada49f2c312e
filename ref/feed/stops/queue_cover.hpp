// SPDX-License-Identifier: Apache-2.0
// The rule that the words in a core's queues outlast a stop: else a host that stalls would end the
// motion with a jerk, so the core refuses to begin (rtl/queue/underrun_guard.sv).
#pragma once

#include <vector>

#include "ref/feed/stops/slowed.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// Lateness of a host, s: it finds a queue less than full, and the core has not held.
constexpr double kHostLate = 10e-3;

/// Shares of a plan's time in which three quarters of a queue do not outlast a stop and kHostLate.
struct Uncovered {
    double segments = 0;
    double pieces = 0;  // with their branches

    bool any() const { return segments > 0 || pieces > 0; }
};
Uncovered uncovered(const Geometry& geometry, const PlanOptions& options, const Plan& plan);

/// Drops the branches with which three quarters of a queue do not last so long.
void drop_uncovered(const PlanOptions& options, Plan& plan);

/// Slows the planned moves except the first `given` if three quarters of a queue (the host refills
/// the rest) do not last for a stop of the plan and kHostLate, so that they do.
///
/// The pieces of a ramp are the shorter the lower the speed that it leads to, so a lower speed
/// alone may never suffice: in the even rounds of planning moves get a lower speed, in the odd
/// ones, if pieces do not last, longer ramps, at first as long as pieces have to be, then twice as
/// long each time. Round 0 takes the mean speed of the motion there, since ramps cost words.
/// @returns the number of planned moves that it slowed
std::size_t slow_to_cover(const Geometry& geometry, const PlanOptions& options, const Plan& plan,
                          std::size_t given, int round, std::vector<Slowed>& moves);

/// Words of the profile that count, and those per tick that the queue carries for a stop
/// of the plan.
double covered_words(const PlanOptions& options);
double covered_words(const PlanOptions& options, const Plan& plan);

}  // namespace curvecore::ref
