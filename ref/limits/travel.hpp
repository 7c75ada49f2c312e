// SPDX-License-Identifier: Apache-2.0
// The box that a move needs, and the check against the machine's travel.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <string>

#include "ref/curve/drawn/table_curve.hpp"
#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

struct AxisRange {
    AxisVector low, high;  // mm
};

/// Includes places at which a component of dr/du = 3 a u^2 + 2 b u + c is zero.
inline void include_turns(const Cubic& cubic, AxisRange& range) {
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] =
            boost::math::tools::quadratic_roots(3 * cubic.a[i], 2 * cubic.b[i], cubic.c[i]);
        for (const double u : {low, high}) {
            if (!(u > 0 && u < 1)) continue;  // also without a real zero, which is NaN
            const auto axis = static_cast<std::size_t>(i);
            range.low[axis] = std::min(range.low[axis], cubic.position(u)[i]);
            range.high[axis] = std::max(range.high[axis], cubic.position(u)[i]);
        }
    }
}

/// Includes what a table's curve can reach between two of its places.
inline void include_table(const Move& move, AxisRange& range) {
    constexpr int kPlaces = 64;
    const TableCurve curve(move.table, move.start, move.table_length);
    double from = 0;
    for (const double to : curve.step_ends()) {
        const double gap = (to - from) / kPlaces;
        const double beyond = curve.most_derivative(from, 2) * gap * gap / 8;
        for (int i = 0; gap > 0 && i <= kPlaces; ++i) {
            const Vec3 at = curve.position(from + gap * i);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double place = at[static_cast<Eigen::Index>(axis)];
                range.low[axis] = std::min(range.low[axis], place - beyond);
                range.high[axis] = std::max(range.high[axis], place + beyond);
            }
        }
        from = to;
    }
}

/// Includes what joints can reach between two of their places.
inline void include_joints(const JointPath& of, AxisRange& range) {
    constexpr int kPlaces = 16;
    const double gap = of.length / kPlaces;
    const Vec3 bend = of.joints.most(of.length, 2);
    for (int i = 0; i < kPlaces; ++i) {
        const Vec3 from = of.joints.at(gap * i);
        const Vec3 to = of.joints.at(gap * (i + 1));
        const Vec3 slope = of.joints.derivative(gap * (i + 0.5), 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<Eigen::Index>(axis);
            const bool turns = std::abs(slope[row]) <= bend[row] * gap / 2;
            const double beyond = turns ? bend[row] * gap * gap / 8 : 0;
            range.low[axis] = std::min(range.low[axis], std::min(from[row], to[row]) - beyond);
            range.high[axis] = std::max(range.high[axis], std::max(from[row], to[row]) + beyond);
        }
    }
}

/// Returns the smallest and largest position of every axis. A cubic turns back at most twice per
/// axis. An arc turns back where its tangent has no component along the axis: once or twice per
/// turn.
inline AxisRange travel(const Move& move) {
    AxisRange range;
    for (int i = 0; i < kMachineAxes; ++i) {
        const double from = i < 3 ? move.start[i] : move.aux_start[i - 3];
        const double to = i < 3 ? move.end[i] : move.aux_end[i - 3];
        range.low[i] = std::min(from, to);
        range.high[i] = std::max(from, to);
    }
    if (move.kind == Move::Kind::kCubic) include_turns(move.cubic, range);
    if (move.kind == Move::Kind::kTable) include_table(move, range);
    if (move.kind == Move::Kind::kJoints) include_joints(move.joints, range);
    if (move.kind != Move::Kind::kArc) return range;
    const Vec3 n = move.start - move.centre;
    const Vec3 t = move.normal.cross(n);
    for (int i = 0; i < 3; ++i) {
        const double swing = std::hypot(n[i], t[i]);
        if (swing == 0) continue;
        // d/dangle: t cos - n sin + rise = swing cos(angle + shift) + rise = 0
        const double rise = move.advance[i] / move.angle;
        if (std::abs(rise) >= swing) continue;
        const double shift = std::atan2(n[i], t[i]);
        const double bend = std::acos(-rise / swing);
        for (const double sign : {1.0, -1.0}) {
            double first = std::fmod(sign * bend - shift, 2 * M_PI);
            if (first < 0) first += 2 * M_PI;
            // The extremes of a helix move by a pitch per turn: the first and the last count.
            const double last = first + 2 * M_PI * std::floor((move.angle - first) / (2 * M_PI));
            for (const double angle : {first, last}) {
                if (angle < 0 || angle > move.angle) continue;
                const double x =
                    move.centre[i] + n[i] * std::cos(angle) + t[i] * std::sin(angle) + rise * angle;
                range.low[i] = std::min(range.low[i], x);
                range.high[i] = std::max(range.high[i], x);
            }
        }
    }
    return range;
}

/// Returns the reason why a move is beyond a machine's travel; empty if it is not.
inline std::string beyond_travel(const AxisRange& range, const Move& move, const Machine& machine) {
    constexpr double kSlack = 1e-7;  // mm: rounding of an inch file
    for (int i = 0; i < kMachineAxes; ++i) {
        const AxisLimits& axis = machine.axis[i];
        if (axis.rotary) continue;
        const bool moves = i < 3 || move.aux_start[i - 3] != move.aux_end[i - 3];
        const bool low = range.low[i] < axis.min - kSlack;
        if (moves && (low || range.high[i] > axis.max + kSlack)) {
            const bool joint = i < 3 && move.kind == Move::Kind::kJoints;
            const bool angle = joint && turning(machine.kinematics)[static_cast<std::size_t>(i)];
            const char* unit = angle ? "degrees" : "mm";
            return fmt::format("{} = {:.6g} {} is beyond the machine's travel {:.6g} .. {:.6g} {}",
                               joint ? fmt::format("joint {}", i) : std::string(1, kAxisLetters[i]),
                               low ? range.low[i] : range.high[i], unit, axis.min, axis.max, unit);
        }
    }
    return "";
}

}  // namespace curvecore::ref
