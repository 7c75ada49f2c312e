// SPDX-License-Identifier: Apache-2.0
// The drawn path of a group of programmed moves, or of its first part.
#pragma once

#include <deque>
#include <limits>
#include <optional>

#include "ref/path/path_joints.hpp"
#include "ref/path/smooth_path.hpp"
#include "ref/path/tube/tube_run.hpp"

namespace curvecore::ref {

/// A cut of a group: after `s` mm of its path, in front of a joint or within the move that begins
/// there; `curve`: a cut within a curve, which passes the joint in this state.
struct PathCut {
    std::size_t joint = 0;
    double s = 0;
    std::optional<TubeEnd> curve;
};

class Drawing {
  public:
    /// @param begun cut at the first of these joints, in their path
    Drawing(const PathJoints& joints, const Pace& pace, const std::optional<PathCut>& begun,
            Smoothed& report);

    /// Returns the best cut in the second half of a group that goes on; none if there is none.
    std::optional<PathCut> best_cut() const;

    /// Draws up to a cut, or all of it.
    std::deque<Move> run(const std::optional<PathCut>& cut);
    /// Copies the same part as programmed; one of the two is called, once.
    std::deque<Move> run_as_programmed(const std::optional<PathCut>& cut);

  private:
    bool free(std::size_t move) const;
    bool inside_curve(std::size_t joint) const;
    std::size_t last_of_curve(std::size_t first) const;
    std::size_t draw_curve(std::size_t first);
    TubeTask task_of(std::size_t first, std::size_t last) const;
    void begin(TubeTask& task, std::size_t first) const;
    void end(TubeTask& task, std::size_t last) const;
    TubeEnd end_at(double s, std::size_t move, bool stop) const;
    void round_corner(std::size_t joint);
    void copy_to(double s);
    std::deque<Move> finish();
    void append(const Move& programmed, const TubePiece& piece);

    const PathJoints& joints_;
    const Pace& pace_;
    std::optional<PathCut> begun_;
    Smoothed& report_;
    std::optional<PathCut> cut_;
    std::deque<Move> drawn_;
    double reached_ = 0;      // mm of the path
    std::size_t copied_ = 0;  // moves that are drawn
};

}  // namespace curvecore::ref
