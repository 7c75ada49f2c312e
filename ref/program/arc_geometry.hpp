// SPDX-License-Identifier: Apache-2.0
// From what a program says of an arc to its centre and angle. Lengths in mm, angles in rad.
#pragma once

#include <Eigen/Core>
#include <stdexcept>

namespace curvecore::ref {

/// An arc that cannot be drawn; what() is the reason.
class ArcError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

constexpr int kMostTurns = 10000;

/// In a plane seen from the tip of its normal, counter-clockwise positive.
struct PlaneArc {
    Eigen::Vector2d centre;
    double angle;  // > 0 in the arc's own direction; 0: so short that it is a line
};

/// Arc with a given centre; a full circle when the ends are the same.
///
/// Where the radii at both ends differ by a file's rounding (<= 0.005 mm, or <= 0.5 mm and
/// <= 0.1 %), the centre moves to the nearest point that is equally far from both. Ends as near
/// to each other as that rounding, with no such centre, make a line (angle 0).
/// @throws ArcError
PlaneArc arc_with_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                         const Eigen::Vector2d& centre, bool clockwise, int turns);

/// Arc with a given radius: up to half a turn for a positive one, above it for a negative one.
/// Ends up to 0.005 mm farther apart than 2 R make a half circle about their middle.
/// @throws ArcError
PlaneArc arc_with_radius(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double radius,
                         bool clockwise, int turns);

struct SpaceArc {
    Eigen::Vector3d centre;
    Eigen::Vector3d normal;  // counter-clockwise about it
    double angle;
};

/// The arc from `start` by way of `middle` to `end`. @throws ArcError
SpaceArc arc_through(const Eigen::Vector3d& start, const Eigen::Vector3d& middle,
                     const Eigen::Vector3d& end);

}  // namespace curvecore::ref
