// SPDX-License-Identifier: Apache-2.0
// A motion, the same at its ends, made the fastest that the machine's limits allow on the true
// path.
#pragma once

#include <functional>
#include <vector>

#include "ref/feed/optimum/run_knots.hpp"
#include "ref/feed/places/path_places.hpp"

namespace curvecore::ref {

/// What a motion takes at a place of the run, as shares of what it may.
struct RunLoad {
    double s = 0;      // mm
    double load = 0;   // acceleration and jerk
    double speed = 0;  // velocity
};
/// Where the words of a motion take more than they may at most.
using WordLoads = std::function<std::vector<RunLoad>(const std::vector<Phase>&)>;

/// Knots on the motion that `phases` describe, TimeOptimum on them in windows, and the motion found
/// as phases of constant jerk; `phases` where these are not slower, or where the words of the other
/// cannot be mended. It takes the shares of the machine's limits that ref/limits/limits.hpp names.
std::vector<Phase> optimal_run(const std::vector<Phase>& phases, const std::vector<RunMove>& moves,
                               const Geometry& geometry, const Machine& machine, PathPlaces& places,
                               const WordLoads& word_loads);

}  // namespace curvecore::ref
