// SPDX-License-Identifier: Apache-2.0
// A job: a program read and planned, the start of every command.
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
    ref::Program program;                 // moves are filled by read_job() alone
    std::optional<ref::Dialect> dialect;  // dialect of G-code; none: another reader
    ref::Events events;                   // actions besides motion
    int first_wait = 0;                   // line of the first wait with motion behind it; 0: none
    ref::Machine machine;
    DrawnPlan plan;
    ref::LimitReport limits;
    ref::Smoothed off;                      // deviation of the drawn path from the programmed one
    std::optional<ref::Smoothed> smoothed;  // unless the exact path is asked for
    std::optional<FormCost> exact;          // cost of the exact path, if the drawn one differs
    std::optional<AsArcs> as_arcs;          // set where arcs replaced splines

    /// Digest of the settings that its words are made for.
    std::uint16_t digest() const;
    /// Name of the core: "spherical", or "curve", which draws splines as well.
    const char* core_name() const;
    /// Returns true if a bound is derived for segments of this kind: none for splines with Anchor
    /// 0, which are planned with that of Anchor 1.
    bool bounded(ref::CurveKind kind) const;
    /// Returns true if a bound is derived for every segment.
    bool bounded() const;
    /// Worst derived bound of any segment, length units before the final rounding.
    double bound() const;
    /// Returns true if X Y Z are joints of the machine.
    bool joints() const { return !ref::is_trivial(machine.kinematics); }
    /// Length of the tool's path, mm.
    double path_mm() const;
    /// Number of words of both streams.
    std::size_t words() const { return plan.words(options.core.segment_words()); }
    /// Returns true if the drawn path differs from the programmed one.
    bool is_smooth() const;
};

/// Returns the writer of a job's profile: with changes of outputs, where the board has some.
ProfileWriter profile_writer(const Job& job);

/// Reads the machine that the options name, or the built-in one. @throws ref::InputError
ref::Machine machine_of(const Options& options);

/// @throws UsageError: X Y Z are joints of this machine, which `who` does not draw
void refuse_joints(const ref::Machine& machine, const char* who);

/// Reads program and machine, for commands that draw moves themselves; the core gets the program's
/// auxiliary axes, and splines if the program has them, unless --set says otherwise.
/// @throws ref::InputError, also for splines where --set excludes them
Job read_job(const Options& options);

/// Reads and plans the whole program (sysc/job/job_stream.hpp).
/// @throws UsageError: a sample period shorter than the core's own clocks
/// @throws ref::InputError, also when the program does not move
Job plan_job(const Options& options);

/// Reads all of standard input once, for commands that read a program again.
/// @throws ref::InputError
void hold_input(Options& options);

/// Raises the feed of a move for an override above 100 %.
void raise_feed(ref::Move& move, const Options& options);

/// Makes the core draw splines if the program has one, in this line.
/// @throws ref::InputError where the core cannot
void set_splines(Job& job, const std::optional<int>& line);

/// Add a job's warnings: that the path is not smooth; and for a finished plan, line and cause of
/// motion that anything but the machine's limits slows.
void warn_of_exact_path(Job& job);
void warn_of_plan(Job& job, bool bounded, double duration_s);
/// Adds warnings of a finished plan: narrow words cost segments, which the host has to send.
void warn_of_segments(Job& job);

}  // namespace curvecore::sysc
