// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/drawn_moves.hpp"

#include "ref/program/input_error.hpp"
#include "ref/program/spline_form.hpp"
#include "ref/segment/geometry.hpp"

namespace curvecore::sysc {

bool draws_splines(const Options& options) {
    CoreParameters core = options.core;
    if (options.splines_set) return core.splines != 0;
    core.splines = 1;
    return ref::why_not_built(core).empty();
}

bool draws_arcs(const Options& options) { return options.arc_tolerance || !draws_splines(options); }

ref::PlanOptions segment_options(const Options& options) {
    ref::PlanOptions plan = options.plan_options();
    plan.aux_axes = ref::kAuxAxes;
    if (draws_splines(options)) plan.format.splines = 1;
    return plan;
}

DrawnMoves::DrawnMoves(const Options& options, const ref::Machine& machine)
    : program_(options.file, options.points, options.open_program),
      machine_(machine),
      plan_options_(segment_options(options)) {
    plan_options_.advise = false;
    const bool arcs = draws_arcs(options);
    if (arcs) arcs_ = options.arc_tolerance.value_or(0);
    if (options.exact_path) return;
    smooth_.emplace([this](ref::Move& move) { return program_.next(move); }, machine,
                    arcs ? kShareBesideArcs : 1,
                    [this](const std::vector<ref::Move>& moves) { return carried(moves); });
}

/// Travel and segments.
bool DrawnMoves::carried(const std::vector<ref::Move>& moves) const {
    ref::Program drawn;
    drawn.moves = moves;
    try {
        if (arcs_) ref::replace_splines(drawn, ref::SplineForm::kArcs, *arcs_);
        ref::make_geometry(drawn, machine_, plan_options_);
    } catch (const ref::InputError&) {
        return false;
    }
    return true;
}

bool DrawnMoves::next(ref::Move& move) {
    if (ready_.empty()) {
        if (!(smooth_ ? smooth_->next(move) : program_.next(move))) return false;
        if (!arcs_ || move.kind != ref::Move::Kind::kCubic) return true;
        ref::Program one;
        one.moves.push_back(move);
        ref::replace_splines(one, ref::SplineForm::kArcs, *arcs_);
        ready_.assign(one.moves.begin(), one.moves.end());
    }
    move = ready_.front();
    ready_.pop_front();
    return true;
}

}  // namespace curvecore::sysc
