// SPDX-License-Identifier: Apache-2.0
// A line, or a piece of a circle or of a helix, as a core draws it.
#pragma once

#include <memory>

#include "ref/curve/drawn/path_curve.hpp"

namespace curvecore::ref {

/// A curve of at most a quarter turn, in length units:
///
///     r(s) = start + radius (t sin a - n 2 sin^2(a/2)) + advance s,    a = twist s
///
/// | field     | symbol | shape | unit    | remark                             |
/// |-----------|--------|-------|---------|------------------------------------|
/// | tangent   | t      | 3     | 1       | of the circle at s = 0; 0 of lines |
/// | normal    | n      | 3     | 1       | outward, at s = 0; 0 of lines      |
/// | cos_pitch |        |       | 1       | 0 of lines                         |
/// | radius    |        |       | units   | 0 of lines                         |
/// | advance   |        | 3     | 1       | per unit of path                   |
/// | twist     | phi    |       | 1/units | cos_pitch / radius; 0 of lines     |
///
/// The chord form has no centre: a large radius costs nothing. Error of a position per axis: the
/// roundings of about eight operations, measured below 0.6 2^-50 max(|start|, s): below 1e-6 units
/// for |start|, s <= 2.1e9 units and any radius. Errors of the derivatives: roundings.
struct ArcPiece {
    Vec3 tangent = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double cos_pitch = 0;
    double radius = 0;
    Vec3 advance = Vec3::Zero();

    double twist() const { return radius > 0 ? cos_pitch / radius : 0; }

    /// Returns "line", "arc" or "helix".
    const char* name() const;
    std::unique_ptr<PathCurve> path(const Vec3& start, double length) const;
};

}  // namespace curvecore::ref
