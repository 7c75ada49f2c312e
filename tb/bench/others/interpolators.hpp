// SPDX-License-Identifier: Apache-2.0
// Curves as other interpolators draw them, at a constant commanded speed, in exact arithmetic: the
// figures show the method, without the rounding of any controller.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ref/series/figures.hpp"
#include "ref/series/spline_methods.hpp"
#include "tb/bench/others/drawn_curve.hpp"

namespace curvecore::tb {

/// | field     | unit | remark                                                     |
/// |-----------|------|------------------------------------------------------------|
/// | positions | mm   | one per sample, at s = 0, ds, 2 ds .. of commanded path    |
/// | bits      | bit  | that a host sends for the whole curve                      |
struct Drawing {
    std::vector<ref::Vec3> positions;
    double bits = 0;
};

constexpr double kChordBits = 4 * 32;   // X Y Z of its end and a speed
constexpr double kCubicBits = 13 * 32;  // four coefficients of X Y Z and a time

/// Distance of the curve from its chord.
inline double stray(const DrawnCurve& curve, double from, double to) {
    const ref::Vec3 start = curve.position(from);
    const ref::Vec3 chord = (curve.position(to) - start).normalized();
    double most = 0;
    for (int i = 1; i < 16; ++i) {
        const ref::Vec3 arm = curve.position(from + (to - from) * i / 16) - start;
        most = std::max(most, (arm - chord * arm.dot(chord)).norm());
    }
    return most;
}

/// Path lengths 0 .. length between the longest chords that stray by `tolerance` (grblHAL's arc
/// tolerance, for curves of any kind).
inline std::vector<double> chords_of_tolerance(const DrawnCurve& curve, double tolerance) {
    std::vector<double> ends{0};
    while (ends.back() < curve.length()) {
        const double from = ends.back();
        double good = from;
        double bad = std::min(from + curve.length() / 4, curve.length());
        if (stray(curve, from, bad) <= tolerance) good = bad;
        while (bad - good > 1e-9 * curve.length()) {
            const double middle = (good + bad) / 2;
            (stray(curve, from, middle) <= tolerance ? good : bad) = middle;
        }
        ends.push_back(good);
    }
    return ends;
}

/// Returns chords of one length, as many as fit the curve (Klipper's arcs).
inline std::vector<double> chords_of_length(const DrawnCurve& curve, double length) {
    const int chords = std::max(1, static_cast<int>(curve.length() / length));
    std::vector<double> ends;
    for (int i = 0; i <= chords; ++i) ends.push_back(curve.length() * i / chords);
    return ends;
}

/// Walks the polygon through `corners` at ds per sample.
inline std::vector<ref::Vec3> walk(const std::vector<ref::Vec3>& corners, double ds) {
    std::vector<ref::Vec3> positions;
    double into = 0;  // of the side
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const ref::Vec3 side = corners[i + 1] - corners[i];
        for (; into < side.norm(); into += ds) {
            positions.push_back(corners[i] + side * (into / side.norm()));
        }
        into -= side.norm();
    }
    return positions;
}

inline Drawing draw_chords(const DrawnCurve& curve, const std::vector<double>& ends, double ds) {
    std::vector<ref::Vec3> corners;
    for (const double s : ends) corners.push_back(curve.position(s));
    return {walk(corners, ds), kChordBits * static_cast<double>(ends.size() - 1)};
}

/// Draws the papers' baseline: their network's variables integrated once per `tick` mm of path by
/// Runge-Kutta of order 4 (on a circle the Taylor series of order 4), a chord from tick to tick.
/// The host sends one start. [Chikurov] (19), (30).
inline Drawing draw_runge_kutta(const DrawnCurve& curve, double tick, double ds, double bits) {
    std::vector<ref::Vec3> corners{curve.position(0)};
    const int ticks = static_cast<int>(curve.length() / tick);
    if (curve.circle()) {
        using Network = ref::NetworkInterpreter<double, ref::kSpherical.size(), 1>;
        Network network(ref::kSpherical, 4, {1 / curve.radius()});
        Network::State state{curve.radius(), 0, 0, curve.radius(), 0, 0};
        for (int n = 0; n < ticks; ++n) {
            state = network.step(state, tick);
            corners.emplace_back(state[0], state[2], state[4]);
        }
    } else {
        ref::SplineFollower<double> follower(curve.cubic(), ref::SplineMethod::kRungeKutta, 4, 0);
        for (int n = 0; n < ticks; ++n) {
            follower.step(tick);
            const auto at = follower.position();
            corners.emplace_back(at[0], at[1], at[2]);
            // A curve that has blown up is not measured.
            if (!(corners.back().norm() < 1e6)) break;
        }
    }
    return {walk(corners, ds), bits};
}

/// Draws cubics in time by forward differences, with the curve's positions and velocities at both
/// ends of each, all of one duration; their number is what `bits` allow.
inline Drawing draw_forward_differences(const DrawnCurve& curve, double bits, double ds) {
    const int pieces = std::max(1, static_cast<int>(bits / kCubicBits));
    const double length = curve.length() / pieces;
    Drawing drawing{{}, pieces * kCubicBits};
    for (int n = 0; n * ds <= curve.length(); ++n) {
        const int piece = std::min(pieces - 1, static_cast<int>(n * ds / length));
        const double t = n * ds / length - piece;
        const double from = piece * length;
        const double to = from + length;
        drawing.positions.push_back((1 + 2 * t) * (1 - t) * (1 - t) * curve.position(from) +
                                    t * t * (3 - 2 * t) * curve.position(to) +
                                    t * (1 - t) * length *
                                        ((1 - t) * curve.tangent(from) - t * curve.tangent(to)));
    }
    return drawing;
}

}  // namespace curvecore::tb
