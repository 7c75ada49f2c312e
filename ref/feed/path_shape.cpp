// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/path_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace curvecore::ref {

PathShape path_shape(const Move& move) {
    PathShape shape;
    const double length = move.length();
    if (!(length > 0)) return shape;
    double fastest = 0;
    for (int i = 0; i < kAuxAxes; ++i) {
        fastest = std::max(fastest, std::abs(move.aux_end[i] - move.aux_start[i]));
    }
    shape.length = std::max(length, fastest / kMaxAuxRate);
    shape.rate = length / shape.length;

    Vec3 axial = move.end - move.start;
    if (move.kind == Move::Kind::kArc) {
        axial = move.normal * move.advance;
        const Vec3 arm = move.start - move.centre;
        const double radius = arm.norm();
        const Vec3 n = arm / radius;
        const Vec3 t = move.normal.cross(n);
        shape.turn = radius * move.angle / shape.length;
        shape.twist = move.angle / shape.length;
        shape.curvature = shape.turn * shape.twist;
        const double c = std::cos(move.angle);
        const double s = std::sin(move.angle);
        const Vec3 t_end = t * c - n * s;
        for (int i = 0; i < 3; ++i) {
            shape.swing[i] = std::min(1.0, std::hypot(t[i], n[i]));
            shape.tangent_start[i] = shape.turn * t[i];
            shape.tangent_end[i] = shape.turn * t_end[i];
        }
        shape.bend_start = -shape.curvature * n;
        shape.bend_end = -shape.curvature * (n * c + t * s);
    }
    bool moves_linear = false;
    for (int i = 0; i < kMachineAxes; ++i) {
        const double travel = i < 3 ? axial[i] : move.aux_end[i - 3] - move.aux_start[i - 3];
        shape.advance[i] = travel / shape.length;
        shape.tangent_start[i] += shape.advance[i];
        shape.tangent_end[i] += shape.advance[i];
        const bool rotary = i >= 3 && i < 6;
        moves_linear = moves_linear || (!rotary && (travel != 0 || shape.swing[i] > 0));
    }
    shape.linear = moves_linear;
    return shape;
}

}  // namespace curvecore::ref
