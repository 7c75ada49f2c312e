// SPDX-License-Identifier: Apache-2.0
// A motion with the same ends, made the fastest that the machine's limits allow on the true path.
#pragma once

#include <functional>
#include <vector>

#include "ref/feed/optimum/run_knots.hpp"
#include "ref/feed/places/path_places.hpp"

namespace curvecore::ref {

/// Load of a motion at a place of the run, as shares of its limits.
struct RunLoad {
    double s = 0;      // mm
    double load = 0;   // acceleration and jerk
    double speed = 0;  // velocity
};
/// Returns the places where the words of a motion exceed their limits; may move ends of its phases
/// to where they do not.
using WordLoads = std::function<std::vector<RunLoad>(std::vector<Phase>&)>;

/// Makes the fastest motion from that of `phases`: lays knots on it, runs TimeOptimum on them in
/// windows, and returns phases of constant jerk; `phases` if these are not slower, or if the words
/// of the other cannot be mended. It takes the shares of the machine's limits that
/// ref/limits/limits.hpp names.
std::vector<Phase> optimal_run(const std::vector<Phase>& phases, const std::vector<RunMove>& moves,
                               const Geometry& geometry, const Machine& machine, PathPlaces& places,
                               const WordLoads& word_loads);

}  // namespace curvecore::ref
