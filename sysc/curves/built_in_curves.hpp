// SPDX-License-Identifier: Apache-2.0
// Built-in curves of `curvecore compare`, used when no part is given: seeded curves of every size.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::sysc {

constexpr std::array<std::string_view, 4> kCurveSets{"all", "arcs", "splines", "papers"};

enum class CurveSet { kAll, kArcs, kSplines, kPapers };

/// Makes moves that do not join, mm: for ref::make_geometry, not for a feed profile.
///   arcs     R = 10 um, 100 um, .. 1 m in any plane; helices; lines
///   splines  random cubics of 20 um .. 1 m; hairpins of 3 um, 100 um, 1 mm; S bends, inflexions,
///            near cusps
///   papers   the curves that the papers measure their schemes on (ref/series/spline_tables.hpp)
ref::Program built_in_curves(CurveSet set);

/// Name of a move of CurveSet::kPapers.
std::string paper_curve_name(std::size_t move);

/// A machine whose travel is that of the position words.
ref::Machine unlimited_machine();

}  // namespace curvecore::sysc
