// SPDX-License-Identifier: Apache-2.0
#include "ref/join/idle_move.hpp"

#include "ref/curve/fit/hermite.hpp"
#include "ref/curve/fit/point_slopes.hpp"
#include "ref/join/path_table.hpp"
#include "ref/join/quintic_slopes.hpp"

namespace curvecore::ref {
namespace {

BezierPiece piece_of(const HermitePiece& piece, JoinFit fit) {
    if (fit == JoinFit::kQuintic) {
        const auto points = quintic_points(piece);
        return {piece.h, {points.begin(), points.end()}};
    }
    const Bezier points =
        to_bezier(fit == JoinFit::kMoments ? cubic_of_moments(piece) : cubic_of_slopes(piece));
    return {piece.h, {points.begin(), points.end()}};
}

}  // namespace

BezierPiece::Point BezierPiece::at(double u) const {
    std::vector<Vec3> level = points;
    const auto reduce = [&level, u](std::size_t to) {
        while (level.size() > to) {
            for (std::size_t i = 0; i + 1 < level.size(); ++i) {
                level[i] = (1 - u) * level[i] + u * level[i + 1];
            }
            level.pop_back();
        }
    };
    const int n = degree();
    Point point;
    reduce(3);
    point.d2 = n * (n - 1) / (h * h) * (level[2] - 2 * level[1] + level[0]);
    reduce(2);
    point.d1 = n / h * (level[1] - level[0]);
    reduce(1);
    point.r = level[0];
    return point;
}

std::vector<Vec3> IdleMove::positions() const {
    std::vector<Vec3> all{start.position};
    all.insert(all.end(), points.begin(), points.end());
    all.push_back(end.position);
    return all;
}

std::vector<BezierPiece> IdleMove::pieces() const {
    const Vectors y = positions();
    Vectors m;
    if (fit == JoinFit::kC2) {
        m = smooth_slopes(y, t, {start.tangent}, {end.tangent});
    } else {
        m = bessel_slopes(y, t);  // [Petrakov] (1)
        m.front() = start.tangent;
        m.back() = end.tangent;
    }
    Vectors second = bessel_slopes(m, t);
    second.front() = start.curvature;
    second.back() = end.curvature;
    if (fit == JoinFit::kQuintic) {
        QuinticSlopes slopes = quintic_slopes(y, t, {m, second});
        m = std::move(slopes.m);
        second = std::move(slopes.second);
    }
    std::vector<BezierPiece> found;
    for (std::size_t i = 0; i + 1 < y.size(); ++i) {
        found.push_back(piece_of(
            {t[i + 1] - t[i], y[i], y[i + 1], m[i], m[i + 1], second[i], second[i + 1]}, fit));
    }
    return found;
}

IdleMove default_idle_move(const Joint& start, const Joint& end, JoinFit fit, int count) {
    constexpr int kMostSteps = 60;
    constexpr double kSameShare = 1e-9;
    IdleMove guide;
    guide.start = start;
    guide.end = end;
    guide.start.curvature = guide.end.curvature = Vec3::Zero();
    // Its length grows by less than 0.63 of the growth of t (antiparallel tangents), so this ends.
    double length = (end.position - start.position).norm();
    for (int i = 0; i < kMostSteps; ++i) {
        guide.t = {0, length};
        const double next = PathTable(guide.pieces()).length();
        const bool same = std::abs(next - length) <= kSameShare * length;
        length = next;
        if (same) break;
    }
    guide.t = {0, length};
    const BezierPiece whole = guide.pieces().front();
    IdleMove move{start, end, fit, {}, {}};
    for (int i = 0; i <= count + 1; ++i) {
        const double u = static_cast<double>(i) / (count + 1);
        move.t.push_back(u * length);
        if (i > 0 && i <= count) move.points.push_back(whole.at(u).r);
    }
    return move;
}

}  // namespace curvecore::ref
