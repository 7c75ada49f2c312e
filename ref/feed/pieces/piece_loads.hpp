// SPDX-License-Identifier: Apache-2.0
// What pieces, as their words have them, ask of the machine on the true path.
#pragma once

#include "ref/feed/pieces/piece_walk.hpp"
#include "ref/feed/places/path_places.hpp"
#include "ref/limits/limits.hpp"

namespace curvecore::ref {

/// Whether s mm from a move's start a curve all but stands still. From rest the loads vanish, but
/// rounded words leave a speed where the curvature has no end.
bool near_standstill(const PlannedMove& move, double s, double quantum);

/// Raises `worst` to the ratios to the limits inside one stretch; one that reaches into a
/// neighbouring move counts with its speed alone.
/// @param planned index of the stretch's move for `places`
/// @param plan length unit and tick of the pieces
void keep_loads(const PieceStretch& stretch, std::size_t planned, const Plan& plan,
                const PieceGrid& grid, const Machine& machine, PathPlaces& places,
                LimitRatios& worst);

}  // namespace curvecore::ref
