// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/rational_bezier.hpp"

#include <algorithm>

namespace curvecore::ref {
namespace {

Vec3 project(const Eigen::Vector4d& point) { return point.head<3>() / point[3]; }

}  // namespace

RationalBezier::Point RationalBezier::at(double t) const {
    std::vector<Eigen::Vector4d> level = points;
    for (std::size_t left = level.size() - 1; left > 1; --left) {
        for (std::size_t i = 0; i < left; ++i) {
            level[i] = (1 - t) * level[i] + t * level[i + 1];
        }
    }
    const Eigen::Vector4d sum = (1 - t) * level[0] + t * level[1];
    const Eigen::Vector4d slope = degree() * (level[1] - level[0]);
    const Vec3 position = project(sum);
    return {origin + position, (slope.head<3>() - slope[3] * position) / sum[3]};
}

bool RationalBezier::polynomial() const {
    return std::all_of(points.begin(), points.end(),
                       [this](const Eigen::Vector4d& point) { return point[3] == points[0][3]; });
}

Cubic RationalBezier::exact_cubic() const {
    const Vec3 first = project(points.front());
    const Vec3 last = project(points.back());
    Bezier bezier{first, first, last, last};
    if (degree() == 1) {
        bezier[1] = first + (last - first) / 3;
        bezier[2] = last - (last - first) / 3;
    } else if (degree() == 2) {
        const Vec3 middle = project(points[1]);
        bezier[1] = first + 2 * (middle - first) / 3;
        bezier[2] = last + 2 * (middle - last) / 3;
    } else {
        bezier[1] = project(points[1]);
        bezier[2] = project(points[2]);
    }
    Cubic cubic = from_bezier(bezier);
    cubic.d += origin;
    return cubic;
}

}  // namespace curvecore::ref
