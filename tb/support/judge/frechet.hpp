// SPDX-License-Identifier: Apache-2.0
// Distance of two paths when both are walked from end to end without turning back: Frechet's
// distance of polylines, by the free space of Alt and Godau (1995).
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "ref/moves/move_part.hpp"

namespace curvecore::tb {

using Polyline = std::vector<ref::Vec3>;

/// Moves as chords with an error of at most `error`.
inline Polyline polyline(const std::vector<ref::Move>& moves, double error) {
    Polyline points{moves.front().start};
    for (const ref::Move& move : moves) {
        int count = 1;
        if (move.kind == ref::Move::Kind::kArc) {
            const double radius = (move.start - move.centre).norm();
            count = 1 + static_cast<int>(move.angle * std::sqrt(radius / error / 8));
        } else if (move.kind == ref::Move::Kind::kCubic) {
            const double bend =
                std::max(move.cubic.acceleration(0).norm(), move.cubic.acceleration(1).norm());
            count = 1 + static_cast<int>(std::sqrt(bend / error / 8));
        }
        const double length = move.length();
        for (int i = 1; i <= count; ++i) {
            const double part = static_cast<double>(i) / count;
            points.push_back(move.kind == ref::Move::Kind::kCubic
                                 ? move.cubic.position(part)
                                 : ref::place_on(move, part * length).position);
        }
    }
    return points;
}

/// A part of a segment.
struct Reach {
    double low = 1;
    double high = 0;
    bool empty() const { return low > high; }
};

/// Part of the segment a, b within `far` of the point.
inline Reach within(const ref::Vec3& point, const ref::Vec3& a, const ref::Vec3& b, double far) {
    const ref::Vec3 way = b - a;
    const double square = way.squaredNorm();
    if (square == 0) return (a - point).norm() <= far ? Reach{0, 1} : Reach{};
    const double middle = way.dot(point - a) / square;
    const double rest = far * far - (a + middle * way - point).squaredNorm();
    if (rest < 0) return {};
    const double half = std::sqrt(rest / square);
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

inline bool frechet_within(const Polyline& p, const Polyline& q, double far) {
    if ((p.front() - q.front()).norm() > far || (p.back() - q.back()).norm() > far) return false;
    std::map<std::size_t, Reach> left{{0, within(p[0], q[0], q[1], far)}};  // of q's segments
    if (left[0].low > 0) return false;
    Reach start{0, 0};  // of p's segment along q's first point
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        std::map<std::size_t, Reach> right;
        Reach below = within(q[0], p[i], p[i + 1], far);
        if (start.empty() || below.low > 0) below = {};
        start = below.high >= 1 ? Reach{0, 0} : Reach{};
        std::size_t j = below.empty() && !left.empty() ? left.begin()->first : 0;
        while (j + 1 < q.size()) {
            const auto found = left.find(j);
            const Reach from = found == left.end() ? Reach{} : found->second;
            Reach out = within(p[i + 1], q[j], q[j + 1], far);
            Reach up = within(q[j + 1], p[i], p[i + 1], far);
            if (below.empty()) out.low = std::max(out.low, from.low);
            if (from.empty()) up.low = std::max(up.low, below.low);
            if (below.empty() && from.empty()) out = up = {};
            if (!out.empty()) right[j] = out;
            below = up;
            if (++j + 1 >= q.size()) break;
            if (!below.empty()) continue;
            const auto next = left.lower_bound(j);
            if (next == left.end()) break;
            j = next->first;
        }
        left = std::move(right);
        if (left.empty() && start.empty()) return false;
    }
    const auto last = left.find(q.size() - 2);
    return last != left.end() && last->second.high >= 1;
}

/// Frechet's distance, to a thousandth of `scale`, below which it is searched; beyond it, infinite.
inline double frechet(const Polyline& p, const Polyline& q, double scale) {
    if (!frechet_within(p, q, scale)) return HUGE_VAL;
    double low = 0;
    double high = scale;
    while (high - low > 1e-3 * scale) {
        const double middle = (low + high) / 2;
        (frechet_within(p, q, middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace curvecore::tb
