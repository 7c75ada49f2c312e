// SPDX-License-Identifier: Apache-2.0
// The planned motion of a program, or of a window of it, and its parts.
#pragma once

#include "ref/feed/stretch.hpp"

namespace curvecore::ref {

class WindowMotion {
  public:
    /// @param geometry outlives the motion
    WindowMotion(std::vector<Stretch> stretches, const Geometry& geometry, const PieceGrid& grid,
                 double last_dwell);

    /// Start time of each planned move, and the end; s.
    const std::vector<double>& times() const { return times_; }

    /// Speed at the start of each planned move, mm/s.
    const std::vector<double>& speeds() const { return speeds_; }

    /// Returns true if a planned move is the first of a move of the program.
    bool begins_move(std::size_t move) const;

    /// Appends the pieces of the planned moves from `first` up to `end` (not included).
    void append(std::size_t first, std::size_t end, std::vector<ProfilePiece>& pieces) const;
    void append_last_dwell(std::vector<ProfilePiece>& pieces) const;

    /// Returns the motion of these moves in the form that a window which begins with them is given.
    std::vector<GivenRun> given(std::size_t first, std::size_t end) const;

  private:
    template <class Visit>
    void each_part(std::size_t first, std::size_t end, Visit visit) const;

    std::vector<Stretch> stretches_;
    const Geometry* geometry_;
    PieceGrid grid_;
    double last_dwell_;
    std::vector<double> times_;
    std::vector<double> speeds_;
};

}  // namespace curvecore::ref
