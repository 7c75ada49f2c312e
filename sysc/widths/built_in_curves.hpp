// SPDX-License-Identifier: Apache-2.0
// What `curvecore compare` draws when it is not given a part: seeded curves of every size.
#pragma once

#include <array>
#include <string_view>

#include "ref/machine/machine.hpp"
#include "ref/program/move.hpp"

namespace curvecore::sysc {

constexpr std::array<std::string_view, 3> kCurveSets{"all", "arcs", "splines"};

enum class CurveSet { kAll, kArcs, kSplines };

/// Moves that do not join, mm: for ref::make_geometry, not for a feed profile.
///   arcs     R = 10 um, 100 um, .. 1 m in any plane; helices; lines
///   splines  random cubics of 20 um .. 1 m; hairpins of 3 um, 100 um, 1 mm; S bends, inflexions,
///            near cusps
ref::Program built_in_curves(CurveSet set);

/// Travels as far as the position words go.
ref::Machine unlimited_machine();

}  // namespace curvecore::sysc
