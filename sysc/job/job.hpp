// SPDX-License-Identifier: Apache-2.0
// A program read and planned: what every command starts from.
#pragma once

#include "ref/feed/pieces/limit_report.hpp"
#include "ref/moves/events.hpp"
#include "ref/path/smooth_path.hpp"
#include "sysc/job/as_arcs.hpp"
#include "sysc/job/drawn_plan.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct Job {
    Options options;
    ref::Program program;                 // its moves: of read_job() alone
    std::optional<ref::Dialect> dialect;  // of G-code that this program's own reader has read
    ref::Events events;                   // what it asks for besides motion
    ref::Machine machine;
    DrawnPlan plan;
    ref::LimitReport limits;
    ref::Smoothed off;                      // how far the drawn path is from the programmed one
    std::optional<ref::Smoothed> smoothed;  // unless the exact path is asked for
    std::optional<FormCost> exact;          // what that would cost, where it is another
    std::optional<AsArcs> as_arcs;          // where arcs took the splines' place

    /// Of what its words are made for.
    std::uint16_t digest() const;
    /// "spherical", or "curve": the one that draws splines as well.
    const char* core_name() const;
    /// Whether a bound is derived for segments of this kind: none of splines with Anchor 0, which
    /// are planned with that of Anchor 1.
    bool bounded(ref::Segment::Kind kind) const;
    /// For every segment.
    bool bounded() const;
    /// Worst derived bound of any segment, length units before the final rounding.
    double bound() const;
    /// Of both streams, in all.
    std::size_t words() const { return plan.words(options.core.aux_axes); }
    /// Whether the path that is drawn is not the programmed one.
    bool is_smooth() const;
};

/// The machine that the options name, or the built-in one. @throws ref::InputError
ref::Machine machine_of(const Options& options);

/// Reads program and machine, for what draws moves by itself; the core has the program's auxiliary
/// axes, and splines if the program does, unless --set says otherwise.
/// @throws ref::InputError, also for splines where --set says that there are none
Job read_job(const Options& options);

/// The whole program, planned (sysc/job/job_stream.hpp).
/// @throws UsageError: a sample period shorter than the core's own clocks
/// @throws ref::InputError, also when the program does not move
Job plan_job(const Options& options);

/// Standard input is read once: all of it, for what reads a program again.
/// @throws ref::InputError
void hold_input(Options& options);

/// The feed of a move that an override above 100 % asks for.
void raise_feed(ref::Move& move, const Options& options);

/// The core draws splines if the program has one, in this line.
/// @throws ref::InputError where it cannot
void set_splines(Job& job, const std::optional<int>& line);

/// Adds a job's warnings: of a path that is not smooth, of a finished plan that takes so long: what
/// is slower than asked and for another reason than the machine's limits names line and cause.
void warn_of_exact_path(Job& job);
void warn_of_plan(Job& job, bool bounded, double duration_s);
/// Of a plan whose moves are all there: narrow words are bought with segments, which the host has
/// to send.
void warn_of_segments(Job& job);

}  // namespace curvecore::sysc
