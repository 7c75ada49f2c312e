// SPDX-License-Identifier: Apache-2.0
// Cubic curves: derivatives against difference quotients in 60 digits, the range of the speed
// against a scan, parts and control points against the whole.
#include "ref/curve/cubic.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tb/support/judge/precise_cubic.hpp"
#include "tb/support/segments/cubics.hpp"

namespace curvecore::ref::cubic_test {

using tb::Precise;
using tb::PreciseCubic;
using tb::PreciseVector;
using tb::RandomCubics;

double size(const Cubic& cubic) {
    return cubic.a.norm() + cubic.b.norm() + cubic.c.norm() + cubic.d.norm();
}

TEST(Cubic, DerivativesAreDifferenceQuotients) {
    RandomCubics random(1);
    const Precise h("1e-15");
    const Precise outer("1e-9");
    for (int n = 0; n < 200; ++n) {
        const Cubic cubic = random.bezier();
        const PreciseCubic exact(cubic);
        const double u = random.uniform(0, 1);
        const auto bend = [&](const Precise& at) -> PreciseVector {
            return (exact.tangent(at + h) - exact.tangent(at - h)) / (2 * h * exact.speed(at));
        };
        const PreciseVector rate =
            (bend(u + outer) - bend(u - outer)) / (2 * outer * exact.speed(u));
        EXPECT_LT((tangent(cubic, u) - exact.tangent(u).cast<double>()).norm(), 1e-13);
        const Vec3 k = curvature_vector(cubic, u);
        const double scale = cubic.acceleration(u).norm() / std::pow(cubic.speed(u), 2);
        EXPECT_LT((k - bend(u).cast<double>()).norm(), 1e-13 * scale) << n;
        EXPECT_NEAR(curvature(cubic, u), k.norm(), 1e-13 * scale) << n;
        const double rate_scale = scale * scale + cubic.jerk().norm() / std::pow(cubic.speed(u), 3);
        EXPECT_LT((curvature_rate(cubic, u) - rate.cast<double>()).norm(), 1e-11 * rate_scale) << n;
    }
}

TEST(Cubic, ParabolaHasItsKnownCurvature) {
    const Cubic parabola{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 5}};
    for (const double u : {0.0, 0.25, 1.0}) {
        const double v2 = 1 + 4 * u * u;
        const double k = 2 / std::pow(v2, 1.5);
        EXPECT_NEAR(curvature(parabola, u), k, 1e-15);
        // dk/ds = -24 u / (1 + 4 u^2)^3, along the normal; -k^2 along the tangent.
        const Vec3 t = tangent(parabola, u);
        const Vec3 normal(-t.y(), t.x(), 0);
        const Vec3 expected = -k * k * t - 24 * u / (v2 * v2 * v2) * normal;
        EXPECT_LT((curvature_rate(parabola, u) - expected).norm(), 1e-14) << u;
    }
}

TEST(Cubic, SpeedRangeAgreesWithAScan) {
    RandomCubics random(2);
    for (int n = 0; n < 2000; ++n) {
        const Cubic cubic = random.any(n);
        const SpeedRange range = speed_range(cubic);
        ASSERT_EQ(cubic.speed(range.at_min), range.min);
        ASSERT_EQ(cubic.speed(range.at_max), range.max);
        double low = HUGE_VAL;
        double high = 0;
        constexpr int kPoints = 500;
        for (int i = 0; i <= kPoints; ++i) {
            const double speed = cubic.speed(double(i) / kPoints);
            low = std::min(low, speed);
            high = std::max(high, speed);
        }
        const double rounding = 1e-14 * high;
        ASSERT_LE(range.min, low + rounding) << n;
        ASSERT_GE(range.max, high - rounding) << n;
        // Between two points of the scan the speed changes by at most |W| times half their
        // distance.
        const double change =
            std::max(cubic.acceleration(0).norm(), cubic.acceleration(1).norm()) / kPoints / 2;
        ASSERT_GE(range.min, low - change) << n;
        ASSERT_LE(range.max, high + change) << n;
    }
}

TEST(Cubic, SpeedTurnsAtMostThreeTimes) {
    // V = (u^2 - u + 0.1, 0.15, 0) : |V| falls, rises, falls, rises.
    const Cubic waves{{1.0 / 3, 0, 0}, {-0.5, 0, 0}, {0.1, 0.15, 0}, {0, 0, 0}};
    const std::vector<double> extrema = speed_extrema(waves);
    ASSERT_EQ(extrema.size(), 3u);
    const double root = std::sqrt(0.15);
    EXPECT_NEAR(extrema[0], 0.5 - root, 1e-15);
    EXPECT_NEAR(extrema[1], 0.5, 1e-15);
    EXPECT_NEAR(extrema[2], 0.5 + root, 1e-15);
    EXPECT_EQ(speed_range(waves).min, 0.15);
}

TEST(Cubic, SpeedRangeOfDegenerateCurves) {
    const Vec3 one(1, 2, 2);
    const Vec3 none = Vec3::Zero();
    const auto range = [](const Cubic& cubic) {
        const SpeedRange found = speed_range(cubic);
        return std::array<double, 4>{found.min, found.max, found.at_min, found.at_max};
    };
    using Expected = std::array<double, 4>;
    EXPECT_EQ(range({none, none, none, one}), (Expected{0, 0, 0, 0})) << "a point";
    EXPECT_EQ(range({none, none, one, one}), (Expected{3, 3, 0, 0})) << "uniform";
    EXPECT_EQ(range({none, one, none, one}), (Expected{0, 6, 0, 1})) << "from rest, once doubled";
    EXPECT_EQ(range({one, none, none, one}), (Expected{0, 9, 0, 1})) << "from rest, twice doubled";
    EXPECT_EQ(range({none, one, -2 * one, one}), (Expected{0, 6, 1, 0})) << "to rest";
    EXPECT_EQ(range({none, one, -one, one}), (Expected{0, 3, 0.5, 0})) << "there and back";
    EXPECT_EQ(range({1e-300 * one, none, one, one}), (Expected{3, 3, 0, 0})) << "underflow";
}

TEST(Cubic, CuspsAreFoundWhereverTheyLie) {
    RandomCubics random(3);
    for (int n = 0; n < 1000; ++n) {
        const double u0 = n < 100 ? n % 2 : random.uniform(0, 1);
        const Cubic cusp = random.slow_at(u0, 0);
        EXPECT_TRUE(has_cusp(cusp)) << n;
        EXPECT_NEAR(speed_range(cusp).at_min, u0, 1e-7) << n;
        EXPECT_FALSE(has_cusp(random.bezier())) << n;
    }
    EXPECT_TRUE(has_cusp(Cubic{}));
    EXPECT_FALSE(has_cusp(RandomCubics::hairpin(1e-9)));
    EXPECT_TRUE(has_cusp(RandomCubics::hairpin(1e-9), 1e-3));
}

TEST(Cubic, PartsAreTheWhole) {
    RandomCubics random(4);
    for (int n = 0; n < 2000; ++n) {
        const Cubic cubic = random.any(n);
        const double u0 = random.uniform(0, 1);
        const double u1 = n % 2 == 0 ? random.uniform(0, 1) : u0 + random.log_uniform(1e-9, 0.1);
        const Cubic part = sub_cubic(cubic, u0, u1);
        const double ulp = std::ldexp(size(cubic), -52);
        ASSERT_EQ(part.position(0), cubic.position(u0));
        ASSERT_LT((part.position(1) - cubic.position(u1)).norm(), 8 * ulp) << n;
        for (const double t : {0.0, 0.3, 1.0}) {
            const double u = u0 + t * (u1 - u0);
            ASSERT_LT((part.position(t) - cubic.position(u)).norm(), 8 * ulp) << n;
            ASSERT_LT((part.velocity(t) - (u1 - u0) * cubic.velocity(u)).norm(),
                      32 * ulp * std::abs(u1 - u0))
                << n;
        }
    }
    const Cubic cubic = random.bezier();
    const Cubic same = sub_cubic(cubic, 0, 1);
    EXPECT_EQ(same.a, cubic.a);
    EXPECT_EQ(same.b, cubic.b);
    EXPECT_EQ(same.c, cubic.c);
    EXPECT_EQ(same.d, cubic.d);
}

TEST(Cubic, ControlPointsGoThereAndBack) {
    RandomCubics random(5);
    for (int n = 0; n < 1000; ++n) {
        const Bezier points{random.vector(), random.vector(), random.vector(), random.vector()};
        const Cubic cubic = from_bezier(points);
        const Bezier back = to_bezier(cubic);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_LT((back[i] - points[i]).norm(), 4e-15) << n;
        }
        EXPECT_EQ(cubic.position(0), points[0]);
        EXPECT_LT((cubic.position(1) - points[3]).norm(), 4e-15);
        // The tangents at the ends lead along the control polygon; its middle weighs 3/8 twice.
        EXPECT_LT((cubic.velocity(0) - 3 * (points[1] - points[0])).norm(), 1e-14);
        EXPECT_LT((cubic.velocity(1) - 3 * (points[3] - points[2])).norm(), 2e-14);
        const Vec3 middle = (points[0] + 3 * points[1] + 3 * points[2] + points[3]) / 8;
        EXPECT_LT((cubic.position(0.5) - middle).norm(), 2e-15);
    }
}

}  // namespace curvecore::ref::cubic_test
