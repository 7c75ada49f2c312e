// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/planner.hpp"

#include <algorithm>
#include <iterator>

#include "ref/feed/plan_stream.hpp"

namespace curvecore::ref {
namespace {

double fastest_feed(const Program& program) {
    double fastest = 0;
    for (const Move& move : program.moves) fastest = std::max(fastest, fastest_motion(move));
    return fastest;
}

}  // namespace

Plan make_plan(const Program& program, const Machine& machine, const PlanOptions& options) {
    PlanStream stream(source_of(program), {program.file, program.aux_axes, fastest_feed(program)},
                      machine, options);
    Plan plan = *stream.next();
    while (std::optional<Plan> part = stream.next()) {
        plan.duration_s += part->duration_s;
        plan.slowed_moves += part->slowed_moves;
        if (plan.slowed_line == 0) plan.slowed_line = part->slowed_line;
        plan.core_slowed.add(part->core_slowed);
        for (PlannedBranch& branch : part->branches) {
            branch.piece += plan.pieces.size();
            plan.branches.push_back(std::move(branch));
        }
        std::move(part->segments.begin(), part->segments.end(), std::back_inserter(plan.segments));
        std::move(part->pieces.begin(), part->pieces.end(), std::back_inserter(plan.pieces));
    }
    return plan;
}

}  // namespace curvecore::ref
