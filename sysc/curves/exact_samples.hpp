// SPDX-License-Identifier: Apache-2.0
// Places on a program's path where configurations are compared, with the exact curve there:
// evaluated once for all configurations, from the moves, however a plan cuts them.
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
/// Error: that of ref::exact_position, below 1e-6 units; for a cubic 1e-13 of its length.
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

/// Chooses about `count` places at random distances: half of them spread evenly over the path, the
/// other half evenly over the moves, so that short moves count. `keep_going(done)` is called now
/// and then.
/// @throws what keep_going throws
ExactSamples exact_samples(const ref::Program& program, double unit_mm, std::int64_t count,
                           const std::function<void(std::int64_t)>& keep_going);

}  // namespace curvecore::sysc
