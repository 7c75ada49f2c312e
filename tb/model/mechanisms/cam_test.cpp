// SPDX-License-Identifier: Apache-2.0
// Cams of [Tamm]: surfaces and Archimedean pieces, against the closed form of a sample cam.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ref/cam/cam_shape.hpp"
#include "tb/support/judge/cam_claims.hpp"

namespace curvecore::tb::cam_test {

using ref::CamShape;
using ref::Generatrix;
using ref::PolarCurve;
using ref::Surface;
using ref::SurfaceKind;

/// A shape with sections one pitch beyond both ends: it is measured between given sections.
CamShape shape_of(SurfaceKind kind, int n, double dx) {
    return {sample_cam_table(n, dx, static_cast<int>(std::lround(100 / dx)) + 3, -dx), kind};
}

/// Worst error, um, at places of x in [0, 100] and angles `step` of an interval apart.
double worst_error(const CamShape& shape, double step, double along = 1. / 8) {
    double worst = 0;
    for (double x = 0; x <= 100; x += shape.pitch() * along) {
        for (double m = 0; m < shape.angles(); m += step) {
            const double degrees = 360 * m / shape.angles();
            worst = std::max(worst,
                             std::abs(shape.at(x, degrees).rho - sample_cam(x, radians(degrees))));
        }
    }
    return worst * 1e3;
}

PolarCurve cubic(double a, double b, double c, double d) {
    PolarCurve f = PolarCurve::Zero();
    f.head<4>() << d, c, b, a;
    return f;
}

TEST(Cam, EverySurfaceGoesThroughTheTable) {
    for (const SurfaceKind kind : all_kinds()) {
        const std::vector<ref::CamSection> table = sample_cam_table(24, 10, 11);
        const CamShape shape(table, kind);
        for (const ref::CamSection& section : table) {
            for (int m = 0; m < 24; ++m) {
                EXPECT_NEAR(shape.at(section.x, 15. * m).rho,
                            section.rho[static_cast<std::size_t>(m)], 1e-12);
            }
        }
    }
}

// Errors and jumps of 48 generatrices, um.
TEST(Cam, GeneratricesAreOfOrderTwoThreeAndFour) {
    const double pitch[] = {20, 10, 5, 2.5};
    const double linear[] = {421, 106, 27, 6.8};
    const double parabola[] = {223, 29.8, 3.8, 0.48};
    const double third[] = {88, 6.3, 0.40, 0.03};
    const double jump[] = {350, 56, 7.5, 0.95};
    for (int i = 0; i < 4; ++i) {
        const auto error = [&](Generatrix generatrix) {
            return worst_error(shape_of({Surface::kTamm, generatrix}, 48, pitch[i]), 1, 1. / 32);
        };
        EXPECT_NEAR(error(Generatrix::kLinear), linear[i], 0.03 * linear[i]);
        EXPECT_NEAR(error(Generatrix::kParabola), parabola[i], 0.05 * parabola[i]);
        EXPECT_NEAR(error(Generatrix::kCubic), third[i], 0.2 * third[i]);
        const CamShape blend = shape_of({Surface::kBlend, Generatrix::kParabola}, 48, pitch[i]);
        EXPECT_NEAR(blend.largest_jump() * 1e3, jump[i], 0.1 * jump[i]);
    }
}

// Switching to the nearest generatrix costs more than all else; tensors do not jump.
TEST(Cam, SurfacesAreAsGoodAsTheirSwitching) {
    const auto error = [](SurfaceKind kind) { return worst_error(shape_of(kind, 48, 5), 1. / 8); };
    const auto jump = [](SurfaceKind kind) { return shape_of(kind, 48, 5).largest_jump() * 1e3; };
    EXPECT_NEAR(error({Surface::kTamm, Generatrix::kParabola}), 47, 3);
    EXPECT_NEAR(jump({Surface::kTamm, Generatrix::kParabola}), 91, 5);
    EXPECT_NEAR(error({Surface::kBlend, Generatrix::kParabola}), 4.0, 0.2);
    EXPECT_NEAR(error(kTensor), 1.3, 0.2);
    EXPECT_NEAR(error(kSmooth), 2.7, 0.3);
    EXPECT_LT(jump(kTensor), 1e-9);
    EXPECT_LT(jump(kSmooth), 1e-9);
    // C1: neither slope jumps where cells meet.
    const CamShape smooth = shape_of(kSmooth, 48, 5);
    for (int m = 0; m < 48; ++m) {
        const CamShape::Place before = smooth.at(50 - 1e-9, 7.5 * m - 1e-9);
        const CamShape::Place after = smooth.at(50 + 1e-9, 7.5 * m + 1e-9);
        EXPECT_NEAR(before.by_theta, after.by_theta, 1e-6);
        EXPECT_NEAR(before.by_x, after.by_x, 1e-6);
    }
}

TEST(Cam, DerivativesAreThoseOfTheSurface) {
    for (const SurfaceKind kind : all_kinds()) {
        const CamShape shape(sample_cam_table(24, 10, 11), kind);
        const double h = 1e-4;
        for (double x = 3.3; x < 95; x += 7.1) {
            for (double degrees = 1.1; degrees < 360; degrees += 31) {
                const auto rho = [&](double dx, double dtheta) {
                    return shape.at(x + dx, degrees + dtheta * 180 / M_PI).rho;
                };
                const CamShape::Place place = shape.at(x, degrees);
                EXPECT_NEAR(place.by_x, (rho(h, 0) - rho(-h, 0)) / (2 * h), 1e-6);
                EXPECT_NEAR(place.by_theta, (rho(0, h) - rho(0, -h)) / (2 * h), 1e-5);
                EXPECT_NEAR(place.bend_x, (rho(h, 0) - 2 * rho(0, 0) + rho(-h, 0)) / (h * h), 1e-4);
                EXPECT_NEAR(place.bend_theta, (rho(0, h) - 2 * rho(0, 0) + rho(0, -h)) / (h * h),
                            1e-3);
            }
        }
    }
}

// (12) with the sign of C mended has the roots 0.34381, 0.25676 and 3.599.
TEST(Cam, PieceOfThePapersEquationsUsesAllOfDelta) {
    const PolarCurve f = cubic(0.8, -6, 2, 40);
    const double w1 = ref::longest_piece(f, 0.3, 100, 0.01);
    EXPECT_NEAR(ref::chord_deviation(f, 0.3, w1), 0.01, 1e-13);
    const double h = 0.34381;
    const double k = (ref::value(f, w1) - ref::value(f, 0.3)) / (w1 - 0.3);
    EXPECT_NEAR(3 * 0.8 * h * h - 12 * h + 2, k, 1e-4);  // (10)
    EXPECT_NEAR(w1, 0.3879, 1e-4);
}

TEST(Cam, PiecesOfRandomCubicsUseAllOfDelta) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int n = 0; n < 3000; ++n) {
        const PolarCurve f = cubic(any(random), any(random), any(random), any(random));
        const double w0 = any(random);
        const double w1 = ref::longest_piece(f, w0, 1e9, 1e-3);
        ASSERT_GT(w1, w0);
        ASSERT_NEAR(ref::chord_deviation(f, w0, w1) / 1e-3, 1, 3e-10) << n;
    }
}

// A chord that is cut at a knot with an inflexion before it may deviate by more than the whole.
TEST(Cam, PiecesThatAreCutKeepDelta) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-1, 1);
    int shortened = 0;
    for (int n = 0; n < 20000; ++n) {
        const PolarCurve f = cubic(any(random), any(random), any(random), any(random));
        const double free = ref::longest_piece(f, 0, 1e9, 1e-3);
        const double end = free * std::abs(any(random));
        const double w1 = ref::longest_piece(f, 0, end, 1e-3);
        ASSERT_LE(ref::chord_deviation(f, 0, w1), 1e-3 * (1 + 1e-8));
        ASSERT_GT(w1, 0);
        shortened += w1 < end;
    }
    EXPECT_GT(shortened, 10);
}

TEST(Cam, DeviationIsTheLargestOfManyPlaces) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int n = 0; n < 300; ++n) {
        PolarCurve f;
        for (double& c : f) c = any(random);
        const double w0 = any(random);
        const double w1 = w0 + std::abs(any(random)) + 0.1;
        double worst = 0;
        for (int i = 1; i < 2000; ++i) {
            const double t = i / 2000.;
            const double chord = ref::value(f, w0) * (1 - t) + ref::value(f, w1) * t;
            worst = std::max(worst, std::abs(ref::value(f, w0 + (w1 - w0) * t) - chord));
        }
        const double deviation = ref::chord_deviation(f, w0, w1);
        EXPECT_GE(deviation, worst * (1 - 1e-12));
        EXPECT_LE(deviation, worst * (1 + 1e-5));
    }
}

// Pieces of the section x = 50; one more than without the second check of a cut piece.
TEST(Cam, PiecesPerTurn) {
    const double delta[] = {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
    const int of24[] = {31, 36, 53, 68, 91, 140, 193};
    const int of48[] = {48, 52, 63, 83, 106, 156, 210};
    const int of72[] = {72, 72, 79, 94, 117, 166, 227};
    const int asymptotic[] = {19, 27, 42, 60, 84, 133, 189};
    const auto section = [](int n) { return sample_cam_table(n, 1, 1, 50)[0].rho; };
    const CamShape shape = shape_of(kTensor, 72, 5);
    for (int i = 0; i < 7; ++i) {
        EXPECT_NEAR(pieces_a_turn(section(24), delta[i]), of24[i], 1);
        EXPECT_NEAR(pieces_a_turn(section(48), delta[i]), of48[i], 1);
        EXPECT_NEAR(pieces_a_turn(section(72), delta[i]), of72[i], 1);
        EXPECT_NEAR(shape.pieces_per_turn(50, delta[i]), asymptotic[i], 1.5);
    }
}

// [Tamm], p. 4: concave parts want a smaller step; of this section 1.99 degrees against 2.56.
TEST(Cam, ConcavePartsTakeShorterPieces) {
    struct Mean {
        double sum = 0;
        int count = 0;
        double value() const { return sum / count * 180 / M_PI; }
    };
    Mean concave, convex;
    for (double theta = 0; theta < 2 * M_PI;) {
        PolarCurve f;  // 40 + 8 cos 3 theta, by its Taylor series
        double factor = 8;
        for (int i = 0; i <= 6; ++i) {
            f[i] = factor * std::cos(3 * theta + i * M_PI / 2);
            factor *= 3. / (i + 1);
        }
        f[0] += 40;
        const double step = ref::longest_piece(f, 0, 1, 0.01);
        const bool bends_out = 2 * f[2] > f[0] + 2 * f[1] * f[1] / f[0];
        Mean& part = bends_out ? concave : convex;
        part.sum += step;
        ++part.count;
        theta += step;
    }
    EXPECT_NEAR(concave.value(), 1.99, 0.06);
    EXPECT_NEAR(convex.value(), 2.56, 0.2);
    // The mean steps without drawing pieces.
    const MeanSteps steps =
        mean_steps([](double theta) { return 40 + 8 * std::cos(3 * theta); }, 0.01);
    EXPECT_NEAR(steps.concave, concave.value(), 0.05);
    EXPECT_NEAR(steps.convex, convex.value(), 0.2);
    const MeanSteps circle = mean_steps(
        [](double theta) {
            return 5 * std::cos(theta) + std::sqrt(1600 - std::pow(5 * std::sin(theta), 2));
        },
        0.01);
    EXPECT_EQ(circle.concave, 0);
    EXPECT_NEAR(circle.convex, 9.5, 0.1) << "of rho'' = -5 cos theta";
}

// [Tamm], p. 4: "from 7 to 8 degrees" two stages pay: spirals alone miss 58 um there where |rho''|
// is 27 mm, and cubics miss a micrometre.
TEST(Cam, RadiiOfSevenDegreesWantCubicsBetween) {
    const auto by_bend = [](int n) { return 27 * std::pow(2 * M_PI / n, 2) / 8; };
    for (const int n : {180, 48}) {
        const StageErrors off = stage_errors(sample_cam, 50, n);
        EXPECT_NEAR(off.spirals, by_bend(n), 0.1 * by_bend(n));
        EXPECT_LT(off.cubics, off.spirals / 40);
    }
    EXPECT_NEAR(stage_errors(sample_cam, 50, 48).spirals, 58e-3, 6e-3);
    EXPECT_NEAR(stage_errors(sample_cam, 50, 48).cubics, 1e-3, 0.3e-3);
}

TEST(Cam, EvenPiecesAreManyMore) {
    const double delta[] = {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
    const double even[] = {37, 52, 82, 116, 164, 259, 366};
    for (int i = 0; i < 7; ++i) {
        const auto radius = [](double theta) { return sample_cam(50, theta); };
        EXPECT_NEAR(even_pieces_a_turn(radius, delta[i]), even[i], 1);
    }
}

// [Tamm], conclusion 2: 10 to 15 times less input, here at 5 to 10 um.
TEST(Cam, SavesTenTimesTheInput) {
    const CamShape shape = shape_of(kTensor, 48, 5);
    const CamShape table = shape_of(kTensor, 28, 100. / 15);
    const double error = worst_error(table, 1. / 8) * 1e-3;
    EXPECT_NEAR(error, 9.4e-3, 1e-3);
    const double saved = shape.linear_radii(error) / (28 * 16);
    EXPECT_GT(saved, 10);
    EXPECT_LT(saved, 25);
}

TEST(Cam, OwnErrorOfATableIsSeenFromItsRadii) {
    for (const int n : {24, 48}) {
        const CamShape shape = shape_of(kTensor, n, 5);
        const double error = worst_error(shape, 1. / 8) * 1e-3;
        EXPECT_GT(shape.own_error(), 0.5 * error);
        EXPECT_LT(shape.own_error(), 3 * error);
    }
}

}  // namespace curvecore::tb::cam_test
