// SPDX-License-Identifier: Apache-2.0
// Estimates of a machine's motion along a path, for choices alone: no guarantee rests on them.
#pragma once

#include <algorithm>
#include <vector>

#include "ref/curve/vec3.hpp"
#include "ref/machine/machine.hpp"

namespace curvecore::ref {

/// A limit of the path and of X, Y and Z. The largest of a vector's shares counts: only limits that
/// bind have an effect.
struct PaceLimit {
    double path;
    Vec3 axes;

    double load(const Vec3& vector) const {
        return std::max(vector.norm() / path, vector.cwiseAbs().cwiseQuotient(axes).maxCoeff());
    }
    /// Limit of a vector in this direction; without one, in any.
    double along(const Vec3& direction) const {
        const double size = direction.norm();
        return size > 0 ? size / load(direction) : std::min(path, axes.norm());
    }
};

/// Speed, mm/s, at a place of the path, mm, with its direction.
struct PacePlace {
    double s;
    Vec3 direction;
    double speed;
};

/// Velocities independent of feeds, which are low where nothing is hard; accelerations and jerks
/// are those that plans take.
struct Pace {
    explicit Pace(const Machine& machine);

    PaceLimit velocity, acceleration, jerk;  // mm, s
    double joint_time;                       // s

    /// Speed that the path's direction, curvature and third derivative allow, mm/s.
    double at(const Vec3& direction, const Vec3& bend, const Vec3& swerve) const;
    /// Lowers speeds until the acceleration that a ramp from the slower place reaches joins them.
    void sweep(std::vector<PacePlace>& places) const;
};

}  // namespace curvecore::ref
