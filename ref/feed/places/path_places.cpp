// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/places/path_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

void put(const Vec3& xyz, AxisVector& all) {
    for (std::size_t i = 0; i < 3; ++i) all[i] = xyz[static_cast<Eigen::Index>(i)];
}

void put_aux(const Move& move, double length, PathPlace& place) {
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        place.d1[3 + i] = (move.aux_end[i] - move.aux_start[i]) / length;
    }
}

double dot(const AxisVector& a, const AxisVector& b, std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

PlaceLimits place_limits(const PathPlace& at, const PathShape& shape, const Machine& machine) {
    PlaceLimits limits;
    const auto add = [&](std::size_t from, std::size_t to, double acceleration, double jerk) {
        const auto product = [&](const AxisVector& a, const AxisVector& b) {
            return dot(a, b, from, to);
        };
        limits.push_back({product(at.d1, at.d1), product(at.d1, at.d2), product(at.d1, at.d3),
                          product(at.d2, at.d2), product(at.d2, at.d3), product(at.d3, at.d3),
                          acceleration, jerk});
    };
    const bool xyz = dot(at.d1, at.d1, 0, 3) > 0;
    if (shape.linear && shape.tool) {
        const auto& [r1, r2, r3] = at.tool;
        limits.push_back({r1.dot(r1), r1.dot(r2), r1.dot(r3), r2.dot(r2), r2.dot(r3), r3.dot(r3),
                          machine.acceleration, machine.jerk});
    } else if (shape.linear) {
        add(xyz ? 0 : 6, xyz ? 3 : 9, machine.acceleration, machine.jerk);
    }
    for (std::size_t i = 0; i < kMachineAxes; ++i) {
        const AxisLimits& axis = machine.axis[i];
        const bool implied = !shape.tool && i < 3 && axis.acceleration >= machine.acceleration &&
                             axis.jerk >= machine.jerk;
        const bool moves = shape.swing[i] != 0 || shape.advance[i] != 0;
        if (!implied && moves) add(i, i + 1, axis.acceleration, axis.jerk);
    }
    return limits;
}

PathPlaces::PathPlaces(const Program& program, const Geometry& geometry, double unit_mm)
    : program_(program), geometry_(geometry) {
    double begin = 0;
    for (std::size_t i = 0; i < geometry.moves.size(); ++i) {
        const bool same = i > 0 && geometry.moves[i].move == geometry.moves[i - 1].move;
        if (!same) begin = 0;
        begin_.push_back(begin);
        begin += static_cast<double>(geometry.moves[i].length) * kQuantum * unit_mm;
    }
}

PathPlace PathPlaces::at(std::size_t planned, double s) {
    const PlannedMove& part = geometry_.moves[planned];
    const Move& move = program_.moves[part.move];
    if (move.kind == Move::Kind::kArc) return on_arc(move, part.shape, begin_[planned] + s);
    if (move.kind == Move::Kind::kCubic) return on_spline(move, begin_[planned] + s);
    if (move.kind == Move::Kind::kTable) return on_table(move, begin_[planned] + s);
    if (move.kind == Move::Kind::kJoints) {
        return on_joints(move.joints, part.shape, begin_[planned] + s);
    }
    PathPlace place;
    place.d1 = part.shape.advance;
    return place;
}

/// Place on an arc: r = .. + turn / twist (n cos(twist s) + t sin(twist s)) + advance s.
PathPlace PathPlaces::on_arc(const Move& move, const PathShape& shape, double s) const {
    const Vec3 n = (move.start - move.centre).normalized();
    const Vec3 t = move.normal.cross(n);
    const double c = std::cos(shape.twist * s);
    const double sine = std::sin(shape.twist * s);
    const Vec3 along = t * c - n * sine;
    PathPlace place;
    put(shape.turn * along, place.d1);
    for (std::size_t i = 0; i < kMachineAxes; ++i) place.d1[i] += shape.advance[i];
    put(-shape.curvature * (n * c + t * sine), place.d2);
    put(-shape.curvature * shape.twist * along, place.d3);
    return place;
}

PathPlace PathPlaces::on_spline(const Move& move, double s) {
    if (tabled_ != &move) {
        tabled_ = &move;
        length_ = std::make_unique<ArcLength>(move.cubic);
    }
    const double u = length_->parameter(std::clamp(s, 0.0, length_->length()));
    PathPlace place;
    put(tangent(move.cubic, u), place.d1);
    put(curvature_vector(move.cubic, u), place.d2);
    put(curvature_rate(move.cubic, u), place.d3);
    put_aux(move, length_->length(), place);
    return place;
}

PathPlace PathPlaces::on_joints(const JointPath& of, const PathShape& shape, double s) const {
    PathPlace place;
    place.d1 = shape.advance;
    AxisVector* const all[] = {&place.d1, &place.d2, &place.d3};
    for (int n = 1; n <= 3; ++n) {
        const auto at = static_cast<std::size_t>(n - 1);
        put(of.joints.derivative(s, n), *all[at]);
        place.tool[at] = of.tool.derivative(s, n);
    }
    return place;
}

PathPlace PathPlaces::on_table(const Move& move, double s) {
    if (tabled_ != &move) {
        tabled_ = &move;
        curve_ = std::make_unique<TableCurve>(move.table, move.start, move.table_length);
    }
    PathPlace place;
    put(curve_->direction(s), place.d1);
    put(curve_->bend(s), place.d2);
    put(curve_->bend_rate(s), place.d3);
    put_aux(move, move.table_length, place);
    return place;
}

}  // namespace curvecore::ref
