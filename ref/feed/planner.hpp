// SPDX-License-Identifier: Apache-2.0
// The planner: moves become what a core is loaded with. Only here geometry meets feed.
#pragma once

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"
#include "ref/plan/segment.hpp"
#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// Makes the plan of a whole program from its moves, in windows (ref/feed/plan_stream.hpp).
///
/// Moves follow each other: moves[i].end is moves[i+1].start. A move without length makes no
/// segment; its exact_stop and dwell count. Where a cubic stands still (a cusp, a doubled control
/// point) the machine stops. Where an auxiliary axis runs faster than 1.9 units per
/// unit of X Y Z, the path length of the whole move is stretched: then |dr/ds| =
/// hypot(cos_pitch, |advance|) < 1 and the speed along s is larger than the feed in proportion; a
/// spline's path cannot be stretched.
///
/// @throws InputError with the move's line: beyond the travel or the position words, a segment
///         that the configuration cannot carry (with a width that suffices), an auxiliary axis too
///          fast along a spline, nothing moves.
Plan make_plan(const Program& program, const Machine& machine, const PlanOptions& options);

}  // namespace curvecore::ref
