// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/point_slopes.hpp"

#include <utility>

namespace curvecore::ref {
namespace {

constexpr double kNoBend = 1e-9;  // relative: a change of slope below this is rounding

struct Chords {
    std::vector<double> d;
    Vectors s;
};

Chords chords(const Vectors& points, const std::vector<double>& t) {
    Chords found;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        found.d.push_back(t[i + 1] - t[i]);
        found.s.emplace_back((points[i + 1] - points[i]) / found.d.back());
    }
    return found;
}

/// A row: below m_{i-1} + diagonal m_i + above m_{i+1} = right.
struct Row {
    double below, diagonal, above;
    Vec3 right;
};

Row smooth_row(double d0, double d1, const Vec3& s0, const Vec3& s1) {
    return {d1, 2 * (d0 + d1), d0, 3 * (s0 * d1 + s1 * d0)};
}

/// Solves rows without corners, diagonally dominant: elimination without pivots.
Vectors solve(std::vector<Row> rows) {
    Vectors m(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row& row = rows[i];
        if (i > 0) {
            row.diagonal -= row.below * rows[i - 1].above;
            row.right -= row.below * rows[i - 1].right;
        }
        row.above /= row.diagonal;
        row.right /= row.diagonal;
    }
    m.back() = rows.back().right;
    for (std::size_t i = rows.size() - 1; i-- > 0;) m[i] = rows[i].right - rows[i].above * m[i + 1];
    return m;
}

}  // namespace

Vectors bessel_slopes(const Vectors& points, const std::vector<double>& t) {
    const auto [d, s] = chords(points, t);
    const std::size_t last = s.size() - 1;
    if (last == 0) return {s[0], s[0]};
    const auto end = [](double near, double far, const Vec3& first, const Vec3& second) {
        return Vec3(((2 * near + far) * first - near * second) / (near + far));
    };
    Vectors m{end(d[0], d[1], s[0], s[1])};
    for (std::size_t i = 1; i <= last; ++i) {
        m.emplace_back((s[i - 1] * d[i] + s[i] * d[i - 1]) / (d[i - 1] + d[i]));
    }
    m.push_back(end(d[last], d[last - 1], s[last], s[last - 1]));
    return m;
}

Vectors akima_slopes(const Vectors& points, const std::vector<double>& t) {
    Vectors s = chords(points, t).s;
    if (s.size() == 1) return {s[0], s[0]};
    for (int i = 0; i < 2; ++i) {
        s.insert(s.begin(), Vec3(2 * s[0] - s[1]));
        s.emplace_back(2 * s[s.size() - 1] - s[s.size() - 2]);
    }
    Vectors m;
    for (std::size_t i = 2; i + 1 < s.size(); ++i) {  // s[i] begins at point i - 2
        const double before = (s[i + 1] - s[i]).norm();
        const double behind = (s[i - 1] - s[i - 2]).norm();
        const double sum = before + behind;
        if (sum <= kNoBend * (s[i - 1].norm() + s[i].norm())) {
            m.emplace_back((s[i - 1] + s[i]) / 2);
        } else {
            m.emplace_back((before * s[i - 1] + behind * s[i]) / sum);
        }
    }
    return m;
}

Vectors smooth_slopes(const Vectors& points, const std::vector<double>& t, const SplineEnd& start,
                      const SplineEnd& end) {
    const auto [d, s] = chords(points, t);
    const std::size_t last = s.size();
    std::vector<Row> rows;
    if (start.slope) {
        rows.push_back({0, 1, 0, *start.slope});
    } else {
        rows.push_back({0, 2, 1, 3 * s[0] - d[0] / 2 * start.second});
    }
    for (std::size_t i = 1; i < last; ++i)
        rows.push_back(smooth_row(d[i - 1], d[i], s[i - 1], s[i]));
    if (end.slope) {
        rows.push_back({0, 1, 0, *end.slope});
    } else {
        rows.push_back({1, 2, 0, 3 * s[last - 1] + d[last - 1] / 2 * end.second});
    }
    return solve(std::move(rows));
}

Vectors closed_slopes(const Vectors& points, const std::vector<double>& t) {
    const auto [d, s] = chords(points, t);
    const std::size_t count = s.size();
    std::vector<Row> rows{smooth_row(d[count - 1], d[0], s[count - 1], s[0])};
    for (std::size_t i = 1; i < count; ++i) {
        rows.push_back(smooth_row(d[i - 1], d[i], s[i - 1], s[i]));
    }
    // The first row's neighbour below is the last, the last row's neighbour above the first: two
    // corners of the matrix, taken out as a product of two vectors (Sherman and Morrison).
    const double below = rows.front().below;
    const double above = rows.back().above;
    const double pivot = -rows.front().diagonal;
    rows.front().diagonal -= pivot;
    rows.back().diagonal -= above * below / pivot;
    std::vector<Row> corners = rows;
    for (Row& row : corners) row.right = Vec3::Zero();
    corners.front().right = Vec3::Constant(pivot);
    corners.back().right = Vec3::Constant(above);
    Vectors m = solve(std::move(rows));
    const Vectors z = solve(std::move(corners));
    const Vec3 share =
        (m.front() + below / pivot * m.back()) / (1 + z.front().x() + below / pivot * z.back().x());
    for (std::size_t i = 0; i < count; ++i) m[i] -= z[i].x() * share;
    m.push_back(m.front());
    return m;
}

}  // namespace curvecore::ref
