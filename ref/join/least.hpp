// SPDX-License-Identifier: Apache-2.0
// Control points that give an idle move the least curvature or jerk.
#pragma once

#include "ref/join/idle_move.hpp"

namespace curvecore::ref {

enum class Least { kCurvature, kJerk };
constexpr std::array<std::string_view, 2> kLeastNames = {"curvature", "jerk"};

/// The move with its control points where
///
///     integral of |r''|^2 dt   or   of |r'''|^2 dt
///
/// is least among those whose tangent and curvature at both ends are the joints'. At fixed t every
/// fit is linear in its control points, so this is one least-squares problem with linear
/// constraints. A c2 spline spends two points on the constraints ([Petrakov]'s program has three,
/// moved by hand); a quintic meets them anyway.
/// @throws std::invalid_argument: too few control points to meet the joints
IdleMove with_least(const IdleMove& move, Least least);

}  // namespace curvecore::ref
