// SPDX-License-Identifier: Apache-2.0
// A planned profile by its own time: its motion at any tick, and what the machine allows there.
#pragma once

#include <vector>

#include "ref/feed/path_places.hpp"
#include "ref/feed/piece_walk.hpp"

namespace curvecore::ref {

/// A short time of one piece on one move: the path's derivatives go linearly through it.
struct CourseCell {
    double from, to;            // ticks from the program's start
    const ProfilePiece* piece;  // of the plan
    double piece_start;         // ticks
    std::vector<PlaceLimit> begin, end;
};

/// Units: mm, s; times in ticks. A rest has no cells.
class ProfileCourse {
  public:
    /// Limits are `share` of the machine's, but never less than what the plan asks there by itself:
    /// where words round, that may be more. Machine and plan must outlive the course.
    ProfileCourse(const Program& program, const Machine& machine, const Geometry& geometry,
                  const Plan& plan, double share);

    const std::vector<CourseCell>& cells() const { return cells_; }
    const Machine& machine() const { return machine_; }
    double tick_s() const { return plan_.tick_s; }
    PieceMotion motion(const CourseCell& cell, double tick) const;

  private:
    std::vector<PlaceLimit> limits(const PieceStretch& stretch, double part, PathPlaces& places);

    const Machine& machine_;
    const Plan& plan_;
    double share_;
    double quantum_;
    std::vector<CourseCell> cells_;
};

}  // namespace curvecore::ref
