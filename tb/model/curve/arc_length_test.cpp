// SPDX-License-Identifier: Apache-2.0
// Path length and its inverse, slow and by table, against closed forms and 60 digits.
#include "ref/curve/arc_length.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tb/support/judge/precise_cubic.hpp"
#include "tb/support/segments/cubics.hpp"

namespace curvecore::ref::arc_length_test {

using tb::Precise;
using tb::PreciseCubic;
using tb::RandomCubics;

constexpr double kStated = 1e-13;  // of the length

// Length of y = x^2 from its vertex to x.
double parabola_length(double x) {
    return x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4;
}

TEST(ArcLength, ParabolaHasItsClosedForm) {
    const Cubic parabola{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
    const ArcLength table(parabola);
    for (const double u : {1e-9, 0.1, 0.5, 0.77, 1.0}) {
        const double s = parabola_length(u);
        EXPECT_NEAR(arc_length(parabola, 0, u), s, 1e-15);
        EXPECT_NEAR(table.path(u), s, 2e-15);
        EXPECT_NEAR(table.parameter(s), u, 2e-15);
        EXPECT_NEAR(parameter_at(parabola, s), u, 2e-15);
    }
}

TEST(ArcLength, HairpinsHaveTheirClosedForm) {
    for (const double r : {1.0, 0.1, 0.01, 3e-3, 1e-6, 1e-9}) {
        // (c t, 80 t^2) is y = x^2 enlarged to c^2 / 80 = 2 r.
        const Cubic hairpin = RandomCubics::hairpin(r);
        const double tip = std::sqrt(160 * r) / (2 * r);  // x of y = x^2 per t
        const double half = 2 * r * parabola_length(tip / 2);
        const ArcLength table(hairpin);
        EXPECT_NEAR(arc_length(hairpin, 0, 1) / half, 2, kStated) << r;
        EXPECT_NEAR(table.length() / half, 2, kStated) << r;
        for (const double t : {-0.3, -0.01, 0.2}) {
            const double s = half + 2 * r * parabola_length(t * tip);
            EXPECT_NEAR(table.path(t + 0.5), s, kStated * half) << r;
            EXPECT_NEAR(table.path(table.parameter(s)), s, kStated * half) << r;
        }
    }
}

// Along one direction the path is the distance run, turning points included.
TEST(ArcLength, StraightLineOfAnySpeedHasItsClosedForm) {
    const Vec3 along(2, -1, 2);  // of length 3
    const Cubic line{along, -1.5 * along, 0.625 * along, Vec3(7, 8, 9)};
    // du: 3 u^2 - 3 u + 0.625 = 3 (u - 0.5)^2 - 0.125 has two zeros.
    const double turn = std::sqrt(0.125 / 3);
    const auto x = [](double u) { return ((u - 1.5) * u + 0.625) * u; };
    const double up = x(0.5 - turn);
    const double down = up - x(0.5 + turn);
    const double total = 3 * (up + down + x(1) - x(0.5 + turn));
    const ArcLength table(line);
    EXPECT_NEAR(arc_length(line, 0, 1), total, 1e-15);
    EXPECT_NEAR(table.length(), total, 1e-15);
    EXPECT_NEAR(table.path(0.5), 3 * (2 * up - x(0.5)), 1e-15);
    for (const double u : {0.1, 0.5, 0.9}) {
        EXPECT_NEAR(table.parameter(table.path(u)), u, 1e-13) << u;
    }
    // At a turning point the parameter is as uncertain as the root of a rounding; the path is not.
    EXPECT_NEAR(table.path(table.parameter(3 * up)), 3 * up, 1e-15);

    const Cubic uniform{Vec3::Zero(), Vec3::Zero(), along, Vec3::Zero()};
    EXPECT_EQ(arc_length(uniform, 0.25, 0.75), 1.5);
    EXPECT_EQ(arc_length(uniform, 0.75, 0.25), -1.5);
    EXPECT_NEAR(ArcLength(uniform).parameter(1.2), 0.4, 1e-16);
}

TEST(ArcLength, AgreesWithSixtyDigits) {
    RandomCubics random(11);
    double worst = 0;
    for (int n = 0; n < 50; ++n) {
        const Cubic cubic = random.any(n);
        const ArcLength table(cubic);
        std::vector<Precise> split;
        for (const double u : speed_extrema(cubic)) {
            split.emplace_back(u);
        }
        const double u1 = n % 3 == 0 ? 1 : random.uniform(0, 1);
        const Precise exact = PreciseCubic(cubic).length(
            Precise(0), Precise(u1), Precise(table.length()) * Precise("1e-20"), split);
        const double by_table = static_cast<double>(abs(Precise(table.path(u1)) - exact));
        const double slow = static_cast<double>(abs(Precise(arc_length(cubic, 0, u1)) - exact));
        worst = std::max({worst, by_table / table.length(), slow / table.length()});
        EXPECT_LT(by_table, kStated * table.length()) << n;
        EXPECT_LT(slow, kStated * table.length()) << n;
    }
    EXPECT_GT(worst, 1e-17) << "nothing was compared";
}

TEST(ArcLength, TableAgreesWithQuadratureEverywhere) {
    RandomCubics random(12);
    for (int n = 0; n < 300; ++n) {
        const Cubic cubic = random.any(n);
        const ArcLength table(cubic);
        const double length = table.length();
        ASSERT_NEAR(length, arc_length(cubic, 0, 1), kStated * length) << n;
        for (int i = 0; i <= 10; ++i) {
            const double s = i % 2 == 0 ? length * i / 10 : random.uniform(0, length);
            const double u = table.parameter(s);
            ASSERT_NEAR(table.path(u), s, 2e-15 * length) << n;
            ASSERT_NEAR(arc_length(cubic, 0, u), s, kStated * length) << n;
        }
        const double s = random.uniform(0, length);
        ASSERT_NEAR(table.path(parameter_at(cubic, s)), s, kStated * length) << n;
    }
}

TEST(ArcLength, PathGrowsWithTheParameter) {
    RandomCubics random(13);
    for (int n = 0; n < 50; ++n) {
        const ArcLength table(random.any(n));
        double last = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double u = table.parameter(table.length() * i / 1000);
            ASSERT_GE(u, last) << n << " at " << i;
            last = u;
        }
        ASSERT_NEAR(table.path(last), table.length(), 2e-15 * table.length()) << n;
    }
}

TEST(ArcLength, EndsAndPoints) {
    RandomCubics random(14);
    const Cubic cubic = random.bezier();
    const ArcLength table(cubic);
    EXPECT_EQ(table.parameter(0), 0);
    EXPECT_EQ(table.parameter(-1), 0);
    EXPECT_EQ(table.parameter(table.length()), 1);
    EXPECT_EQ(table.parameter(2 * table.length()), 1);
    EXPECT_EQ(table.path(-0.1), 0);
    EXPECT_EQ(table.path(1), table.length());
    EXPECT_EQ(parameter_at(cubic, -1), 0);
    EXPECT_EQ(parameter_at(cubic, 2 * table.length()), 1);
    const ArcLength point(Cubic{});
    EXPECT_EQ(point.length(), 0);
    EXPECT_EQ(point.parameter(0), 0);
    EXPECT_EQ(point.path(0.5), 0);
    // A cusp at a knot of the table: the speed there is exactly 0.
    const ArcLength cusp(Cubic{{0, 0, 0}, {0, 4, 3}, {0, -4, -3}, {0, 0, 0}});
    EXPECT_EQ(cusp.length(), 2.5);
    EXPECT_EQ(cusp.parameter(1.25), 0.5);
    EXPECT_NEAR(cusp.parameter(0.5), (1 - std::sqrt(0.6)) / 2, 1e-15);
}

}  // namespace curvecore::ref::arc_length_test
