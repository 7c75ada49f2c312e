// SPDX-License-Identifier: Apache-2.0
// A program's splines as what simpler machines draw: tangent arcs, or chords.
#pragma once

#include <cstddef>

#include "ref/moves/move.hpp"

namespace curvecore::ref {

enum class SplineForm { kSpline, kArcs, kChords };

struct Replaced {
    std::size_t splines = 0;
    std::size_t moves = 0;  // that they became
    double deviation = 0;   // mm from the cubics, a bound: fit_arcs; of chords the tolerance
};

/// Puts arcs of any plane and lines, or lines alone, in the place of every cubic. Ends stay where
/// they are; auxiliary axes go on linearly in path length; stops and dwells stay behind the last
/// piece. A cubic that is drawn within a tolerance of its own takes what is left of that; with a
/// `tolerance` of 0, in mm, the others stay.
Replaced replace_splines(Program& program, SplineForm form, double tolerance);

}  // namespace curvecore::ref
