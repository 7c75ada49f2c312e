// SPDX-License-Identifier: Apache-2.0
// What the machine does along a path, for choices alone: nothing that must hold follows from it.
#pragma once

#include <algorithm>
#include <vector>

#include "ref/curve/vec3.hpp"
#include "ref/machine/machine.hpp"

namespace curvecore::ref {

/// A limit of the path and of X, Y and Z. Of a vector's share of each, the largest counts: only the
/// limits that bind do.
struct PaceLimit {
    double path;
    Vec3 axes;

    double load(const Vec3& vector) const {
        return std::max(vector.norm() / path, vector.cwiseAbs().cwiseQuotient(axes).maxCoeff());
    }
    /// What it allows of a vector in this direction; without one, in any.
    double along(const Vec3& direction) const {
        const double size = direction.norm();
        return size > 0 ? size / load(direction) : std::min(path, axes.norm());
    }
};

/// Speed, mm/s, at a place of the path, mm, that runs in a direction.
struct PacePlace {
    double s;
    Vec3 direction;
    double speed;
};

/// Velocities whatever the feeds, which are low where nothing is hard; of acceleration and jerk
/// what plans take.
struct Pace {
    explicit Pace(const Machine& machine);

    PaceLimit velocity, acceleration, jerk;  // mm, s
    double joint_time;                       // s

    /// Speed that the path's direction, curvature and third derivative allow.
    double at(const Vec3& direction, const Vec3& bend, const Vec3& swerve) const;
    /// Speeds lowered until the acceleration that a ramp from the slower place reaches joins them.
    void sweep(std::vector<PacePlace>& places) const;
};

}  // namespace curvecore::ref
