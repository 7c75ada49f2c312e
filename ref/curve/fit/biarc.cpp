// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/biarc.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace curvecore::ref {

double TangentArc::length() const { return angle > 0 ? radius * angle : (end - start).norm(); }

Vec3 TangentArc::at(double s) const {
    if (angle == 0) return start + tangent * s;
    const double half = s / (2 * radius);
    return start +
           (tangent * std::cos(half) + inward * std::sin(half)) * (2 * radius * std::sin(half));
}

TangentArc straight(const Vec3& start, const Vec3& end) {
    TangentArc line;
    line.start = start;
    line.end = end;
    line.tangent = (end - start).normalized();
    return line;
}

TangentArc tangent_arc(const Vec3& start, const Vec3& tangent, const Vec3& end) {
    const Vec3 chord = end - start;
    const double along = chord.dot(tangent);
    const Vec3 across = chord - tangent * along;
    const double height = across.norm();
    // The tangent leaves the chord by half the angle, so the arc rises by a quarter of `height`.
    if (height < 4 * kFlatRise && along > 0) return straight(start, end);
    TangentArc arc;
    arc.start = start;
    arc.end = end;
    arc.tangent = tangent;
    arc.inward = across / height;
    arc.radius = chord.squaredNorm() / (2 * height);
    arc.angle = 2 * std::atan2(height, along);
    return arc;
}

std::optional<std::array<TangentArc, 2>> biarc(const Vec3& start, const Vec3& out, const Vec3& end,
                                               const Vec3& in) {
    const Vec3 v = end - start;
    if (!(v.dot(out) > 0 && v.dot(in) > 0 && out.dot(in) > 0)) return std::nullopt;
    const double b = v.dot(out + in);
    const double d =
        v.squaredNorm() / (b + std::sqrt(b * b + 2 * (1 - out.dot(in)) * v.squaredNorm()));
    const Vec3 q0 = start + d * out;
    const Vec3 q1 = end - d * in;
    const Vec3 middle = (q0 + q1) / 2;
    const Vec3 tangent = (q1 - q0).normalized();
    return {{tangent_arc(start, out, middle), tangent_arc(middle, tangent, end)}};
}

}  // namespace curvecore::ref
