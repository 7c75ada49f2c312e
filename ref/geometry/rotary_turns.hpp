// SPDX-License-Identifier: Apache-2.0
// Whole turns of rotary axes: words leave them out, so that an axis turns without end.
#pragma once

#include <string>

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"
#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

class RotaryTurns {
  public:
    RotaryTurns(const Machine& machine, const PlanOptions& options);

    /// Starts a rotary axis within a turn of 0, on its own side of it.
    void leave_out(Segment& segment) const;

    /// Number of segments that a line or an arc needs for all its turns.
    double pieces(const Move& move) const;

    /// Returns the reason why the words of a rotary axis (3 ..) do not hold the move, which is one
    /// segment if it is a spline; empty if they do.
    std::string beyond_words(const Move& move, std::size_t axis) const;

  private:
    /// Largest turn of a rotary axis in one segment, degrees: its words begin within a turn.
    double longest() const;

    const Machine& machine_;
    const PlanOptions& options_;
};

}  // namespace curvecore::ref
