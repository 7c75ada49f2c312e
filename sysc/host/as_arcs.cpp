// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/as_arcs.hpp"

#include "ref/feed/planned_branches.hpp"
#include "ref/feed/planner.hpp"
#include "ref/format/path_words.hpp"
#include "ref/program/input_error.hpp"
#include "sysc/host/options.hpp"

namespace curvecore::sysc {

std::size_t words_of(const ref::Plan& plan) {
    return ref::segment_bus_words(plan.aux_axes) * plan.segments.size() + ref::profile_words(plan);
}

namespace {

FormCost cost(const char* form, const ref::Program& program, const ref::Plan& plan) {
    return {form, program.moves.size(), plan.segments.size(), words_of(plan), plan.duration_s};
}

}  // namespace

std::optional<FormCost> exact_cost(const Options& options, const ref::Machine& machine,
                                   const ref::Program& programmed) {
    try {
        const ref::Plan plan = ref::make_plan(programmed, machine, options.plan_options());
        return cost("exact path", programmed, plan);
    } catch (const ref::InputError&) {
        return std::nullopt;
    }
}

void compare_forms(AsArcs& as_arcs, const Options& options, const ref::Machine& machine,
                   const ref::Program& arcs, const ref::Plan& plan) {
    as_arcs.costs = {cost("arcs", arcs, plan)};
    ref::Program chords = as_arcs.splines;
    ref::replace_splines(chords, ref::SplineForm::kChords, options.arc_tolerance.value_or(0));
    Options with_splines = options;
    with_splines.core.splines = 1;
    if (ref::legal(with_splines.core)) {
        const ref::Plan splines =
            ref::make_plan(as_arcs.splines, machine, with_splines.plan_options());
        as_arcs.costs.push_back(cost("splines", as_arcs.splines, splines));
    }
    as_arcs.costs.push_back(
        cost("chords", chords, ref::make_plan(chords, machine, options.plan_options())));
}

}  // namespace curvecore::sysc
