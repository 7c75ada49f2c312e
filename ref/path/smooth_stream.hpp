// SPDX-License-Identifier: Apache-2.0
// A stream of programmed moves made a smooth path while it is read, in bounded memory.
//
// Moves are processed in groups. A group longer than a window, or of arcs with too many pieces, is
// cut within an unchanged move or between two corners. If all of it is one curve, the cut is at the
// straightest place, which the curve then passes with the direction and the bend of the chords
// there.
#pragma once

#include <deque>
#include <exception>
#include <functional>
#include <optional>

#include "ref/machine/machine.hpp"
#include "ref/moves/move_source.hpp"
#include "ref/path/drawing.hpp"
#include "ref/path/smooth_path.hpp"

namespace curvecore::ref {

/// Returns true if core and machine can make these moves.
using MovesCheck = std::function<bool(const std::deque<Move>&)>;

class SmoothStream {
  public:
    /// @param share of each tolerance to be used
    /// @param carried parts of a group that it refuses are drawn as programmed; none: accepts all
    /// @param window number of a group's moves in memory
    SmoothStream(MoveSource source, const Machine& machine, double share = 1,
                 MovesCheck carried = {}, std::size_t window = 2000);

    /// Gives the next move; returns false if there is none.
    /// @throws InputError of the source, after all moves before it
    bool next(Move& move);

    /// Report on the moves that were given out.
    const Smoothed& report() const { return report_; }
    /// Returns true if a part was refused.
    bool refused() const { return refused_; }

  private:
    void read_ahead();
    void read_group(std::size_t count);
    void draw();
    bool draw_group(bool must);
    void give(std::deque<Move> moves);

    MoveSource source_;
    Pace pace_;
    double share_;
    MovesCheck carried_;
    std::size_t window_;
    bool refused_ = false;
    bool begun_reading_ = false;
    std::exception_ptr error_;    // error of the source, after its moves
    std::optional<Move> ahead_;   // read, not yet part of a group
    std::optional<Move> before_;  // the group, as programmed
    std::vector<Move> group_;
    bool more_ = true;                // more of the group may come
    std::optional<PathCut> begun_;    // cut of the group, by its path now
    std::optional<PathJoint> first_;  // joint of this cut
    std::deque<Move> drawn_;
    Smoothed report_;
};

}  // namespace curvecore::ref
