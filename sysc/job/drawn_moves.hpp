// SPDX-License-Identifier: Apache-2.0
// A program's moves as they are drawn, while it is read: smooth within G64's tolerance, and with
// arcs in the place of splines where the core or the user wants these.
#pragma once

#include <deque>
#include <memory>

#include "ref/moves/spline_form.hpp"
#include "ref/path/smooth_stream.hpp"
#include "ref/program/program_stream.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

class DrawnMoves {
  public:
    /// @param machine outlives it
    /// @throws ref::InputError when the program cannot be opened
    DrawnMoves(const Options& options, const ref::Machine& machine,
               std::optional<ref::SplineForm> form = {});

    /// The next move; false: there is none. @throws ref::InputError
    bool next(ref::Move& move);

    const ref::ProgramStream& program() const { return program_; }
    /// Whether a part is drawn as programmed since core or machine cannot have it smooth.
    bool refused() const { return smooth_ && smooth_->refused(); }
    /// Of the path that was given; none: it is the programmed one.
    std::optional<ref::Smoothed> smoothed() const;
    const ref::Replaced& replaced() const { return replaced_; }
    /// How far the moves that were given are off, of any path; only the deviations.
    const ref::Smoothed& off() const { return off_; }
    /// Of what was checked: for the plan of these moves, in the same thread.
    const std::shared_ptr<ref::KnownCuts>& cuts() const { return plan_options_.cuts; }

  private:
    bool carried(const std::vector<ref::Move>& moves) const;
    void replace(const ref::Move& spline);

    ref::ProgramStream program_;
    const ref::Machine& machine_;
    ref::PlanOptions plan_options_;
    std::optional<ref::SmoothStream> smooth_;
    ref::SplineForm form_;
    double tolerance_;  // mm, where it is not one of splines
    ref::Replaced replaced_;
    ref::Smoothed off_;
    std::deque<ref::Move> ready_;
};

/// The program that these options name.
ref::ProgramStream open_program(const Options& options);
/// What segments of any program are made with.
ref::PlanOptions segment_options(const Options& options);
/// Whether a core with these options can draw splines.
bool draws_splines(const Options& options);
/// How splines are drawn; `form`: given.
ref::SplineForm form_of(const Options& options, std::optional<ref::SplineForm> form = {});

}  // namespace curvecore::sysc
