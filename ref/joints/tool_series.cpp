// SPDX-License-Identifier: Apache-2.0
#include "ref/joints/tool_series.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/arc_length.hpp"
#include "ref/moves/move_part.hpp"

namespace curvecore::ref {
namespace {

using Place = std::array<PathSeries, 3>;

PathSeries path_from(double s) {
    return boost::math::differentiation::make_fvar<double, kToolOrders>(s);
}

Place on_line(const Move& move, double s, double length) {
    const Vec3 along = (move.end - move.start) / length;
    Place at;
    for (int i = 0; i < 3; ++i) {
        at[static_cast<std::size_t>(i)] = path_from(s) * along[i] + move.start[i];
    }
    return at;
}

Place on_arc(const Move& move, double s, double length) {
    const Vec3 arm = move.start - move.centre;
    const Vec3 forward = move.normal.cross(arm);
    const PathSeries angle = path_from(s) * (move.angle / length);
    const PathSeries sine = sin(angle);
    const PathSeries half = sin(angle / 2);
    const PathSeries versine = half * half * 2;
    Place at;
    for (int i = 0; i < 3; ++i) {
        at[static_cast<std::size_t>(i)] = sine * forward[i] - versine * arm[i] +
                                          path_from(s) * (move.advance[i] / length) + move.start[i];
    }
    return at;
}

/// Place on a cubic: u' = 1 / |V(u)| gives an order of u after the other.
Place on_cubic(const Cubic& cubic, double s) {
    const double u0 = parameter_at(cubic, s);
    const PathSeries beyond = path_from(0);
    PathSeries u = u0;
    for (int order = 1; order <= kToolOrders; ++order) {
        PathSeries square = 0;
        for (int i = 0; i < 3; ++i) {
            const PathSeries v = (u * (3 * cubic.a[i]) + 2 * cubic.b[i]) * u + cubic.c[i];
            square += v * v;
        }
        const PathSeries rate = 1 / sqrt(square);
        PathSeries power = 1;
        PathSeries sum = u0;
        double factorial = 1;
        for (int n = 0; n < order; ++n) {
            power *= beyond;
            factorial *= n + 1;
            sum += power * (rate.derivative(static_cast<std::size_t>(n)) / factorial);
        }
        u = sum;
    }
    Place at;
    for (int i = 0; i < 3; ++i) {
        at[static_cast<std::size_t>(i)] =
            ((u * cubic.a[i] + cubic.b[i]) * u + cubic.c[i]) * u + cubic.d[i];
    }
    return at;
}

}  // namespace

ToolPose<PathSeries> tool_series(const Move& move, double length, double s) {
    ToolPose<PathSeries> pose;
    if (move.kind == Move::Kind::kArc) {
        pose.xyz = on_arc(move, s, length);
    } else if (move.kind == Move::Kind::kCubic) {
        pose.xyz = on_cubic(move.cubic, s);
    } else {
        pose.xyz = on_line(move, s, length);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double rate = (move.aux_end[i] - move.aux_start[i]) / length;
        pose.abc[i] = path_from(s) * rate + move.aux_start[i];
    }
    return pose;
}

ToolPose<double> tool_at(const Move& move, double length, double s) {
    const double part = length > 0 ? s / length : 0;
    const bool line = move.kind == Move::Kind::kLine;
    const Vec3 at =
        line ? Vec3(move.start + (move.end - move.start) * part) : place_on(move, s).position;
    ToolPose<double> pose{{at[0], at[1], at[2]}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        pose.abc[i] = move.aux_start[i] + (move.aux_end[i] - move.aux_start[i]) * part;
    }
    return pose;
}

VectorSeries<kToolOrders> coefficients(const std::array<PathSeries, 3>& of) {
    VectorSeries<kToolOrders> series;
    double factorial = 1;
    for (int n = 0; n <= kToolOrders; ++n) {
        if (n > 1) factorial *= n;
        for (int i = 0; i < 3; ++i) {
            series.c(i, n) =
                of[static_cast<std::size_t>(i)].derivative(static_cast<std::size_t>(n)) / factorial;
        }
    }
    return series;
}

}  // namespace curvecore::ref
