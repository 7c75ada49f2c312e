// SPDX-License-Identifier: Apache-2.0
// The path's derivatives against differences of the exact curve.
#include "ref/feed/places/path_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace curvecore::tb::path_places_test {

using ref::AxisVector;
using ref::Move;
using ref::PathPlace;
using ref::Vec3;

/// Positions of all axes at s of the move, by independent formulas.
AxisVector position(const Move& move, double s) {
    const double length = move.length();
    Vec3 at = move.start + (move.end - move.start) * (s / length);
    if (move.kind == Move::Kind::kArc) {
        const Vec3 arm = move.start - move.centre;
        const double angle = move.angle * s / length;
        at = move.centre + arm * std::cos(angle) + move.normal.cross(arm) * std::sin(angle) +
             move.advance * s / length;
    } else if (move.kind == Move::Kind::kCubic) {
        at = move.cubic.position(ref::parameter_at(move.cubic, s));
    }
    AxisVector all{at.x(), at.y(), at.z()};
    for (std::size_t i = 0; i < ref::kAuxAxes; ++i) {
        all[3 + i] = move.aux_start[i] + (move.aux_end[i] - move.aux_start[i]) * s / length;
    }
    return all;
}

void expect_derivatives(const Move& move) {
    ref::Program program;
    program.moves = {move};
    program.aux_axes = ref::kAuxAxes;
    ref::PlanOptions options;
    const ref::Geometry geometry = make_geometry(program, ref::Machine(), options);
    ref::PathPlaces places(program, geometry, options.unit_mm);
    const double h = move.length() * 2e-3;
    double begin = 0;
    for (std::size_t i = 0; i < geometry.moves.size(); ++i) {
        const double length = geometry.moves[i].shape.length;
        const double s = begin + length * 0.4;
        const PathPlace place = places.at(i, length * 0.4);
        const AxisVector far_before = position(move, s - 2 * h);
        const AxisVector before = position(move, s - h);
        const AxisVector here = position(move, s);
        const AxisVector after = position(move, s + h);
        const AxisVector far_after = position(move, s + 2 * h);
        for (std::size_t axis = 0; axis < ref::kMachineAxes; ++axis) {
            const double d1 =
                (far_before[axis] - 8 * before[axis] + 8 * after[axis] - far_after[axis]) /
                (12 * h);
            const double d2 = (after[axis] - 2 * here[axis] + before[axis]) / (h * h);
            const double d3 =
                (far_after[axis] - 2 * after[axis] + 2 * before[axis] - far_before[axis]) /
                (2 * h * h * h);
            EXPECT_NEAR(place.d1[axis], d1, 1e-6) << axis;
            EXPECT_NEAR(place.d2[axis], d2, 1e-4) << axis;
            EXPECT_NEAR(place.d3[axis], d3, 1e-3) << axis;
        }
        begin += length;
    }
}

TEST(PathPlaces, OfALine) {
    Move move;
    move.end = Vec3(10, -4, 3);
    move.aux_end[0] = 7;
    expect_derivatives(move);
}

TEST(PathPlaces, OfAHelixInAnyPlane) {
    Move move;
    move.kind = Move::Kind::kArc;
    move.normal = Vec3(1, 2, 2) / 3;
    move.start = Vec3(5, 1, 0);
    move.centre = move.start + 4 * Vec3(2, 1, -2) / 3;
    move.angle = 2.5;
    move.advance = 3 * move.normal + Vec3(0.3, 0.3, -0.4);  // with a part in its plane
    const Vec3 arm = move.start - move.centre;
    move.end =
        move.centre + arm * std::cos(2.5) + move.normal.cross(arm) * std::sin(2.5) + move.advance;
    move.aux_end[1] = -2;
    expect_derivatives(move);
}

TEST(PathPlaces, OfACubic) {
    Move move;
    move.kind = Move::Kind::kCubic;
    move.cubic = ref::from_bezier({Vec3(0, 0, 0), {6, 1, 0}, {9, 8, 3}, {20, 10, 5}});
    move.end = Vec3(20, 10, 5);
    move.aux_end[2] = 4;
    expect_derivatives(move);
}

}  // namespace curvecore::tb::path_places_test
