// SPDX-License-Identifier: Apache-2.0
// A program read and planned: what every command starts from.
#pragma once

#include "ref/feed/limit_report.hpp"
#include "ref/path/smooth_path.hpp"
#include "sysc/host/as_arcs.hpp"
#include "sysc/host/options.hpp"

namespace curvecore::sysc {

struct Job {
    Options options;
    ref::Program program;
    ref::Machine machine;
    ref::Plan plan;
    ref::LimitReport limits;
    std::optional<ref::Smoothed> smoothed;  // unless the exact path is asked for
    ref::Program programmed;                // before, where that is another
    std::optional<FormCost> exact;          // what that would cost
    std::optional<AsArcs> as_arcs;          // where --fit arcs took the splines' place

    /// Length of the whole path, quanta.
    std::uint64_t path_length() const;
    /// "spherical", or "curve": the one that draws splines as well.
    const char* core_name() const;
    /// Whether a bound is derived for the segment: none of splines with Anchor 0, which are planned
    /// with that of Anchor 1.
    bool bounded(const ref::Segment& segment) const;
    /// Of every segment.
    bool bounded() const;
    /// Worst derived bound of any segment, length units before the final rounding.
    double bound() const;
};

/// Reads program and machine; the core has the program's auxiliary axes, and splines if the program
/// does, unless --set says otherwise.
/// @throws ref::InputError, also for splines where --set says that there are none
Job read_job(const Options& options);

/// The same of a program that was read or made.
Job make_job(const Options& options, ref::Program program);

/// The feed of a move that an override above 100 % asks for.
void raise_feed(ref::Move& move, const Options& options);

/// Plans for the core in job.options.
/// @throws UsageError: a sample period shorter than the core's own clocks
/// @throws ref::InputError, also when the program does not move
void plan_job(Job& job);

/// The core draws splines if the program has one, in this line.
/// @throws ref::InputError where it cannot
void set_splines(Job& job, const std::optional<int>& line);

/// Adds a job's warnings: of a path that is not smooth, of a finished plan.
void warn_of_exact_path(Job& job);
void warn_of_plan(Job& job, bool bounded);

/// What the program would cost as it is written, or in other forms, for a report.
void plan_others(Job& job);

}  // namespace curvecore::sysc
