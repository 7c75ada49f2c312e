// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/point_fit.hpp"

#include <cmath>

#include "ref/curve/fit/hermite.hpp"
#include "ref/curve/fit/point_slopes.hpp"

namespace curvecore::ref {
namespace {

Vectors slopes(const std::vector<FitPoint>& points, Fit fit, const std::vector<double>& t) {
    Vectors positions;
    for (const FitPoint& point : points) positions.push_back(point.position);
    switch (fit) {
        case Fit::kBessel:
            return bessel_slopes(positions, t);
        case Fit::kAkima:
            return akima_slopes(positions, t);
        case Fit::kNatural:
            return smooth_slopes(positions, t, std::nullopt, std::nullopt);
        case Fit::kClamped:
            return smooth_slopes(positions, t, points.front().d1, points.back().d1);
        default:
            Vectors given;
            for (const FitPoint& point : points) given.push_back(point.d1.value_or(Vec3::Zero()));
            return given;
    }
}

std::vector<Cubic> quintic_cubics(const HermitePiece& piece, double tolerance) {
    RationalBezier quintic;
    quintic.origin = piece.start;
    for (const Vec3& point : quintic_points(piece)) {
        quintic.points.emplace_back();
        quintic.points.back() << point - piece.start, 1;
    }
    return fit_cubics(quintic, tolerance);
}

}  // namespace

bool wants_d1(Fit fit) {
    return fit == Fit::kClamped || fit == Fit::kHermite || fit == Fit::kQuintic;
}

bool wants_d2(Fit fit) { return fit == Fit::kMoments || fit == Fit::kQuintic; }

std::vector<double> parameters(const std::vector<FitPoint>& points,
                               Parametrisation parametrisation) {
    std::vector<double> t{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double chord = (points[i].position - points[i - 1].position).norm();
        t.push_back(t.back() + (parametrisation == Parametrisation::kChord ? chord
                                : parametrisation == Parametrisation::kCentripetal
                                    ? std::sqrt(chord)
                                    : 1));
    }
    return t;
}

std::vector<std::vector<Cubic>> fit_points(const std::vector<FitPoint>& points, Fit fit,
                                           Parametrisation parametrisation, double tolerance) {
    const std::vector<double> t = parameters(points, parametrisation);
    const Vectors m = slopes(points, fit, t);
    std::vector<std::vector<Cubic>> chains;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        HermitePiece piece;
        piece.h = t[i + 1] - t[i];
        piece.start = points[i].position;
        piece.end = points[i + 1].position;
        piece.start_d1 = m[i];
        piece.end_d1 = m[i + 1];
        piece.start_d2 = points[i].d2.value_or(Vec3::Zero());
        piece.end_d2 = points[i + 1].d2.value_or(Vec3::Zero());
        if (fit == Fit::kQuintic) {
            chains.push_back(quintic_cubics(piece, tolerance));
        } else {
            chains.push_back(
                {fit == Fit::kMoments ? cubic_of_moments(piece) : cubic_of_slopes(piece)});
        }
    }
    return chains;
}

}  // namespace curvecore::ref
