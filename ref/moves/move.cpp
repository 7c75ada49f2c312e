// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/move.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/curve/arc_length.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

/// Largest component of an arc's advance along its circle: p cos - q sin over the angles.
double most_along(const Move& move) {
    const Vec3 outward = (move.start - move.centre).normalized();
    const double p = move.normal.cross(outward).dot(move.advance);
    const double q = outward.dot(move.advance);
    if (p == 0 && q == 0) return 0;
    const double peak = std::atan2(-q, p);
    if ((peak < 0 ? peak + 2 * M_PI : peak) <= move.angle) return std::hypot(p, q);
    return std::max(p, p * std::cos(move.angle) - q * std::sin(move.angle));
}

/// Greatest |dr/du| of r(u), u = 0 .. 1: dr/du = R angle t + advance.
double arc_length_of(const Move& move) {
    const double along = most_along(move);
    const double across = std::max(0.0, move.advance.squaredNorm() - along * along);
    return std::hypot((move.start - move.centre).norm() * move.angle + along, std::sqrt(across));
}

}  // namespace

double Move::length() const {
    if (kind == Kind::kArc) return arc_length_of(*this);
    if (kind == Kind::kCubic) {
        return arc_length(cubic, 0, 1);
    }
    if (kind == Kind::kTable) return table_length;
    if (kind == Kind::kJoints) return joints.length;
    const double xyz = (end - start).norm();
    if (xyz > 0) {
        return xyz;
    }
    const auto travel = [this](int first) {
        return std::hypot(aux_end[first] - aux_start[first],
                          aux_end[first + 1] - aux_start[first + 1],
                          aux_end[first + 2] - aux_start[first + 2]);
    };
    const double uvw = travel(3);
    return uvw > 0 ? uvw : travel(0);
}

double fastest_motion(const Move& move) {
    const bool linear = move.aux_start == move.aux_end;  // else an axis may outrun the path
    return linear && !move.rapid && move.feed > 0 ? move.feed : kUnlimitedSpeed;
}

double least_time(const Move& move, double fastest) {
    const bool fed = !move.rapid && move.feed > 0;
    return move.length() / (fed ? std::min(move.feed, fastest) : fastest);
}

}  // namespace curvecore::ref
