// SPDX-License-Identifier: Apache-2.0
// Places on lines and arcs, and their parts.
#pragma once

#include "ref/program/move.hpp"

namespace curvecore::ref {

/// r and its derivatives by path length.
struct MovePlace {
    Vec3 position;
    Vec3 slope;
    Vec3 bend;
};

/// Of a line or an arc, by the part of its length from 0 to 1.
MovePlace place_on(const Move& move, double part);

/// What lies between two parts of its length; no stop behind it unless it has the move's end.
/// Auxiliary axes rest.
Move part_of(const Move& move, double from, double to);

}  // namespace curvecore::ref
