// SPDX-License-Identifier: Apache-2.0
// The computable step limit against the true radius of convergence, and that radius against closed
// forms and the series itself.
#include "ref/curve/step_limit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ref/series/interpreter.hpp"
#include "ref/series/spline_state.hpp"
#include "tb/support/judge/convergence_radius.hpp"
#include "tb/support/segments/cubics.hpp"

namespace curvecore::ref::step_limit_test {

using tb::ConvergenceRadius;
using tb::RandomCubics;

struct Spread {
    double min, median, max;
};

Spread spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values.front(), values[values.size() / 2], values.back()};
}

// Half of them any, half slow somewhere or sharp.
Cubic some_cubic(RandomCubics& random, int n) {
    switch (n % 4) {
        case 0:
            return random.slow_at(random.uniform(0, 1), random.log_uniform(1e-4, 1));
        case 1:
            return RandomCubics::hairpin(random.log_uniform(1e-6, 1));
        default:
            return random.bezier();
    }
}

TEST(StepLimit, IsSafeOnRandomCubics) {
    RandomCubics random(31);
    std::vector<double> ratios;
    std::vector<double> naive;
    for (int n = 0; n < 12000; ++n) {
        const Cubic cubic = some_cubic(random, n);
        const double u = random.uniform(0, 1);
        const double radius = ConvergenceRadius(cubic)(u);
        ASSERT_TRUE(std::isfinite(radius)) << n;
        ratios.push_back(radius / step_limit(cubic, u));
        naive.push_back(radius * cubic.acceleration(u).norm() / std::pow(cubic.speed(u), 2));
    }
    const Spread found = spread(ratios);
    RecordProperty("min", std::to_string(found.min));
    RecordProperty("median", std::to_string(found.median));
    EXPECT_GT(found.min, 1.05) << "not safe";
    EXPECT_LT(found.min, 1.15) << "idle: it could be larger";
    EXPECT_NEAR(found.median, 1.64, 0.03);
    EXPECT_LT(found.max, 4);
    // Negative control: the same cubics break the limit that looks at W alone.
    EXPECT_LT(spread(naive).min, 0.1);
}

TEST(StepLimit, ParabolaHasItsClosedFormRadius) {
    for (const double r : {1.0, 0.1, 3e-3}) {
        const Cubic hairpin = RandomCubics::hairpin(r);
        const ConvergenceRadius radius(hairpin);
        EXPECT_NEAR(radius(0.5) / r, M_PI / 4, 1e-6) << r;
        for (const double u : {0.501, 0.52, 0.6, 0.9}) {
            // y = x^2 enlarged by 2 r: path from the vertex.
            const double x = std::sqrt(160 * r) / (2 * r) * (u - 0.5);
            const double sigma = 2 * r * (x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4);
            const double exact = std::hypot(sigma, M_PI / 4 * r);
            EXPECT_NEAR(radius(u) / exact, 1, 1e-6) << r << " at " << u;
            EXPECT_LT(step_limit(hairpin, u), exact) << r << " at " << u;
        }
    }
}

// The radius that the coefficients themselves show: |u_n|^(-1/n), corrected for the exponent 2/3 of
// the branch point, u_n ~ n^(-5/3) rho^-n.
TEST(StepLimit, RadiusIsThatOfTheSeries) {
    RandomCubics random(32);
    constexpr int kOrder = 160;
    for (int n = 0; n < 100; ++n) {
        const Cubic cubic = some_cubic(random, n);
        const double u = random.uniform(0, 1);
        const double radius = ConvergenceRadius(cubic)(u);
        // Lengths by the radius, so that coefficients stay near 1.
        const Cubic scaled{cubic.a / radius, cubic.b / radius, cubic.c / radius, cubic.d / radius};
        auto network = interpret<double>(kSpline, kOrder, spline_parameters<double>(scaled));
        const auto series = network.expand(spline_state(scaled, u))[spline_node::kU];
        double seen = HUGE_VAL;
        for (int i = kOrder - 20; i <= kOrder; ++i) {
            const double term =
                std::abs(series[static_cast<std::size_t>(i)]) / series[1] * std::pow(i, 5.0 / 3);
            seen = std::min(seen, std::pow(term, -1.0 / i));
        }
        EXPECT_NEAR(seen, 1, 0.03) << n;
    }
}

TEST(StepLimit, LinesAndCusps) {
    const Vec3 none = Vec3::Zero();
    const Cubic line{none, none, Vec3(1, 2, 2), none};
    EXPECT_EQ(step_limit(line, 0.3), HUGE_VAL);
    EXPECT_EQ(step_limit(Cubic{none, Vec3(1, 2, 2), none, none}, 0), 0);
    EXPECT_EQ(step_limit(Cubic{}, 0.5), 0);
    // A line with growing speed V = 3 (1 + 2 u): h = (sqrt 2 - 1) / 6 * 9, the pole 1/2 before u.
    const Cubic faster{none, Vec3(1, 2, 2), Vec3(1, 2, 2), none};
    EXPECT_NEAR(step_limit(faster, 0), (std::sqrt(2.0) - 1) * 9 / 6, 1e-15);
}

}  // namespace curvecore::ref::step_limit_test
