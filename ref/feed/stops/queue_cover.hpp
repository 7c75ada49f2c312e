// SPDX-License-Identifier: Apache-2.0
// What waits in a core's queues must outlast a stop: else a host that stalls would end the motion
// with a jerk, so the core refuses to begin (rtl/queue/underrun_guard.sv).
#pragma once

#include <vector>

#include "ref/feed/stops/slowed.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// So long a host may be late, s: it finds a queue less than full, and the core has not held.
constexpr double kHostLate = 10e-3;

/// Where three quarters of a queue, the rest is the host's to refill, do not last for a stop of
/// the plan and kHostLate: slows the planned moves but the first `given` so that they would.
///
/// A ramp's pieces are the shorter the lower the speed is that it leads to, so a lower speed alone
/// may never do: in the even rounds of planning moves get a lower speed, in the odd ones, if it is
/// pieces that do not last, longer ramps, from as long as pieces have to be, twice as long each
/// time. In round 0 the speed is the mean that the motion has there, since ramps cost words.
/// @returns the number of planned moves that it slowed
std::size_t slow_to_cover(const Geometry& geometry, const PlanOptions& options, const Plan& plan,
                          std::size_t given, int round, std::vector<Slowed>& moves);

/// Words of the profile that the queue carries in a tick for as long as a stop of the plan takes.
double covered_words(const PlanOptions& options, const Plan& plan);

}  // namespace curvecore::ref
