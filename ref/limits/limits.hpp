// SPDX-License-Identifier: Apache-2.0
// The machine's limits on a move and at a joint.
#pragma once

#include <functional>

#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

/// Shares of the limits that the feed profile takes; the rest is for feed holds, where the
/// acceleration is r^2 a + r' v and the jerk r^3 j + 3 r r' a + r'' v.
constexpr double kAccelerationShare = 0.95;
constexpr double kJerkShare = 0.95;

/// Share of velocities: rounding to the grid stays inside.
constexpr double kVelocityShare = 0.998;

/// Least share of the speed allowed at any of its points that all of a stretch has.
constexpr double kLeastShare = 0.6;

/// Largest turn of a joint passed in motion, |change of the unit tangent|: about 15 degrees.
constexpr double kSmallTurn = 0.26;

/// The machine's limits along the path, mm and s.
struct PathLimits {
    double velocity = 0;
    double acceleration = 0;  // while the speed is at most `velocity`
    double jerk = 0;          // while speed and acceleration are at most those above
};

/// Speed that a move's path and axis velocities, centripetal acceleration v^2 / R and jerk v^3 /
/// R^2 (of a spline also v^3 swerve) allow with some room left along the path.
double top_speed(const PathShape& shape, const Machine& machine);

/// Speed that the path's own velocity allows, all along a move.
double path_speed(const PathShape& shape, const Machine& machine);

/// Speed that path and axis velocities allow where r' is `along`, at a place: V_i^2 >= r'_i^2 v^2.
double highest_speed(const AxisVector& along, const PathShape& shape, const Machine& machine);

/// Speed that they allow all along a move.
double highest_speed(const PathShape& shape, const Machine& machine);

/// Limits along the path that a speed of at most v leaves.
PathLimits along_path(const PathShape& shape, const Machine& machine, double v);

/// Time to full acceleration of the quickest limit, s.
double ramp_time(const Machine& machine);
/// Time to full acceleration of the limits that bind along a move, s.
double ramp_time(const PathShape& shape, const Machine& machine);

/// Shares of a motion that a limit sees: the largest of what is along the path, and of v^2
/// `curvature`, which is across it.
struct LimitLoad {
    double rate;
    double swing;
    double curvature;  // 1/mm
    double acceleration, jerk;
};

/// Calls visit() for the path and every axis that moves.
void each_limit(const PathShape& shape, const Machine& machine,
                const std::function<void(const LimitLoad&)>& visit);

/// Speed at which a joint may be passed, mm/s; 0: stop. The change of the velocity vector stays
/// within acceleration * JointTime, the change of v^2 r'' within jerk * JointTime, path and every
/// axis.
double joint_velocity(const PathShape& before, const PathShape& after, const Machine& machine);

/// Loads as ratios to the limits, worst of path and axes.
struct LimitRatios {
    double velocity = 0;
    double acceleration = 0;
    double jerk = 0;
};

/// Loads of a joint passed with speed v: change of velocity over acceleration * JointTime (field
/// acceleration) and of v^2 r'' over jerk * JointTime (field jerk).
LimitRatios joint_ratios(const PathShape& before, const PathShape& after, const Machine& machine,
                         double v);

}  // namespace curvecore::ref
