// SPDX-License-Identifier: Apache-2.0
// The machine's limits over windows of time: where a planned motion with joints violates them, and
// the speeds at which these joints may be passed instead.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ref/feed/windows/velocity_course.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/numeric/workers.hpp"

namespace curvecore::ref {

/// Speed at which the joint at path length s may be passed; linked: so may all of the path since
/// the joint before it.
struct JointCap {
    std::uint64_t s = 0;  // quanta
    double t = 0;         // s, of the course
    double velocity = 0;  // mm/s
    bool linked = false;
};

/// Length of a window, s, beyond which (a) below implies (b).
double longest_window(const Machine& machine);
/// Reach of windows to both sides of a place, s: three places up to two of the longest apart.
double window_reach(const Machine& machine);

/// Checks for every window w >= T = JointTime, of the path (X Y Z as a vector; U V W where these
/// stand) and of every axis, with V(t) = v r'(s) and its jumps dV at joints:
///
///     |V(t + w) - V(t)|               <=  A (w + T)                                         (a)
///     |V(t + 2w) - 2 V(t + w) + V(t)| <=  J w (w + T) + A T                                 (b)
///     |sum of dV within T|            <=  A T                                               (c)
///
/// (b) / w is the change of the mean acceleration between adjacent windows. Why a plan keeps them:
/// - Inside moves the zones keep |V'| <= A and |V''| <= J (ref/limits/limits.hpp). So a window
///   without a joint, a jump of V or of V', has (a) and (b) with A w and J w^2. All others are
///   checked here.
/// - V is taken as linear between knots (VelocityCourse): off by kStraight A T, in (b) by four
///   times that, which is kept free.
/// - Then the left sides are norms of functions linear in t between the times at which a place of
///   the window (t, t + w, t + 2w) meets a knot. Such norms are largest at an end: for a given w,
///   windows with a place at a knot, on either side of its jump, are all that count.
/// - As w grows the left sides are linear until a second place meets a joint. So w = the time
///   between two joints, and half of that, are checked, for the next kPairs joints from T on that
///   have a jump of kLarge A T. Smaller jumps, or more of them, are as good as a bend: w in steps
///   of a factor kFine, a turn of V to and fro then shows 98 % of its most in one of them (sin^2),
///   up to J w^2 = 9 A T, then of 2, where the right side grows as fast as the left one can.
/// - From w = 2 A / J + T on, (a) implies (b).
/// - A plan slowed in time keeps what it kept, and its jumps shrink with the speed. So the joints
///   of a window that breaks a bound get less speed, and the plan is made and checked again.
///
/// Returns the joints in ascending order; none: the motion keeps the rule. O(n) in joints and
/// phases, for each w.
std::vector<JointCap> joint_caps(const Machine& machine, VelocityCourse& course,
                                 const std::shared_ptr<Workers>& workers = {});

/// Checks one part of a motion, the part whose knots exist.
class WindowRule {
  public:
    WindowRule(const Machine& machine, const VelocityCourse& course);

    std::vector<JointCap> caps(const std::shared_ptr<Workers>& workers);

  private:
    using Knot = VelocityCourse::Knot;
    struct Limit {
        double acceleration, jerk;
        int axis;  // -1: the path
    };
    struct Broken {
        std::size_t first, last;  // indices into the course's joints
        double velocity;          // mm/s, that they may have
    };

    using Found = std::vector<Broken>;

    struct Jump {
        const Knot* knot;
        std::size_t index;
        AxisVector middle;
        double half;  // half of its size
    };
    using Places = std::array<std::size_t, 3>;  // knots near the last queries

    double most_change(const Limit& limit, double w) const;
    double most_second(const Limit& limit, double w) const;
    template <class Bound>
    double ratio(const AxisVector& size, Bound bound) const;
    void change(const AxisVector& from, const AxisVector& to, double t, double w,
                Found& found) const;
    void second(const AxisVector& a, const AxisVector& b, const AxisVector& c, double t, double w,
                Found& found) const;
    void keep(double from, double to, double ratio, Found& found) const;
    void look_at_length(double w, Found& found) const;
    std::vector<Jump> large_jumps() const;
    void look_at_pairs(const std::vector<Jump>& large, std::size_t first, std::size_t end,
                       Found& found) const;
    void look_at_pair(const Jump& first, const Jump& last, Places& places, Found& found) const;
    void look_at_jumps(Found& found) const;
    std::vector<double> speeds(Found& found, std::vector<bool>& linked) const;

    const VelocityCourse& course_;
    double joint_time_;
    double longest_;  // s
    double fine_ = 0;
    std::vector<Limit> limits_;
    Limit weakest_{kUnlimited, kUnlimited, -1};
};

}  // namespace curvecore::ref
