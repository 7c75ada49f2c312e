// SPDX-License-Identifier: Apache-2.0
// A planned profile over its own time: its motion at any tick, and the machine's limits there.
#pragma once

#include <algorithm>
#include <deque>
#include <vector>

#include "ref/feed/pieces/piece_walk.hpp"
#include "ref/feed/places/path_places.hpp"

namespace curvecore::ref {

/// A short time of one piece on one move, in which the path's derivatives are linear.
struct CourseCell {
    double from, to;    // ticks from the program's start
    PieceMotion start;  // at `from`; constant jerk
    PlaceLimits begin, end;
};

/// A part of a plan, made stretch by stretch. Units: mm, s; times in ticks. A rest has no cells.
class ProfileCourse {
  public:
    /// Makes a course with `share` of the machine's limits, but never less than the plan takes
    /// there by itself: where words are rounded, that may be more. All arguments must outlive the
    /// course.
    ProfileCourse(const Program& program, const Machine& machine, const Geometry& geometry,
                  const Plan& plan, double share);

    /// Adds the plan's next stretch (walk_pieces).
    void add(const PieceStretch& stretch);
    void forget_before(double tick);

    const std::deque<CourseCell>& cells() const { return cells_; }
    const Machine& machine() const { return machine_; }
    double tick_s() const { return plan_.tick_s; }
    PieceMotion motion(const CourseCell& cell, double tick) const {
        const PieceMotion& m = cell.start;
        const double t = (tick - cell.from) * plan_.tick_s;
        return {std::max(0.0, m.v + (m.a + m.j / 2 * t) * t), m.a + m.j * t, m.j};
    }
    /// Returns true if speed and limits are constant between these ticks, so that all stops are
    /// alike.
    bool even(double from, double to) const;

  private:
    PlaceLimits limits(const PieceStretch& stretch, double part);

    const Machine& machine_;
    const Plan& plan_;
    double share_;
    double quantum_;
    PathPlaces places_;
    const ProfilePiece* piece_;  // piece of the last stretch
    double piece_start_ = 0;
    std::deque<CourseCell> cells_;
};

}  // namespace curvecore::ref
