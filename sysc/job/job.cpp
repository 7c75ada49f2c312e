// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/geometry/segment_batches.hpp"
#include "ref/machine/path_quantum.hpp"
#include "ref/program/program_reader.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/job/made_for.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kWorthAWarning = 0.01;  // share of a plan's time

/// Number of segments of the path with the widest words.
std::size_t fewest_segments(const Job& job) {
    ref::PlanOptions options = job.options.plan_options();
    options.format = widest_words();
    ref::SegmentBatches batches(job.program.file, job.machine, options);
    for (std::size_t i = 0; i < job.plan.moves.size(); ++i) batches.add(job.plan.moves[i]);
    batches.look();
    return batches.segments();
}

}  // namespace

ProfileWriter profile_writer(const Job& job) {
    const Options& options = job.options;
    if (options.outputs == 0) return ProfileWriter(job.digest());
    return {job.digest(), OutputWriter(options.sample_period_s, options.unit_mm)};
}

std::uint16_t Job::digest() const { return made_for(options, machine).digest(); }

const char* Job::core_name() const { return options.core.splines != 0 ? "curve" : "spherical"; }

bool Job::bounded(ref::CurveKind kind) const {
    return options.core.anchor != 0 || kind != ref::CurveKind::kSpline;
}

bool Job::bounded() const {
    return std::all_of(ref::kCurveKinds.begin(), ref::kCurveKinds.end(),
                       [&](ref::CurveKind kind) { return bounded(kind) || plan.count(kind) == 0; });
}

double Job::bound() const {
    double bound = 0;
    for (const ref::CurveKind kind : ref::kCurveKinds) {
        if (bounded(kind)) bound = std::max(bound, plan.bound(kind));
    }
    return bound;
}

bool Job::is_smooth() const {
    return smoothed && (smoothed->deviation > 0 || smoothed->moves != plan.moves.size());
}

double Job::path_mm() const {
    return static_cast<double>(plan.path_length()) * ref::path_quantum_mm(machine, plan.unit_mm);
}

ref::Machine machine_of(const Options& options) {
    ref::Machine machine =
        options.machine.empty() ? ref::Machine() : ref::read_machine(options.machine);
    if (options.for_steps || options.in_system()) {
        for (ref::AxisLimits& axis : machine.axis) axis.rotary = false;
    }
    return machine;
}

void refuse_joints(const ref::Machine& machine, const char* who) {
    if (ref::is_trivial(machine.kinematics)) return;
    throw UsageError(
        fmt::format("--machine: {} has {}, and {} draws no joints: run, plan, words "
                    "and stream do, with the engine that they make",
                    machine.name, ref::name_of(machine.kinematics), who));
}

Job read_job(const Options& options) {
    Job job;
    job.options = options;
    job.machine = machine_of(options);
    DrawnMoves moves(options, job.machine);
    job.program.file = moves.program().file();
    std::optional<int> spline;
    for (ref::Move move; moves.next(move);) {
        raise_feed(move, options);
        if (move.kind == ref::Move::Kind::kCubic && !spline) spline = move.line;
        job.program.moves.push_back(move);
    }
    job.program.aux_axes = moves.program().aux_axes();
    job.program.warnings = moves.program().warnings();
    job.events = moves.program().events();
    job.dialect = moves.program().dialect();
    set_splines(job, spline);
    if (!options.aux_axes_set) job.options.core.aux_axes = job.program.aux_axes;
    return job;
}

Job plan_job(const Options& options) { return JobStream(options).all(); }

void hold_input(Options& options) {
    if (options.file != ref::kStandardInput || options.program) return;
    ref::ProgramStream input(options.file, options.points, options.open_program, options.gcode);
    options.program = std::make_shared<const ref::HeldProgram>(input.held());
}

void raise_feed(ref::Move& move, const Options& options) {
    if (!move.rapid) move.feed *= options.feed_factor();
}

void warn_of_segments(Job& job) {
    constexpr std::size_t kMany = 10;
    const std::size_t segments = job.plan.segments.size();
    if (segments <= kMany * job.plan.moves.size()) return;
    const std::size_t least = fewest_segments(job);
    if (segments <= kMany * least) return;
    const CoreParameters& core = job.options.core;
    job.program.warnings.push_back(fmt::format(
        "{}: warning: {} segments with Order={} CoefBits={} GuardBits={}, {} times the {} of the "
        "widest words",
        job.program.file, segments, core.order, core.coef_bits, core.guard_bits, segments / least,
        least));
}

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

void warn_of_plan(Job& job, bool bounded, double duration_s) {
    if (!bounded) {
        job.program.warnings.push_back(fmt::format(
            "{}: warning: no bound is derived for splines with Anchor=0; they are planned "
            "as with Anchor=1",
            job.program.file));
    }
    if (job.plan.slowed_moves > 0) {
        job.program.warnings.push_back(
            fmt::format("{}:{}: warning: {} short moves are slowed: what fits into the core's "
                        "queues would not outlast a stop at their feed",
                        job.program.file, job.plan.slowed_line, job.plan.slowed_moves));
    }
    const ref::CoreSlowed& slowed = job.plan.core_slowed;
    if (slowed.lost_s > kWorthAWarning * duration_s) {
        job.program.warnings.push_back(fmt::format(
            "{}:{}: warning: {} moves are slower than feed and machine allow, since this core "
            "takes "
            "its time for their steps: here {:.4g} mm/min, which else were up to {:.4g}; a faster "
            "--clock helps",
            job.program.file, slowed.line, slowed.moves, slowed.speed * 60, slowed.asked * 60));
    }
}

}  // namespace curvecore::sysc
