// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/point_fit.hpp"

#include <cmath>

#include "ref/curve/fit/hermite.hpp"
#include "ref/curve/fit/point_slopes.hpp"

namespace curvecore::ref {
namespace {

using Derivative = std::optional<Vec3> FitPoint::*;

/// Returns the points' own derivatives, or those by [Petrakov] (1) from the vectors below them.
Vectors derivatives(const std::vector<FitPoint>& points, Derivative which, const Vectors& of,
                    const std::vector<double>& t) {
    if (!(points.front().*which)) return bessel_slopes(of, t);
    Vectors given;
    for (const FitPoint& point : points) given.push_back(*(point.*which));
    return given;
}

Vectors c2_slopes(const std::vector<FitPoint>& points, const Vectors& positions,
                  const std::vector<double>& t, Ends ends) {
    if (ends == Ends::kClosed) return closed_slopes(positions, t);
    const Vectors d1 = bessel_slopes(positions, t);
    const Vectors d2 = bessel_slopes(d1, t);
    const auto end = [ends](const FitPoint& point, const Vec3& slope, const Vec3& second) {
        SplineEnd found;
        if (ends == Ends::kSlope) found.slope = point.d1.value_or(slope);
        if (ends == Ends::kSecond) found.second = point.d2.value_or(second);
        return found;
    };
    return smooth_slopes(positions, t, end(points.front(), d1.front(), d2.front()),
                         end(points.back(), d1.back(), d2.back()));
}

Vectors slopes(const std::vector<FitPoint>& points, const Vectors& positions, Fit fit,
               const std::vector<double>& t, Ends ends) {
    switch (fit) {
        case Fit::kBessel:
            return bessel_slopes(positions, t);
        case Fit::kAkima:
            return akima_slopes(positions, t);
        case Fit::kNatural:
            return c2_slopes(points, positions, t, Ends::kNatural);
        case Fit::kClamped:
            return c2_slopes(points, positions, t, Ends::kSlope);
        case Fit::kC2:
            return c2_slopes(points, positions, t, ends);
        default:
            return derivatives(points, &FitPoint::d1, positions, t);
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

Reads reads_d1(Fit fit, Ends ends) {
    if (fit == Fit::kHermite || fit == Fit::kQuintic || fit == Fit::kArcs) return Reads::kAll;
    const bool slope = fit == Fit::kC2 && ends == Ends::kSlope;
    return fit == Fit::kClamped || slope ? Reads::kEnds : Reads::kNothing;
}

Reads reads_d2(Fit fit, Ends ends) {
    if (fit == Fit::kMoments || fit == Fit::kQuintic) return Reads::kAll;
    return fit == Fit::kC2 && ends == Ends::kSecond ? Reads::kEnds : Reads::kNothing;
}

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
                                           Parametrisation parametrisation, double tolerance,
                                           Ends ends) {
    const std::vector<double> t = parameters(points, parametrisation);
    Vectors positions;
    for (const FitPoint& point : points) positions.push_back(point.position);
    const Vectors m = slopes(points, positions, fit, t, ends);
    const Vectors second = reads_d2(fit, ends) == Reads::kAll
                               ? derivatives(points, &FitPoint::d2, m, t)
                               : Vectors(points.size(), Vec3::Zero());
    std::vector<std::vector<Cubic>> chains;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        HermitePiece piece;
        piece.h = t[i + 1] - t[i];
        piece.start = points[i].position;
        piece.end = points[i + 1].position;
        piece.start_d1 = m[i];
        piece.end_d1 = m[i + 1];
        piece.start_d2 = second[i];
        piece.end_d2 = second[i + 1];
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
