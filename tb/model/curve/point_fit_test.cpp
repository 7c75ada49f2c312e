// SPDX-License-Identifier: Apache-2.0
// Splines through points: closed forms, joints, and the figures measured for the papers' formulas.
#include "ref/curve/fit/point_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/fit/hermite.hpp"
#include "ref/curve/fit/point_slopes.hpp"
#include "tb/support/judge/curve_distance.hpp"

namespace curvecore::ref::point_fit_test {

constexpr double kPi = 3.14159265358979323846;
const std::vector<double> kUneven{0, 0.7, 1.5, 1.9, 3.2, 4, 4.4};

/// Points of a polynomial of degree 3 in every coordinate, and its derivatives.
Vec3 cubic_at(double t) { return {t, 3 - t * t, ((0.3 * t - 1) * t + 2) * t - 5}; }
Vec3 cubic_d1(double t) { return {1, -2 * t, (0.9 * t - 2) * t + 2}; }
Vec3 parabola(double t) { return {2 * t, t * t - t, 4 - 3 * t * t}; }
Vec3 parabola_d1(double t) { return {2, 2 * t - 1, -6 * t}; }

Vectors sample(Vec3 (*curve)(double), const std::vector<double>& t) {
    Vectors points;
    for (const double at : t) points.push_back(curve(at));
    return points;
}

TEST(PointSlopes, BesselIsTheParabolaThroughThreePointsAlsoAtTheEnds) {
    const Vectors slopes = bessel_slopes(sample(parabola, kUneven), kUneven);
    for (std::size_t i = 0; i < kUneven.size(); ++i) {
        EXPECT_LE((slopes[i] - parabola_d1(kUneven[i])).norm(), 1e-13) << i;
    }
}

TEST(PointSlopes, ClampedSplineIsTheCubicThatItsPointsComeFrom) {
    const Vectors points = sample(cubic_at, kUneven);
    const Vectors slopes =
        smooth_slopes(points, kUneven, {cubic_d1(0)}, {cubic_d1(kUneven.back())});
    const Vectors natural = smooth_slopes(points, kUneven, {}, {});
    for (std::size_t i = 0; i < kUneven.size(); ++i) {
        EXPECT_LE((slopes[i] - cubic_d1(kUneven[i])).norm(), 1e-13) << i;
    }
    EXPECT_GE((natural[0] - slopes[0]).norm(), 0.1) << "the end conditions make no difference";
}

TEST(PointSlopes, SecondDerivativesAtTheEndsAreMet) {
    const Vectors points = sample(cubic_at, kUneven);
    const auto d2 = [](double t) { return Vec3(0, -2, 1.8 * t - 2); };
    const Vectors slopes = smooth_slopes(points, kUneven, {{}, d2(0)}, {{}, d2(kUneven.back())});
    for (std::size_t i = 0; i < kUneven.size(); ++i) {
        EXPECT_LE((slopes[i] - cubic_d1(kUneven[i])).norm(), 1e-13) << i;
    }
}

TEST(PointSlopes, ClosedSplineOfACircleHasItsClosedForm) {
    constexpr int kPoints = 7;
    const double angle = 2 * kPi / kPoints;
    Vectors points;
    std::vector<double> t;
    for (int i = 0; i <= kPoints; ++i) {
        points.emplace_back(std::cos(i % kPoints * angle), std::sin(i % kPoints * angle), 2);
        t.push_back(0.5 * i);
    }
    const Vectors slopes = closed_slopes(points, t);
    const double speed = 3 * std::sin(angle) / (0.5 * (2 + std::cos(angle)));
    for (int i = 0; i <= kPoints; ++i) {
        const Vec3 expected(-speed * std::sin(i * angle), speed * std::cos(i * angle), 0);
        EXPECT_LE((slopes[i] - expected).norm(), 1e-13) << i;
    }
}

/// Jumps of the first two derivatives at the inner points, and the second one at the ends.
struct Joints {
    double d1 = 0;
    double d2 = 0;
    double end_d2 = 0;
};

Joints joints(const std::vector<HermitePiece>& pieces, bool moments) {
    Joints found;
    std::vector<Cubic> cubics;
    cubics.reserve(pieces.size());
    for (const HermitePiece& piece : pieces) {
        cubics.push_back(moments ? cubic_of_moments(piece) : cubic_of_slopes(piece));
    }
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const double h0 = pieces[i - 1].h;
        const double h1 = pieces[i].h;
        found.d1 = std::max(found.d1,
                            (cubics[i].velocity(0) / h1 - cubics[i - 1].velocity(1) / h0).norm());
        found.d2 = std::max(found.d2, (cubics[i].acceleration(0) / (h1 * h1) -
                                       cubics[i - 1].acceleration(1) / (h0 * h0))
                                          .norm());
    }
    found.end_d2 =
        std::max(cubics.front().acceleration(0).norm(), cubics.back().acceleration(1).norm());
    return found;
}

std::vector<HermitePiece> with_slopes(const Vectors& points, const std::vector<double>& t,
                                      const Vectors& slopes) {
    std::vector<HermitePiece> pieces;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        HermitePiece piece;
        piece.h = t[i + 1] - t[i];
        piece.start = points[i];
        piece.end = points[i + 1];
        piece.start_d1 = slopes[i];
        piece.end_d1 = slopes[i + 1];
        pieces.push_back(piece);
    }
    return pieces;
}

Vec3 loop(double t) { return {std::cos(2 * t), std::sin(3 * t), std::sin(t) + t}; }

TEST(PointSlopes, NaturalAndClampedSplinesHaveNoJumpInTheSecondDerivative) {
    const Vectors points = sample(loop, kUneven);
    const Vectors natural = smooth_slopes(points, kUneven, {}, {});
    const Joints free = joints(with_slopes(points, kUneven, natural), false);
    EXPECT_LE(free.d1, 1e-13);
    EXPECT_LE(free.d2, 1e-12);
    EXPECT_LE(free.end_d2, 1e-12);
    const Vectors held = smooth_slopes(points, kUneven, {Vec3(1, 0, 0)}, {Vec3(0, 5, 0)});
    const Joints clamped = joints(with_slopes(points, kUneven, held), false);
    EXPECT_LE(clamped.d2, 1e-12);
    EXPECT_EQ(held.front(), Vec3(1, 0, 0));
    EXPECT_EQ(held.back(), Vec3(0, 5, 0));
    const Vectors bessel = bessel_slopes(points, kUneven);
    EXPECT_GE(joints(with_slopes(points, kUneven, bessel), false).d2, 1) << "Bessel is C1 only";
}

TEST(PointSlopes, ClosedSplineHasNoSeam) {
    Vectors points = sample(loop, kUneven);
    points.back() = points.front();
    std::vector<HermitePiece> pieces = with_slopes(points, kUneven, closed_slopes(points, kUneven));
    pieces.push_back(pieces.front());
    const Joints closed = joints(pieces, false);
    EXPECT_LE(closed.d1, 1e-13);
    EXPECT_LE(closed.d2, 1e-12);
    pieces = with_slopes(points, kUneven, smooth_slopes(points, kUneven, {}, {}));
    pieces.push_back(pieces.front());
    EXPECT_GE(joints(pieces, false).d1, 0.1) << "a natural spline has a seam";
}

TEST(PointSlopes, AkimaKeepsStraightPartsStraightAndDoesNotDependOnTheAxes) {
    const std::vector<double> t{0, 1, 2, 3, 4, 5, 6};
    Vectors points;
    for (const double x : t) points.emplace_back(x, std::abs(x - 3), 0);
    const Vectors slopes = akima_slopes(points, t);
    EXPECT_EQ(slopes[2], Vec3(1, -1, 0));
    EXPECT_EQ(slopes[3], Vec3(1, 0, 0)) << "the mean at a corner between straight parts";
    EXPECT_EQ(slopes[6], Vec3(1, 1, 0));
    const Eigen::AngleAxisd turn(1.1, Vec3(1, 2, 3).normalized());
    const Vectors plain = akima_slopes(sample(loop, kUneven), kUneven);
    Vectors turned = sample(loop, kUneven);
    for (Vec3& point : turned) point = turn * point;
    turned = akima_slopes(turned, kUneven);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_LE((turned[i] - turn * plain[i]).norm(), 1e-13);
    }
}

struct Accuracy {
    double error;
    double bend_jump;
};

/// A spline through 40 points of one period of a sine.
Accuracy on_sine(Vectors (*slopes)(const Vectors&, const std::vector<double>&)) {
    std::vector<double> t;
    Vectors points;
    for (int i = 0; i < 40; ++i) {
        t.push_back(2 * kPi * i / 39);
        points.emplace_back(0, std::sin(t.back()), 0);
    }
    const std::vector<HermitePiece> pieces = with_slopes(points, t, slopes(points, t));
    Accuracy found{0, joints(pieces, false).d2};
    for (std::size_t i = 2; i + 3 < t.size(); ++i) {  // away from the ends
        const Cubic cubic = cubic_of_slopes(pieces[i]);
        for (double u = 0; u < 1; u += 0.01) {
            found.error = std::max(
                found.error, std::abs(cubic.position(u).y() - std::sin(t[i] + u * pieces[i].h)));
        }
    }
    return found;
}

TEST(PointSlopes, SineShowsThatBesselIsNotAkima) {
    const Accuracy bessel = on_sine(bessel_slopes);
    const Accuracy akima = on_sine(akima_slopes);
    EXPECT_NEAR(bessel.error, 6.7e-5, 0.1e-5);
    EXPECT_NEAR(akima.error, 2.2e-4, 0.1e-4);
    EXPECT_NEAR(bessel.bend_jump, 0.32, 0.02);
    EXPECT_NEAR(akima.bend_jump, 0.60, 0.02);
}

TEST(PointSlopes, TwoPointsMakeAStraightLine) {
    const Vectors points{Vec3(1, 2, 3), Vec3(5, 2, 0)};
    const std::vector<double> t{0, 5};
    const Vec3 slope(0.8, 0, -0.6);
    for (const Vectors& slopes :
         {bessel_slopes(points, t), akima_slopes(points, t), smooth_slopes(points, t, {}, {})}) {
        EXPECT_LE((slopes[0] - slope).norm() + (slopes[1] - slope).norm(), 1e-15);
    }
}

TEST(Hermite, SlopesAndMomentsAreMetAtBothEnds) {
    const HermitePiece piece{2.5,           Vec3(1, 2, 3),  Vec3(4, -1, 2),  Vec3(1, 0, -1),
                             Vec3(0, 3, 1), Vec3(-1, 1, 2), Vec3(0.5, 4, -3)};
    for (const bool moments : {false, true}) {
        const Cubic cubic = moments ? cubic_of_moments(piece) : cubic_of_slopes(piece);
        EXPECT_LE((cubic.position(0) - piece.start).norm(), 1e-14);
        EXPECT_LE((cubic.position(1) - piece.end).norm(), 1e-14);
        const auto d1 = [&](double u) { return Vec3(cubic.velocity(u) / piece.h); };
        const auto d2 = [&](double u) { return Vec3(cubic.acceleration(u) / piece.h / piece.h); };
        EXPECT_LE(((moments ? d2(0) : d1(0)) - (moments ? piece.start_d2 : piece.start_d1)).norm(),
                  1e-14);
        EXPECT_LE(((moments ? d2(1) : d1(1)) - (moments ? piece.end_d2 : piece.end_d1)).norm(),
                  1e-14);
    }
}

TEST(Hermite, SlopesUseTheCardinalFunctionsOfPetrakov) {
    const HermitePiece piece{2.5,           Vec3(1, 2, 3),  Vec3(4, -1, 2),  Vec3(1, 0, -1),
                             Vec3(0, 3, 1), Vec3(-1, 1, 2), Vec3(0.5, 4, -3)};
    const Cubic cubic = cubic_of_slopes(piece);
    for (double u = 0; u <= 1; u += 0.125) {
        const double v = 1 - u;  // (5) with (1 - U)^2 in phi1, not 1 - U^2
        const Vec3 expected = piece.start * v * v * (1 + 2 * u) + piece.end * u * u * (3 - 2 * u) +
                              piece.h * (piece.start_d1 * u * v * v - piece.end_d1 * u * u * v);
        EXPECT_LE((cubic.position(u) - expected).norm(), 1e-14);
        const Vec3 printed = expected + piece.start * ((1 - u * u) - v * v) * (1 + 2 * u);
        if (u > 0 && u < 1) {
            EXPECT_GT((cubic.position(u) - printed).norm(), 0.1) << "1 - U^2 as printed";
        }
    }
}

TEST(Hermite, MomentsOfASmoothSplineMakeItAndOthersLeaveCorners) {
    const Vectors points = sample(loop, kUneven);
    std::vector<HermitePiece> pieces =
        with_slopes(points, kUneven, smooth_slopes(points, kUneven, {}, {}));
    for (HermitePiece& piece : pieces) {
        const Cubic cubic = cubic_of_slopes(piece);
        piece.start_d2 = cubic.acceleration(0) / (piece.h * piece.h);
        piece.end_d2 = cubic.acceleration(1) / (piece.h * piece.h);
    }
    EXPECT_LE(joints(pieces, true).d1, 1e-13);
    pieces[2].end_d2 += Vec3(0, 1, 0);
    pieces[3].start_d2 += Vec3(0, 1, 0);
    EXPECT_GE(joints(pieces, true).d1, 0.1);
    EXPECT_LE(joints(pieces, true).d2, 1e-12);
}

TEST(Hermite, QuinticIsTheSumOfItsCardinalFunctions) {
    const HermitePiece piece{2.5,           Vec3(1, 2, 3),  Vec3(4, -1, 2),  Vec3(1, 0, -1),
                             Vec3(0, 3, 1), Vec3(-1, 1, 2), Vec3(0.5, 4, -3)};
    RationalBezier quintic;
    for (const Vec3& point : quintic_points(piece)) {
        quintic.points.emplace_back(point.x(), point.y(), point.z(), 1);
    }
    const double h = piece.h;
    for (double t = 0; t <= 1; t += 0.125) {
        const double t2 = t * t, t3 = t2 * t, t4 = t3 * t, t5 = t4 * t;
        const Vec3 expected = piece.start * (1 - 10 * t3 + 15 * t4 - 6 * t5) +
                              h * piece.start_d1 * (t - 6 * t3 + 8 * t4 - 3 * t5) +
                              h * h * piece.start_d2 * (t2 - 3 * t3 + 3 * t4 - t5) / 2 +
                              h * h * piece.end_d2 * (t3 - 2 * t4 + t5) / 2 +
                              h * piece.end_d1 * (-4 * t3 + 7 * t4 - 3 * t5) +
                              piece.end * (10 * t3 - 15 * t4 + 6 * t5);
        EXPECT_LE((quintic.at(t).position - expected).norm(), 1e-14);
    }
}

TEST(PointFit, ParametersAreChordsTheirRootsOrOne) {
    std::vector<FitPoint> points(3);
    points[1].position = Vec3(3, 4, 0);
    points[2].position = Vec3(3, 4, 16);
    EXPECT_EQ(parameters(points, Parametrisation::kChord), (std::vector<double>{0, 5, 21}));
    EXPECT_EQ(parameters(points, Parametrisation::kCentripetal)[2], std::sqrt(5.0) + 4);
    EXPECT_EQ(parameters(points, Parametrisation::kUniform), (std::vector<double>{0, 1, 2}));
}

TEST(PointFit, EveryFitPassesItsPointsWithItsSlopes) {
    std::vector<FitPoint> points;
    for (int i = 0; i < 9; ++i) {
        FitPoint point;
        point.position = 20 * loop(0.4 * i);
        point.d1 = Vec3(1, 0.1 * i, 0.5);
        point.d2 = Vec3(0, 0.01, 0.02 * i);
        points.push_back(point);
    }
    for (const Parametrisation parametrisation :
         {Parametrisation::kChord, Parametrisation::kCentripetal, Parametrisation::kUniform}) {
        for (const Fit fit : {Fit::kBessel, Fit::kAkima, Fit::kNatural, Fit::kClamped,
                              Fit::kHermite, Fit::kMoments, Fit::kQuintic}) {
            const auto chains = fit_points(points, fit, parametrisation);
            ASSERT_EQ(chains.size(), 8U);
            for (std::size_t i = 0; i < 8; ++i) {
                EXPECT_LE((chains[i].front().position(0) - points[i].position).norm(), 1e-13);
                EXPECT_LE((chains[i].back().position(1) - points[i + 1].position).norm(), 1e-13);
                if (i == 0 || fit == Fit::kMoments) continue;
                const Vec3 in = chains[i - 1].back().velocity(1).normalized();
                const Vec3 out = chains[i].front().velocity(0).normalized();
                EXPECT_LE((out - in).norm(), 1e-12) << i;
                if (fit == Fit::kHermite || fit == Fit::kQuintic) {
                    EXPECT_LE((out - points[i].d1->normalized()).norm(), 1e-12);
                }
            }
        }
    }
}

TEST(PointFit, QuinticStaysWithinItsTolerance) {
    std::vector<FitPoint> points(2);
    points[0] = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0.05, 0)};
    points[1] = {Vec3(10, 5, 2), Vec3(0, 1, 0), Vec3(-0.03, 0, 0.1)};
    HermitePiece piece;
    piece.h = parameters(points, Parametrisation::kChord)[1];
    piece.end = points[1].position;
    piece.start_d1 = *points[0].d1;
    piece.end_d1 = *points[1].d1;
    piece.start_d2 = *points[0].d2;
    piece.end_d2 = *points[1].d2;
    RationalBezier quintic;
    for (const Vec3& point : quintic_points(piece)) {
        quintic.points.emplace_back(point.x(), point.y(), point.z(), 1);
    }
    const std::vector<Cubic> cubics =
        fit_points(points, Fit::kQuintic, Parametrisation::kChord, kFitTolerance).front();
    const tb::CurveDistance exact(quintic);
    double worst = 0;
    for (const Cubic& cubic : cubics) worst = std::max(worst, exact.of(cubic));
    EXPECT_LE(worst, kFitTolerance);
    EXPECT_GE(worst, kFitTolerance / 100);
    EXPECT_LE(cubics.size(), 64U);
    // The joint's curvature is the quintic's within what the tolerance leaves open.
    EXPECT_NEAR(curvature(cubics.front(), 0), 0.05, 1e-4);
}

}  // namespace curvecore::ref::point_fit_test
