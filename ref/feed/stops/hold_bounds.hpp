// SPDX-License-Identifier: Apache-2.0
// Results of a finished profile: how fast time may be scaled, and the feed at every joint.
#pragma once

#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// Sets the bounds of the time scaler for the whole program. With the rate of time r (0..1), the
/// path's acceleration is r^2 a + r' v and its jerk r^3 j + 3 r r' a + r'' v. The scaler takes the
/// bounds up to r = 7/8 =: q and an eighth of them from there on, so both stay within what the
/// moves allow if, for every piece with the limits A and J of the moves that it crosses,
///
///     r' v <= A - q^2 |a|       3 q r' |a| + r'' v <= J - q^3 |j|
///     r' v / 8 <= A - |a|       (3 r' |a| + r'' v) / 8 <= J - |j|
///
/// The words are whole multiples of eight, 2^-32 per tick^2: with ticks below some 10 us the
/// smallest second difference may exceed r''.
void set_hold_bounds(const Machine& machine, const PlanOptions& options, const Geometry& geometry,
                     Plan& plan);

/// Sets bounds of the same inequalities, by what pieces take of path and axes at places along them
/// instead of what they may, and r' and r'' share the jerk so that a stop is quickest: it takes
/// fewer ticks, and longer to find.
void set_close_hold_bounds(const Program& program, const Machine& machine,
                           const PlanOptions& options, const Geometry& geometry, Plan& plan);

/// Sets the same bounds for everything that may be asked of the machine with speeds up to
/// `fastest`, mm/s, by the axes that plan.aux_axes counts, before any of it is planned.
void set_hold_bounds(const Machine& machine, const PlanOptions& options, double fastest,
                     Plan& plan);

/// Upper bound of the profile's ticks while time stops, from any state of the scaler. With the
/// bounds a (second difference) and n a (slope), in rates of 1, a change of the rate by d takes
///
///     time(d) = d / (n a) + n  or, if the slope stays below n a,  2 sqrt(d / a)
///
/// Last are stops from a rate that rises to 1 with an eighth of the bounds: at a rate of at most 1
/// while it may not overshoot, for half of time(2/8) or n; then time(1/8) at a rate of 15/16; then,
/// with the whole bounds, time(7/8) at 7/16. Two ticks more for each part that is rounded to whole
/// ticks. Before all that a stop waits up to kStopLead ticks, in which a branch may come.
std::uint32_t stop_ticks(std::uint32_t acceleration, std::uint32_t slope_steps);

/// Sets Segment::ticks, feed_start, feed_end (mm/s along the path) from the pieces; both begin at s
/// = 0.
/// @throws InputError: a segment and the rests in it take 2^31 ticks or more
void set_segment_feeds(const Program& program, const PlanOptions& options,
                       const std::vector<ProfilePiece>& pieces, std::vector<Segment>& segments);

}  // namespace curvecore::ref
