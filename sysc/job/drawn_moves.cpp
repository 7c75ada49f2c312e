// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/drawn_moves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ref/geometry/segment_batches.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/segment/spline_cut.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {
namespace {

/// Share of G64's tolerance for smoothing, where arcs take the rest.
constexpr double kShareBesideArcs = 0.5;

}  // namespace

bool draws_splines(const Options& options) {
    CoreParameters core = options.core;
    if (options.splines_set) return core.splines != 0;
    core.splines = 1;
    return ref::why_not_built(core).empty();
}

ref::SplineForm form_of(const Options& options, std::optional<ref::SplineForm> form) {
    if (form) return *form;
    const bool arcs = options.arc_tolerance || !draws_splines(options);
    return arcs ? ref::SplineForm::kArcs : ref::SplineForm::kSpline;
}

ref::ProgramStream open_program(const Options& options) {
    if (options.program) return ref::ProgramStream(*options.program);
    return ref::ProgramStream(options.file, options.points, options.open_program, options.gcode);
}

ref::PlanOptions segment_options(const Options& options) {
    ref::PlanOptions plan = options.plan_options();
    plan.aux_axes = ref::kAuxAxes;
    if (draws_splines(options)) plan.format.splines = 1;
    return plan;
}

DrawnMoves::DrawnMoves(const Options& options, const ref::Machine& machine,
                       std::optional<ref::SplineForm> form)
    : program_(open_program(options)),
      machine_(machine.of_tool()),
      plan_options_(segment_options(options)),
      form_(form_of(options, form)),
      tolerance_(options.arc_tolerance.value_or(0)),
      from_(options.from_mm),
      stretch_(machine.joint_stretch()) {
    plan_options_.advise = false;
    plan_options_.cuts = std::make_shared<ref::KnownCuts>();
    if (!ref::is_trivial(machine.kinematics)) {
        const bool series = options.core.table && options.core.table->name == "series";
        if (!series) refuse_joints(machine, "this core");
        joints_.emplace([this](ref::Move& move) { return give_tool(move); }, program_.file(),
                        machine, options.plan_options());
    }
    if (options.exact_path) return;
    const bool arcs = form_of(options) == ref::SplineForm::kArcs;
    smooth_.emplace([this](ref::Move& move) { return program_.next(move); }, machine_,
                    arcs ? kShareBesideArcs : 1,
                    [this](const std::deque<ref::Move>& moves) { return carried(moves); });
}

/// Checks travel and segments.
bool DrawnMoves::carried(const std::deque<ref::Move>& moves) const {
    ref::SegmentBatches batches({}, machine_, plan_options_);
    try {
        for (const ref::Move& move : moves) {
            ref::Program drawn;
            drawn.moves.push_back(move);
            ref::replace_splines(drawn, form_, tolerance_);
            for (const ref::Move& one : drawn.moves) batches.add(one);
        }
        batches.look();
    } catch (const ref::InputError&) {
        return false;
    }
    return true;
}

bool DrawnMoves::next(ref::Move& move) {
    while (joints_ ? joints_->next(move) : give(move)) {
        const double before = (from_ - left_out_) * stretch_;
        if (before > 0) {
            const double length = move.length();
            left_out_ += std::min(length, before) / stretch_;
            if (length <= before) continue;
            move = ref::part_of(move, before, length);
        }
        if (!joints_) ref::look_at(move, off_);
        given_ = true;
        return true;
    }
    if (from_ > 0 && !given_) {
        throw ref::InputError(
            program_.file(), 0,
            fmt::format("the path is {:.6f} mm long: nothing is left from {:.6f} mm on", left_out_,
                        from_));
    }
    return false;
}

/// Gives the next move of a tool whose joints are drawn.
bool DrawnMoves::give_tool(ref::Move& move) {
    if (!give(move)) return false;
    ref::look_at(move, off_);
    return true;
}

bool DrawnMoves::give(ref::Move& move) {
    if (ready_.empty()) {
        if (!(smooth_ ? smooth_->next(move) : program_.next(move))) return false;
        if (form_ == ref::SplineForm::kSpline || move.kind != ref::Move::Kind::kCubic) {
            return true;
        }
        replace(move);
    }
    move = ready_.front();
    ready_.pop_front();
    return true;
}

void DrawnMoves::replace(const ref::Move& spline) {
    ref::Program one;
    one.moves.push_back(spline);
    const ref::Replaced replaced = ref::replace_splines(one, form_, tolerance_);
    replaced_.splines += replaced.splines;
    replaced_.moves += replaced.moves;
    replaced_.deviation = std::max(replaced_.deviation, replaced.deviation);
    ready_.assign(one.moves.begin(), one.moves.end());
}

std::optional<ref::Smoothed> DrawnMoves::smoothed() const {
    if (!smooth_) return {};
    ref::Smoothed smoothed = smooth_->report();
    smoothed.tolerance = off_.tolerance;
    smoothed.deviation = off_.deviation;
    smoothed.share = off_.share;
    smoothed.line = off_.line;
    return smoothed;
}

}  // namespace curvecore::sysc
