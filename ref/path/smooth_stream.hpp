// SPDX-License-Identifier: Apache-2.0
// Programmed moves in, a smooth path out, as it is read: in bounded memory.
//
// Moves are looked at in groups. One that is longer than a window is cut: within a move that stays
// as it is, or between two corners; where all of it is one curve, at the straightest place, which
// the curve then passes in the direction and with the bend that chords see there.
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

/// Whether core and machine can have these moves.
using MovesCheck = std::function<bool(const std::vector<Move>&)>;

class SmoothStream {
  public:
    /// @param share of each tolerance that is used
    /// @param carried what it refuses of a group is drawn as programmed; none: all is carried
    /// @param window moves of a group that are looked at
    SmoothStream(MoveSource source, const Machine& machine, double share = 1,
                 MovesCheck carried = {}, std::size_t window = 2000);

    /// The next move; false: there is none.
    /// @throws InputError of the source, after all that it gave before
    bool next(Move& move);

    /// Of what was given out.
    const Smoothed& report() const { return report_; }
    /// Whether a part was refused.
    bool refused() const { return refused_; }

  private:
    void read_ahead();
    void read_group(std::size_t count);
    void draw();
    bool draw_group(bool must);
    void give(const std::vector<Move>& moves);

    MoveSource source_;
    Pace pace_;
    double share_;
    MovesCheck carried_;
    std::size_t window_;
    bool refused_ = false;
    bool begun_reading_ = false;
    std::exception_ptr error_;    // of the source, after what it gave
    std::optional<Move> ahead_;   // read, not yet of a group
    std::optional<Move> before_;  // the group, as programmed
    std::vector<Move> group_;
    bool more_ = true;                // of the group may come
    std::optional<PathCut> begun_;    // where the group was cut, by its path now
    std::optional<PathJoint> first_;  // of this cut
    std::deque<Move> drawn_;
    Smoothed report_;
};

}  // namespace curvecore::ref
