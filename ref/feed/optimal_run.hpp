// SPDX-License-Identifier: Apache-2.0
// A motion from rest to rest made the fastest that the machine's limits allow on the true path.
#pragma once

#include <vector>

#include "ref/feed/path_places.hpp"
#include "ref/feed/run_knots.hpp"

namespace curvecore::ref {

/// Knots on the motion that `phases` describe, time_optimum() on them, and the motion found as
/// phases of constant jerk, one from knot to knot. It takes the shares
/// of the machine's limits that ref/feed/limits.hpp names.
std::vector<Phase> optimal_run(const std::vector<Phase>& phases, const std::vector<RunMove>& moves,
                               const Geometry& geometry, const Machine& machine,
                               PathPlaces& places);

}  // namespace curvecore::ref
