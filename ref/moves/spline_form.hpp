// SPDX-License-Identifier: Apache-2.0
// A program's splines as tangent arcs, or chords, for simpler machines.
#pragma once

#include <cstddef>

#include "ref/moves/move.hpp"

namespace curvecore::ref {

enum class SplineForm { kSpline, kArcs, kChords };

struct Replaced {
    std::size_t splines = 0;
    std::size_t moves = 0;  // moves that they became
    double deviation = 0;   // mm from the cubics, a bound: fit_arcs; for chords the tolerance
};

/// Replaces every cubic by arcs of any plane and lines, or by lines alone. Ends stay in place;
/// auxiliary axes are linear in path length; stops and dwells stay behind the last piece. A cubic
/// with a tolerance of its own takes the rest of it; with `tolerance` 0, in mm, the others stay.
Replaced replace_splines(Program& program, SplineForm form, double tolerance);

}  // namespace curvecore::ref
