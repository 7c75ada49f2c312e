// SPDX-License-Identifier: Apache-2.0
#include "tb/program/job.hpp"

#include <algorithm>

#include "ref/program/input_error.hpp"
#include "ref/program/program_reader.hpp"

namespace curvecore::tb {

std::uint64_t Job::path_length() const {
    const ref::Segment& last = plan.segments.back();
    return last.s_start + last.length;
}

const char* Job::core_name() const { return options.core.splines != 0 ? "curve" : "spherical"; }

double Job::bound() const {
    double bound = 0;
    for (const ref::Segment& segment : plan.segments) bound = std::max(bound, segment.bound);
    return bound;
}

namespace {

void set_splines(Job& job) {
    const auto first =
        std::find_if(job.program.moves.begin(), job.program.moves.end(),
                     [](const ref::Move& move) { return move.kind == ref::Move::Kind::kCubic; });
    if (first == job.program.moves.end()) {
        if (job.options.core.parameter_guard == 0 || job.options.core.splines != 0) return;
        throw ref::InputError(job.options.file, 0,
                              "no spline, which --set ParameterGuard is for, nor --set Splines=1");
    }
    if (job.options.splines_set && job.options.core.splines == 0) {
        throw ref::InputError(job.options.file, first->line, "a spline, and --set Splines=0");
    }
    if (job.options.core.turn_bits != 0) {
        throw ref::InputError(job.options.file, first->line,
                              "a spline, and --set TurnBits is for lines and arcs");
    }
    job.options.core.splines = 1;
}

}  // namespace

Job read_job(const Options& options) {
    Job job;
    job.options = options;
    job.program = ref::read_program(options.file, options.points);
    set_splines(job);
    if (!options.aux_axes_set) job.options.core.aux_axes = job.program.aux_axes;
    if (!options.machine.empty()) job.machine = ref::read_machine(options.machine);
    return job;
}

void plan_job(Job& job) {
    job.plan = ref::make_plan(job.program, job.machine, job.options.plan_options());
    if (job.plan.segments.empty()) {
        throw ref::InputError(job.options.file, 0, "the program does not move");
    }
    job.limits = ref::limit_report(job.program, job.machine, job.plan);
}

}  // namespace curvecore::tb
