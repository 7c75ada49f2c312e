// SPDX-License-Identifier: Apache-2.0
// A corner of two moves, rounded by one cubic.
#pragma once

#include <optional>

#include "ref/curve/cubic.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// A cubic that replaces the path within `reach` of a joint, with the tangents and the curvatures
/// that the moves have there.
///
/// Two lines give [v - d t1, v, v, v + d t2], both inner points on the joint v: the path of two
/// overlapping ramps of constant jerk, whose best speed dips in the middle but never reaches 0.
/// With p = -d t1 and r = d t2, u <= 1/2 is paired with v + p ((1 - u)^3 - u^3): they differ by u^3
/// (p + r), so each path keeps |p + r| / 8 = d sin(turn / 2) / 4 from the other.
///
/// An arc in the same plane moves them: the inner points go along the tangents until the curvatures
/// fit. The same pairs, by path length, are compared at many places; the error between them is at
/// most h^2 / 8 of the difference's second derivative.
struct Corner {
    double reach = 0;  // d, mm of either move
    Bezier points{};
    double deviation = 0;  // mm, a bound
};

/// Reach, mm, at which the deviation for two lines is the tolerance; the turn is in rad.
double corner_reach(double turn, double tolerance);

/// Rounds lines and arcs that meet at an angle; none if the moves lie in no plane, or bend too
/// much.
std::optional<Corner> corner_of(const Move& before, const Move& after, double reach);

/// Returns the longest corner, up to `most`, that keeps the tolerance.
std::optional<Corner> longest_corner(const Move& before, const Move& after, double tolerance,
                                     double most);

}  // namespace curvecore::ref
