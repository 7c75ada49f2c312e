// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/path_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

/// Largest |t cos x - n sin x + advance| over 0 <= x <= angle.
double largest_rate(double t, double n, double advance, double angle) {
    const auto at = [&](double x) { return std::abs(t * std::cos(x) - n * std::sin(x) + advance); };
    double largest = std::max(at(0), at(angle));
    const double phase = std::atan2(n, t);
    const double first = std::ceil(phase / M_PI);  // first extremum, at k pi - phase
    for (const double k : {first, first + 1}) {
        if (k * M_PI - phase > angle) break;
        const double amplitude = std::hypot(t, n);
        largest =
            std::max(largest, std::abs((std::fmod(k, 2) == 0 ? 1 : -1) * amplitude + advance));
    }
    return largest;
}

}  // namespace

PathShape path_shape(const Move& move, double from, double to) {
    PathShape shape;
    const double length = move.length();
    if (!(length > 0)) return shape;
    double fastest = 0;
    for (int i = 0; i < kAuxAxes; ++i) {
        fastest = std::max(fastest, std::abs(move.aux_end[i] - move.aux_start[i]));
    }
    shape.length = std::max(length, fastest / kMostAxisRate);
    shape.rate = length / shape.length;

    Vec3 axial = move.end - move.start;
    if (move.kind == Move::Kind::kArc) {
        axial = move.advance;
        shape.drift = (axial - move.normal * move.normal.dot(axial)).norm() / shape.length;
        const Vec3 arm = move.start - move.centre;
        const double radius = arm.norm();
        const Vec3 out = arm / radius;  // start of the move
        const Vec3 on = move.normal.cross(out);
        const double begin = move.angle * from;
        const Vec3 n = out * std::cos(begin) + on * std::sin(begin);
        const Vec3 t = on * std::cos(begin) - out * std::sin(begin);
        shape.turn = radius * move.angle / shape.length;
        shape.twist = move.angle / shape.length;
        shape.curvature = shape.turn * shape.twist;
        const double angle = move.angle * (to - from);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const Vec3 t_end = t * c - n * s;
        for (int i = 0; i < 3; ++i) {
            shape.swing[i] = std::min(1.0, std::hypot(t[i], n[i]));
            shape.tangent_start[i] = shape.turn * t[i];
            shape.tangent_end[i] = shape.turn * t_end[i];
            shape.along[i] =
                largest_rate(shape.turn * t[i], shape.turn * n[i], axial[i] / shape.length, angle);
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
        if (shape.turn == 0 || i >= 3) shape.along[i] = std::abs(shape.advance[i]);
        const bool rotary = i >= 3 && i < 6;
        moves_linear = moves_linear || (!rotary && (travel != 0 || shape.swing[i] > 0));
    }
    shape.linear = moves_linear;
    shape.length *= to - from;
    return shape;
}

}  // namespace curvecore::ref
