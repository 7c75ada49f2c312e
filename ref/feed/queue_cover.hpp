// SPDX-License-Identifier: Apache-2.0
// What waits in a core's queues must outlast a stop: else a host that stalls would end the motion
// with a jerk, so the core refuses to begin (rtl/path/underrun_guard.sv).
#pragma once

#include <vector>

#include "ref/segment/geometry.hpp"

namespace curvecore::ref {

/// So long a host may be late, s: it finds a queue less than full, and the core has not held.
constexpr double kHostLate = 10e-3;

/// Where three quarters of a queue, the rest is the host's to refill, do not last for a stop of
/// the plan and kHostLate: lowers `speeds` (mm/s, one per planned move) so that they would; or first, if `evens`,
/// to the mean speed there, since ramps cost words.
/// @returns the number of planned moves that it slowed
std::size_t slow_to_cover(const Geometry& geometry, const PlanOptions& options, const Plan& plan,
                          bool evens, std::vector<double>& speeds);

/// Words of the profile that the queue carries in a tick for as long as a stop of the plan takes.
double covered_words(const PlanOptions& options, const Plan& plan);

}  // namespace curvecore::ref
