// SPDX-License-Identifier: Apache-2.0
// The places where the programmed path is not smooth, and the reach of a smooth one there.
#pragma once

#include <optional>
#include <vector>

#include "ref/path/tube/programmed_path.hpp"
#include "ref/path/tube/tube_knots.hpp"

namespace curvecore::ref {

/// A joint between two moves of a group, or at its ends.
///
/// | kind    | remark                                                     |
/// |---------|------------------------------------------------------------|
/// | kPassed | nothing jumps, or an end that is passed                    |
/// | kStop   | the machine stands still: a reversal, or an end            |
/// | kCorner | rounded by one cubic (ref/path/corner.hpp)                 |
/// | kCurve  | part of a curve, alone or with its neighbours              |
struct PathJoint {
    enum class Kind { kPassed, kStop, kCorner, kCurve };
    double s = 0;
    Kind kind = Kind::kPassed;
    double reach = 0;  // mm to both sides
};

/// Standstill of the machine at the ends of a group.
struct Rest {
    bool before;
    bool after;
};

/// A group: consecutive lines and arcs with one tolerance, all rapid or none, without a stop. Lines
/// in one direction are one move here.
class PathJoints {
  public:
    /// Returns the number of pieces of ProgrammedPath that a move takes.
    static std::size_t parts(const Move& move, double tolerance);

    /// @param first joint at the start as it was seen before the group was cut there
    PathJoints(const std::vector<Move>& moves, double tolerance, Rest rest,
               const std::optional<PathJoint>& first, const Pace& pace);

    std::size_t count() const { return moves_.size(); }  // number of moves; one joint more
    const Move& move(std::size_t i) const { return moves_[i]; }
    const PathJoint& operator[](std::size_t i) const { return joints_[i]; }
    const ProgrammedPath& path() const { return path_; }
    double tolerance() const { return tolerance_; }

    double length(std::size_t move) const { return joints_[move + 1].s - joints_[move].s; }
    double feed(std::size_t move) const;
    /// Returns true for a joint of two lines.
    bool lines(std::size_t joint) const;
    /// Returns true if a move between two joints is drawn with both.
    bool joined(std::size_t move) const;

  private:
    /// Change at a joint: the direction before it, its turn, and the step of the curvature.
    struct Change {
        Vec3 direction, turn, step;
    };

    double speed(std::size_t move) const;
    void look_at(std::size_t joint);
    bool is_long(std::size_t joint) const;
    bool passed(std::size_t joint, const Change& change) const;
    double curve_reach(std::size_t joint, double turn, const Change& change) const;
    double asked_reach(std::size_t joint, double turn, const Change& change) const;

    double tolerance_;
    const Pace& pace_;
    std::vector<Move> moves_;
    ProgrammedPath path_;
    std::vector<PathJoint> joints_;
};

}  // namespace curvecore::ref
