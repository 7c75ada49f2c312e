// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/point_slopes.hpp"

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

Vectors smooth_slopes(const Vectors& points, const std::vector<double>& t,
                      const std::optional<Vec3>& start, const std::optional<Vec3>& end) {
    const auto [d, s] = chords(points, t);
    const std::size_t last = s.size();
    // below m_{i-1} + diagonal m_i + above m_{i+1} = right; diagonally dominant.
    std::vector<double> above(last + 1, 0);
    Vectors m(last + 1);
    double diagonal = start ? 1 : 2;
    above[0] = start ? 0 : 1 / diagonal;
    m[0] = start ? *start : Vec3(3 * s[0] / diagonal);
    for (std::size_t i = 1; i < last; ++i) {
        const double below = d[i];
        diagonal = 2 * (d[i - 1] + d[i]) - below * above[i - 1];
        above[i] = d[i - 1] / diagonal;
        m[i] = (3 * (s[i - 1] * d[i] + s[i] * d[i - 1]) - below * m[i - 1]) / diagonal;
    }
    m[last] = end ? *end : Vec3((3 * s[last - 1] - m[last - 1]) / (2 - above[last - 1]));
    for (std::size_t i = last; i-- > 0;) m[i] -= above[i] * m[i + 1];
    return m;
}

}  // namespace curvecore::ref
