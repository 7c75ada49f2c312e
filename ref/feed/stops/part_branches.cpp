// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stops/part_branches.hpp"

#include "ref/feed/stops/planned_branches.hpp"
#include "ref/feed/stops/stop_branch.hpp"

namespace curvecore::ref {

PartMoves::PartMoves(const std::vector<PlannedMove>& planned, std::size_t first, std::size_t end,
                     const Program& whole, std::size_t before)
    : at_rest(end == planned.size()) {
    const auto place = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    const std::size_t from = planned[first].move;
    geometry.moves.assign(planned.begin() + place(first), planned.begin() + place(end));
    for (PlannedMove& move : geometry.moves) move.move -= from;
    program.file = whole.file;
    program.aux_axes = whole.aux_axes;
    program.moves.assign(whole.moves.begin() + place(from - before),
                         whole.moves.begin() + place(planned[end - 1].move + 1 - before));
}

void PlannedPart::find_branches(const Machine& machine, const PlanOptions& options) {
    if (!moves) return;
    set_branches(moves->program, machine, moves->geometry, options, plan);
    if (moves->at_rest) return;
    double left = ticks_of(plan.pieces);
    std::size_t piece = 0;
    std::size_t kept = 0;
    for (const PlannedBranch& branch : plan.branches) {
        for (; piece < branch.piece; ++piece) left -= plan.pieces[piece].ticks;
        if (left < kStopLead + 1 + ticks_passed(branch.steps)) break;
        ++kept;
    }
    plan.branches.resize(kept);
    if (kept > 0) plan.branches.back().wait = kNoWait;
}

}  // namespace curvecore::ref
