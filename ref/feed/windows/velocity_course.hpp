// SPDX-License-Identifier: Apache-2.0
// The velocity vector of a planned motion over time, with its jumps at joints.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/feed/ramps/zone_ramps.hpp"
#include "ref/limits/path_shape.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/plan/curve_follower.hpp"

namespace curvecore::ref {

/// Largest distance of V from its straight line between knots, as a share of A T, T = JointTime.
constexpr double kStraight = 0.0075;

/// The course V(t) = v r'(s), mm/s, linear between knots: joints, ends of segments and of phases,
/// and where V bends as many more as kStraight needs, with |V''| <= J at most every sqrt(8
/// kStraight T A / J).
/// A joint is the end of a move where V or V' jumps: not between lines in one direction, nor where
/// curves go on into each other. Knots are made near joints alone, part by part: their memory has a
/// bound, however long the motion.
class VelocityCourse {
  public:
    struct Joint {
        double t;         // s
        std::uint64_t s;  // quanta
    };
    struct Knot {
        double t;                  // s
        double v;                  // along the path
        AxisVector before, after;  // V, different at joints alone
        std::uint64_t s;           // quanta, at joints alone
        bool joint;
    };

    VelocityCourse(const std::vector<Segment>& segments, double unit_mm, int axes,
                   const Machine& machine);

    /// Adds runs, each over its segments, and rests, in the order of the program. The phases must
    /// outlive the course.
    void rest(double seconds) { time_ += seconds; }
    void run(const std::vector<Phase>& phases, std::size_t first_segment, std::size_t last_segment);
    const std::vector<Joint>& all_joints() const { return all_joints_; }

    /// Makes the knots less than `reach` (s) from all_joints() from the first-th on, up to a number
    /// of knots. Returns the joint behind the last that has all of its own.
    std::size_t look_at(std::size_t first, double reach);

    /// The knots that were made last.
    const std::vector<Knot>& knots() const { return knots_; }
    const std::vector<std::size_t>& joints() const { return joints_; }  // indices into the knots
    std::size_t axes() const { return axes_; }

    /// V at a time, on the late side of a jump. `knot`: one near that time; moved there.
    AxisVector at(double t, std::size_t& knot) const;

  private:
    /// Part of a phase on one segment.
    struct Piece {
        const Phase* phase;
        double from, to;  // s, within the phase
        double t;         // s, at `from`
        double start;     // mm, the segment's start along the run
        std::size_t segment;
        bool leaves;  // leaves the segment for the next
        bool joint;   // a joint there
        double end() const { return t + (to - from); }
    };

    AxisVector velocity(std::size_t segment, double s, double v);
    Knot knot(const Piece& piece, double after);
    void add_knots(const Piece& piece, double until, double since);
    bool is_joint(const Piece& piece);
    double distance(const Knot& middle, const Knot& from, const Knot& to) const;
    int count(double time, double off, bool line) const;

    const std::vector<Segment>& segments_;
    double unit_mm_;
    std::size_t axes_;
    double resolution_;              // s
    double precision_ = kUnlimited;  // mm/s
    double least_acceleration_ = kUnlimited;
    CurveFollower curve_;
    double time_ = 0;
    std::vector<Piece> pieces_;
    std::vector<Joint> all_joints_;
    std::vector<Knot> knots_;
    std::vector<std::size_t> joints_;
};

}  // namespace curvecore::ref
