// SPDX-License-Identifier: Apache-2.0
// Loads of pieces, with the values of their words, on the machine along the true path.
#pragma once

#include <functional>

#include "ref/feed/pieces/piece_walk.hpp"
#include "ref/feed/places/path_places.hpp"
#include "ref/limits/limits.hpp"

namespace curvecore::ref {

/// Share of a stretch: at its very ends a curve may stand still.
constexpr double kWithinStretch = 1e-6;

/// Returns true if a curve all but stands still s mm from a move's start. The loads of a motion
/// from rest vanish, but rounded words leave a speed where the curvature is infinite.
bool near_standstill(const PlannedMove& move, double s, double quantum);

/// Calls visit(place, motion) at places of one stretch, except those near a standstill.
/// @param planned index of the stretch's move for `places`
/// @param plan length unit and tick of the pieces
void each_place(const PieceStretch& stretch, std::size_t planned, const Plan& plan,
                const PieceGrid& grid, PathPlaces& places,
                const std::function<void(const PathPlace&, const PieceMotion&)>& visit);

/// Raises `worst` to the ratios to the limits inside one stretch; one that reaches into a
/// neighbouring move counts with its speed alone.
void keep_loads(const PieceStretch& stretch, std::size_t planned, const Plan& plan,
                const PieceGrid& grid, const Machine& machine, PathPlaces& places,
                LimitRatios& worst);

}  // namespace curvecore::ref
