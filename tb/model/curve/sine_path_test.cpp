// SPDX-License-Identifier: Apache-2.0
// Fits without derivatives of their own on a sine, against figures computed beforehand.
#include <gtest/gtest.h>

#include <cmath>

#include "ref/curve/fit/point_fit.hpp"

namespace curvecore::ref::sine_path_test {

constexpr double kPi = 3.14159265358979323846;

/// y = 5 sin(2 pi x / 40), 0 <= x <= 40, through this many points, by x.
std::vector<Cubic> sine_path(Fit fit, int count, Ends ends = Ends::kNatural) {
    std::vector<FitPoint> points(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double x = 40.0 * i / (count - 1);
        points[i].position = Vec3(x, 5 * std::sin(2 * kPi * x / 40), 0);
    }
    std::vector<Cubic> cubics;
    for (const auto& chain : fit_points(points, fit, Parametrisation::kUniform, 1e-4, ends)) {
        cubics.insert(cubics.end(), chain.begin(), chain.end());
    }
    return cubics;
}

double sine_error(const std::vector<Cubic>& cubics) {
    double worst = 0;
    for (const Cubic& cubic : cubics) {
        for (double u = 0; u <= 1; u += 0.02) {
            const Vec3 at = cubic.position(u);
            worst = std::max(worst, std::abs(at.y() - 5 * std::sin(2 * kPi * at.x() / 40)));
        }
    }
    return worst;
}

double slope_jump(const std::vector<Cubic>& cubics) {
    double worst = 0;
    for (std::size_t i = 1; i < cubics.size(); ++i) {
        const Vec3 in = cubics[i - 1].velocity(1);
        const Vec3 out = cubics[i].velocity(0);
        worst = std::max(worst, std::abs(out.y() / out.x() - in.y() / in.x()));
    }
    return worst;
}

TEST(PointFit, DerivativesFromTheTableGiveTheFiguresOfTheSinePath) {
    EXPECT_NEAR(sine_error(sine_path(Fit::kQuintic, 11)), 6.8e-2, 0.05e-2);
    EXPECT_NEAR(sine_error(sine_path(Fit::kQuintic, 21)), 9.7e-3, 0.2e-3);
    EXPECT_NEAR(sine_error(sine_path(Fit::kQuintic, 41)), 1.3e-3, 0.2e-3);
    EXPECT_NEAR(slope_jump(sine_path(Fit::kMoments, 6)), 0.218, 0.001);
    EXPECT_NEAR(slope_jump(sine_path(Fit::kMoments, 11)), 0.070, 0.001);
    EXPECT_NEAR(slope_jump(sine_path(Fit::kMoments, 21)), 0.019, 0.001);
    EXPECT_NEAR(sine_error(sine_path(Fit::kC2, 11, Ends::kSecond)), 4.6e-2, 0.05e-2);
    EXPECT_NEAR(sine_error(sine_path(Fit::kC2, 21, Ends::kSecond)), 5.7e-3, 0.05e-3);
    EXPECT_NEAR(sine_error(sine_path(Fit::kC2, 41, Ends::kSecond)), 7.1e-4, 0.05e-4);
    EXPECT_NEAR(sine_error(sine_path(Fit::kC2, 21, Ends::kSlope)), 8.5e-3, 0.05e-3);
    EXPECT_LE(slope_jump(sine_path(Fit::kC2, 21)), 1e-13);
    EXPECT_LE(slope_jump(sine_path(Fit::kHermite, 21)), 1e-13);
    const std::vector<Cubic> hermite = sine_path(Fit::kHermite, 21);
    const std::vector<Cubic> bessel = sine_path(Fit::kBessel, 21);
    for (std::size_t i = 0; i < bessel.size(); ++i) EXPECT_EQ(hermite[i].c, bessel[i].c);
}

TEST(PointFit, C2SplineIsOfTheFourthOrderWithTheCurvesOwnEnds) {
    // Second derivatives at both ends are 0 on this path: natural ends are its own.
    const double coarse = sine_error(sine_path(Fit::kC2, 11));
    EXPECT_NEAR(coarse, 2.24e-3, 0.01e-3);
    EXPECT_NEAR(coarse / sine_error(sine_path(Fit::kC2, 21)), 16, 2);
    EXPECT_GT(sine_error(sine_path(Fit::kBessel, 21)), 5e-3);
}

}  // namespace curvecore::ref::sine_path_test
