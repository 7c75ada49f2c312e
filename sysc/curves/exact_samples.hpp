// SPDX-License-Identifier: Apache-2.0
// Where on a program's path the configurations are compared, and where the exact curve is there:
// evaluated once for all of them, from the moves, whatever a plan cuts them into.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "ref/moves/move.hpp"

namespace curvecore::sysc {

/// | field    | unit   | meaning                                                             |
/// |----------|--------|---------------------------------------------------------------------|
/// | s        | quanta | program-wide path length, ascending; a little off the moves' ends   |
/// | position | units  | exact curve                                                         |
/// | tangent  | 1      | dr/ds over its length; 0 where only auxiliary axes move             |
/// | chord    | units  | from the sample before on the same move; 0 for a move's first one   |
///
/// Error: that of ref::exact_position, below 1e-6 units; of a cubic 1e-13 of its length.
struct ExactSample {
    std::int64_t s = 0;
    double position[3] = {};
    double tangent[3] = {};
    double chord = 0;
};

struct ExactSamples {
    std::vector<ExactSample> samples;
    int aux_axes = 0;
    std::vector<double> aux;  // aux_axes for each sample, units
};

/// About `count` places at random distances: one half spread evenly over the path, the other half
/// evenly over the moves, so that short ones count. `keep_going(done)` is asked now and then.
/// @throws what keep_going throws
ExactSamples exact_samples(const ref::Program& program, double unit_mm, std::int64_t count,
                           const std::function<void(std::int64_t)>& keep_going);

}  // namespace curvecore::sysc
