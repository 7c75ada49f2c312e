// SPDX-License-Identifier: Apache-2.0
// Idle moves whose jumps have a closed form.
#pragma once

#include <algorithm>

#include "ref/join/jumps.hpp"

namespace curvecore::tb {

using ref::Vec3;

constexpr double kSlowFeed = 25;  // mm/s: 1.5 m/min

/// A turn between antiparallel lines at a step-over w; k: length of the end tangents.
inline ref::IdleMove u_turn(ref::JoinFit fit, double w, double k) {
    ref::IdleMove move;
    move.start = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3::Zero()}, kSlowFeed};
    move.end = {{Vec3(0, w, 0), Vec3(-1, 0, 0), Vec3::Zero()}, kSlowFeed};
    move.fit = fit;
    move.t = {0, k};
    return move;
}

/// A move from y = 0 to w over x = 0 .. l, x being the parameter.
inline ref::IdleMove lane_change(ref::JoinFit fit, double w, double l, int points) {
    ref::IdleMove move = u_turn(fit, w, l);
    move.end = {{Vec3(l, w, 0), Vec3(1, 0, 0), Vec3::Zero()}, kSlowFeed};
    move.t = {0};
    for (int i = 1; i <= points; ++i) {
        move.t.push_back(l * i / (points + 1));
        move.points.emplace_back(move.t.back(), w * i / (points + 1), 0);
    }
    move.t.push_back(l);
    return move;
}

/// The U-turn through control points, as `join` places them.
inline ref::IdleMove u_turn_through(ref::JoinFit fit, double w, int points) {
    const ref::IdleMove ends = u_turn(fit, w, w);
    return ref::default_idle_move(ends.start, ends.end, fit, points);
}

inline double peak_curvature(const ref::IdleMove& move) {
    constexpr int kPlaces = 4000;
    const ref::PathTable path(move.pieces());
    double peak = 0;
    for (int i = 0; i <= kPlaces; ++i) {
        peak = std::max(peak, path.at(path.length() * i / kPlaces).curvature.norm());
    }
    return peak;
}

}  // namespace curvecore::tb
