// SPDX-License-Identifier: Apache-2.0
// A program's moves as they are drawn, while it is read: smooth within G64's tolerance, and with
// arcs in the place of splines where the core or the user wants these.
#pragma once

#include <deque>
#include <memory>

#include "ref/path/smooth_stream.hpp"
#include "ref/program/program_stream.hpp"
#include "sysc/host/options.hpp"

namespace curvecore::sysc {

/// Of G64's tolerance, for what is made smooth, where arcs take the rest of it.
constexpr double kShareBesideArcs = 0.5;

class DrawnMoves {
  public:
    /// @param machine outlives it
    /// @throws ref::InputError when the program cannot be opened
    DrawnMoves(const Options& options, const ref::Machine& machine);

    /// The next move; false: there is none. @throws ref::InputError
    bool next(ref::Move& move);

    const ref::ProgramStream& program() const { return program_; }
    /// Whether a part is drawn as programmed since core or machine cannot have it smooth.
    bool refused() const { return smooth_ && smooth_->refused(); }

  private:
    bool carried(const std::vector<ref::Move>& moves) const;

    ref::ProgramStream program_;
    const ref::Machine& machine_;
    ref::PlanOptions plan_options_;
    std::optional<ref::SmoothStream> smooth_;
    std::optional<double> arcs_;  // tolerance, mm
    std::deque<ref::Move> ready_;
};

/// What segments of any program are made with.
ref::PlanOptions segment_options(const Options& options);
/// Whether a core with these options can draw splines.
bool draws_splines(const Options& options);
/// Whether arcs take the place of splines.
bool draws_arcs(const Options& options);

}  // namespace curvecore::sysc
