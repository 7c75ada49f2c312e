// SPDX-License-Identifier: Apache-2.0
// Centre and angle of an arc from the words of a program. Lengths in mm, angles in rad.
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {

/// An arc that cannot be drawn; what() is the reason.
class ArcError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

constexpr int kMostTurns = 10000;
constexpr double kSamePoint = 1e-9;      // mm: below any length unit
constexpr double kSameDirection = 1e-9;  // mm along the circle: ends this near make a whole turn

/// Largest difference of an arc's radii at both ends: `always` mm, or `most` mm and 0.1 %. Largest
/// distance of the ends beyond the reach of a given radius: `reach` mm.
struct ArcTolerance {
    double always;
    double most;
    double reach;

    bool holds(double r_start, double r_end) const;
};

constexpr ArcTolerance arc_tolerance(double always, double reach) {
    return {always, 100 * always, reach};
}
/// Tolerances of LinuxCNC's interpreter, for programs in mm and in inches.
constexpr ArcTolerance kArcToleranceMm = arc_tolerance(0.02 * 1.41421356237309505, 0.005);
constexpr ArcTolerance kArcToleranceInch =
    arc_tolerance(0.002 * 25.4 * 1.41421356237309505, 0.0005 * 25.4);
/// Tolerance for arcs that another controller's interpreter has accepted.
constexpr ArcTolerance kAnyArc = arc_tolerance(kUnlimited, 0);

/// An arc in a plane seen from the tip of its normal, counter-clockwise positive:
///
///     r(u) = centre + start's radius turned by angle u + drift u       u = 0 .. 1
struct PlaneArc {
    Eigen::Vector2d centre;
    double angle;           // > 0 in the arc's own direction
    Eigen::Vector2d drift;  // 0 where the radii at both ends are the same
};

/// Makes the arc about a given centre, from the start with its radius to the direction of the end.
/// Where the radii at both ends differ, the drift is that difference, along the end's radius: no
/// place is farther from the circle than that. Ends in one direction from the centre make a full
/// circle.
/// @throws ArcError
PlaneArc arc_with_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                         const Eigen::Vector2d& centre, bool clockwise, int turns,
                         const ArcTolerance& tolerance);

/// Makes the arc with a given radius: up to half a turn for a positive one, above it for a negative
/// one. Ends farther apart than 2 R by up to `tolerance.reach` make a half circle about their
/// middle.
/// @throws ArcError
PlaneArc arc_with_radius(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double radius,
                         bool clockwise, int turns, const ArcTolerance& tolerance);

struct SpaceArc {
    Eigen::Vector3d centre;
    Eigen::Vector3d normal;  // counter-clockwise about it
    double angle;
};

/// Makes the arc from `start` by way of `middle` to `end`. @throws ArcError
SpaceArc arc_through(const Eigen::Vector3d& start, const Eigen::Vector3d& middle,
                     const Eigen::Vector3d& end);

}  // namespace curvecore::ref
