// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/move_part.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/arc_length.hpp"
#include "ref/curve/drawn/table_curve.hpp"

namespace curvecore::ref {
namespace {

MovePlace on_cubic(const Cubic& cubic, double s) {
    const double u = parameter_at(cubic, s);
    return {cubic.position(u), tangent(cubic, u), curvature_vector(cubic, u)};
}

/// Place counted from the start, so that a far centre costs no digits.
MovePlace on_arc(const Move& move, double s) {
    const double length = move.length();
    const double twist = move.angle / length;
    const double sine = std::sin(twist * s);
    const double cosine = std::cos(twist * s);
    const double half = std::sin(twist * s / 2);
    const Vec3 arm = move.start - move.centre;
    const Vec3 forward = move.normal.cross(arm);
    const Vec3 rise = move.advance / length;
    return {move.start + sine * forward - 2 * half * half * arm + s * rise,
            twist * (cosine * forward - sine * arm) + rise,
            -twist * twist * (cosine * arm + sine * forward)};
}

}  // namespace

MovePlace MovePlace::by_length() const {
    const double squared = tangent.squaredNorm();
    const Vec3 across = curvature - tangent * (tangent.dot(curvature) / squared);
    return {position, tangent / std::sqrt(squared), across / squared};
}

MovePlace place_on(const Move& move, double s) {
    if (move.kind == Move::Kind::kCubic) return on_cubic(move.cubic, s);
    if (move.kind == Move::Kind::kArc) return on_arc(move, s);
    if (move.kind == Move::Kind::kTable) {
        const TableCurve curve(move.table, move.start, move.table_length);
        return {curve.position(s), curve.direction(s), curve.bend(s)};
    }
    if (move.kind == Move::Kind::kJoints) {
        const auto& joints = move.joints.joints;
        return {joints.at(s), joints.derivative(s, 1), joints.derivative(s, 2)};
    }
    MovePlace place;
    place.tangent = (move.end - move.start).normalized();
    place.position = move.start + s * place.tangent;
    return place;
}

Move part_of(const Move& move, double from, double to) {
    const double length = move.length();
    const double share = (to - from) / length;
    const double asked = (move.to - move.from) / length;
    Move part = move;
    part.from += asked * from;
    if (to < length) part.to = move.from + asked * to;
    const bool still = move.kind == Move::Kind::kLine && move.start == move.end;
    const auto at = [&](double s) { return still ? move.start : place_on(move, s).position; };
    if (from > 0) part.start = at(from);
    if (move.kind == Move::Kind::kCubic) {
        const double u0 = from > 0 ? parameter_at(move.cubic, from) : 0;
        part.cubic = sub_cubic(move.cubic, u0, to < length ? parameter_at(move.cubic, to) : 1);
    }
    if (move.kind == Move::Kind::kTable) {
        const TableCurve curve(move.table, move.start, move.table_length);
        if (from > 0) part.table = curve.piece_at(from);
        part.table_length = to - from;
    }
    if (move.kind == Move::Kind::kJoints) part.joints = move.joints.part(from, to);
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        const double rate = (move.aux_end[i] - move.aux_start[i]) / length;
        if (from > 0) part.aux_start[i] = move.aux_start[i] + rate * from;
        if (to < length) part.aux_end[i] = move.aux_start[i] + rate * to;
    }
    part.centre += from / length * move.advance;
    part.angle *= share;
    part.advance *= share;
    if (to < length) {
        part.end = at(to);
        part.exact_stop = false;
        part.dwell = 0;
    }
    return part;
}

}  // namespace curvecore::ref
