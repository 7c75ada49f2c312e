// SPDX-License-Identifier: Apache-2.0
// Moves of a program as they are drawn, while it is read: smooth within G64's tolerance, and with
// arcs in place of splines where the core or the user needs them; and as joints, where the machine
// has some.
#pragma once

#include <deque>
#include <memory>

#include "ref/joints/joint_moves.hpp"
#include "ref/moves/spline_form.hpp"
#include "ref/path/smooth_stream.hpp"
#include "ref/program/program_stream.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

class DrawnMoves {
  public:
    /// @param machine must outlive this object
    /// @throws ref::InputError when the program cannot be opened
    DrawnMoves(const Options& options, const ref::Machine& machine,
               std::optional<ref::SplineForm> form = {});

    /// Gives the next move behind Options::from_mm. Returns false at the end.
    /// @throws ref::InputError, also where the whole path is before that
    bool next(ref::Move& move);

    const ref::ProgramStream& program() const { return program_; }
    /// Returns true if a part is drawn as programmed because core or machine cannot draw it
    /// smoothly.
    bool refused() const { return smooth_ && smooth_->refused(); }
    /// Figures of the path that was given; none: it is the programmed one.
    std::optional<ref::Smoothed> smoothed() const;
    const ref::Replaced& replaced() const { return replaced_; }
    /// Deviations of the moves that were given, on any path.
    const ref::Smoothed& off() const { return off_; }
    /// Cuts that were checked: for the plan of these moves.
    const std::shared_ptr<ref::KnownCuts>& cuts() const { return plan_options_.cuts; }

  private:
    bool carried(const std::deque<ref::Move>& moves) const;
    void replace(const ref::Move& spline);
    bool give(ref::Move& move);
    bool give_tool(ref::Move& move);

    ref::ProgramStream program_;
    const ref::Machine machine_;  // the tool's
    ref::PlanOptions plan_options_;
    std::optional<ref::SmoothStream> smooth_;
    ref::SplineForm form_;
    double tolerance_;  // mm, of moves that are not splines
    ref::Replaced replaced_;
    ref::Smoothed off_;
    std::deque<ref::Move> ready_;
    const double from_;     // mm of the tool's path
    const double stretch_;  // of the path that is drawn
    double left_out_ = 0;   // mm of the tool's
    bool given_ = false;
    std::optional<ref::JointMoves> joints_;
};

/// Opens the program that these options name.
ref::ProgramStream open_program(const Options& options);
/// Options with which segments of any program are made.
ref::PlanOptions segment_options(const Options& options);
/// Returns true if a core with these options can draw splines.
bool draws_splines(const Options& options);
/// Returns the form in which splines are drawn; `form`: given.
ref::SplineForm form_of(const Options& options, std::optional<ref::SplineForm> form = {});

}  // namespace curvecore::sysc
