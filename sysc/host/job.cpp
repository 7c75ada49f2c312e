// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/program/input_error.hpp"
#include "ref/program/program_reader.hpp"
#include "ref/segment/geometry.hpp"
#include "sysc/host/core_clocks.hpp"
#include "sysc/host/drawn_moves.hpp"
#include "sysc/host/usage_error.hpp"

namespace curvecore::sysc {

std::uint64_t Job::path_length() const {
    const ref::Segment& last = plan.segments.back();
    return last.s_start + last.length;
}

const char* Job::core_name() const { return options.core.splines != 0 ? "curve" : "spherical"; }

bool Job::bounded(const ref::Segment& segment) const {
    return options.core.anchor != 0 || segment.kind != ref::Segment::Kind::kSpline;
}

bool Job::bounded() const {
    return std::all_of(plan.segments.begin(), plan.segments.end(),
                       [this](const ref::Segment& segment) { return bounded(segment); });
}

double Job::bound() const {
    double bound = 0;
    for (const ref::Segment& segment : plan.segments) {
        if (bounded(segment)) bound = std::max(bound, segment.bound);
    }
    return bound;
}

namespace {

std::optional<int> first_spline(const ref::Program& program) {
    for (const ref::Move& move : program.moves) {
        if (move.kind == ref::Move::Kind::kCubic) return move.line;
    }
    return {};
}

/// What is drawn in the program's place. Where arcs draw what G64 makes smooth, they take half of
/// its tolerance.
void make_path(Job& job) {
    const bool arcs = draws_arcs(job.options);
    if (!job.options.exact_path) {
        job.programmed = job.program;
        job.smoothed = ref::smooth_path(job.program, job.machine, arcs ? kShareBesideArcs : 1);
        const bool same = job.program.moves.size() == job.programmed.moves.size();
        if (same && job.smoothed->deviation == 0) job.programmed = {};
    }
    if (!arcs) return;
    AsArcs as_arcs;
    as_arcs.splines = job.program;
    as_arcs.replaced = ref::replace_splines(job.program, ref::SplineForm::kArcs,
                                            job.options.arc_tolerance.value_or(0));
    if (as_arcs.replaced.splines == 0) return;
    if (job.smoothed) ref::look_again(job.program, *job.smoothed);
    job.as_arcs = std::move(as_arcs);
}

/// Narrow words are bought with segments, which the host has to send.
void warn_of_segments(Job& job) {
    constexpr std::size_t kMany = 10;
    const std::size_t segments = job.plan.segments.size();
    if (segments <= kMany * job.program.moves.size()) return;
    ref::PlanOptions options = job.options.plan_options();
    options.format = widest_words();
    const std::size_t least = ref::make_geometry(job.program, job.machine, options).segments.size();
    if (segments <= kMany * least) return;
    const CoreParameters& core = job.options.core;
    job.program.warnings.push_back(fmt::format(
        "{}: warning: {} segments with Order={} CoefBits={} GuardBits={}, {} times the {} of the "
        "widest words",
        job.program.file, segments, core.order, core.coef_bits, core.guard_bits, segments / least,
        least));
}

}  // namespace

Job read_job(const Options& options) {
    return make_job(options, ref::read_program(options.file, options.points, options.open_program));
}

void raise_feed(ref::Move& move, const Options& options) {
    if (!move.rapid) move.feed *= options.feed_factor();
}

Job make_job(const Options& options, ref::Program program) {
    Job job;
    job.options = options;
    job.program = std::move(program);
    if (!options.machine.empty()) job.machine = ref::read_machine(options.machine);
    for (ref::Move& move : job.program.moves) raise_feed(move, options);
    make_path(job);
    set_splines(job, first_spline(job.program));
    if (!options.aux_axes_set) job.options.core.aux_axes = job.program.aux_axes;
    return job;
}

namespace {

void plan_path(Job& job) {
    const bool splines = first_spline(job.program).has_value();
    check_period(job.options.core, splines, job.options.sample_period_s, job.options.clock_hz,
                 job.options.samples_per_tick);
    job.plan = ref::make_plan(job.program, job.machine, job.options.plan_options());
    if (job.plan.segments.empty()) {
        throw ref::InputError(job.program.file, 0, "the program does not move");
    }
}

/// The core or the machine cannot have the smooth path; if they cannot have that of the program
/// either, its errors name its lines.
void plan_as_programmed(Job& job) {
    std::swap(job.program, job.programmed);
    job.programmed = {};
    job.smoothed.reset();
    job.as_arcs.reset();
    if (!job.options.splines_set) job.options.core.splines = 0;
    set_splines(job, first_spline(job.program));
    plan_path(job);
    warn_of_exact_path(job);
}

}  // namespace

void warn_of_exact_path(Job& job) {
    job.program.warnings.push_back(
        fmt::format("{}: warning: drawn as programmed: what G64 allows is beyond this core or the "
                    "machine's travel",
                    job.program.file));
}

void set_splines(Job& job, const std::optional<int>& line) {
    CoreParameters& core = job.options.core;
    if (line && job.options.splines_set && core.splines == 0) {
        throw ref::InputError(job.program.file, *line, "a spline, and the core has Splines=0");
    }
    if (line) core.splines = 1;
    const std::string reason = ref::why_not_built(core);
    if (reason.empty()) return;
    throw ref::InputError(job.program.file, line.value_or(0),
                          (line ? "a spline, and " : "no spline, and ") + reason);
}

void plan_job(Job& job) {
    if (job.programmed.moves.empty()) {
        plan_path(job);
    } else {
        try {
            plan_path(job);
        } catch (const ref::InputError&) {
            plan_as_programmed(job);
        } catch (const UsageError&) {
            plan_as_programmed(job);
        }
    }
    warn_of_segments(job);
    warn_of_plan(job, job.bounded());
    job.limits = ref::limit_report(job.program, job.machine, job.plan);
}

void warn_of_plan(Job& job, bool bounded) {
    if (!bounded) {
        job.program.warnings.push_back(fmt::format(
            "{}: warning: no bound is derived for splines with Anchor=0; they are planned "
            "as with Anchor=1",
            job.program.file));
    }
    if (job.plan.slowed_moves > 0) {
        job.program.warnings.push_back(
            fmt::format("{}: warning: {} short moves are slowed: what fits into the core's queues "
                        "would not outlast a stop at their feed",
                        job.program.file, job.plan.slowed_moves));
    }
}

void plan_others(Job& job) {
    if (!job.programmed.moves.empty()) {
        job.exact = exact_cost(job.options, job.machine, job.programmed);
    }
    if (job.as_arcs) compare_forms(*job.as_arcs, job.options, job.machine, job.program, job.plan);
}

}  // namespace curvecore::sysc
