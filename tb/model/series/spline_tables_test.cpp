// SPDX-License-Identifier: Apache-2.0
// The paper's claims about splines, measured: figures of each table against those computed
// independently, and the laws of the methods.
#include "ref/series/spline_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ref/curve/arc_length.hpp"

namespace curvecore::ref::spline_tables_test {

using Method = SplineMethod;

Cubic named(const std::string& name) {
    for (const TestSpline& spline : test_splines()) {
        if (spline.name == name) {
            return spline.cubic;
        }
    }
    throw std::invalid_argument(name);
}

TEST(SplineTables, TestSplinesHaveTheirListedShapes) {
    struct Shape {
        const char* name;
        double length, radius, ratio;
    };
    for (const Shape& shape :
         {Shape{"gentle 2D", 45.8, 33.75, 1.108}, Shape{"gentle 3D", 20.2, 9.443, 1.329},
          Shape{"corner", 18.0, 2.652, 2.828}, Shape{"near cusp 0.3", 36.2, 0.3, 12.81},
          Shape{"hairpin 1", 43.0, 1, 6.40}, Shape{"hairpin 0.03", 40.1, 0.03, 36.5}}) {
        const Cubic cubic = named(shape.name);
        double sharpest = 0;
        for (int i = 0; i <= 1000; ++i) {
            sharpest = std::max(sharpest, curvature(cubic, i / 1000.0));
        }
        const SpeedRange range = speed_range(cubic);
        EXPECT_NEAR(arc_length(cubic, 0, 1), shape.length, 0.06) << shape.name;
        EXPECT_NEAR(1 / sharpest / shape.radius, 1, 2e-3) << shape.name;
        EXPECT_NEAR(range.max / range.min / shape.ratio, 1, 5e-3) << shape.name;
    }
}

struct TickCase {
    const char* name;
    double feed;
    double runge_kutta, propagated, renormalised;  // mm; 0: blows up
};

TEST(SplineTables, ErrorsOfATickOfTenMilliseconds) {
    for (const TickCase& test :
         {TickCase{"corner", 1.5, 3.5e-5, 1.1e-9, 6.6e-10},
          TickCase{"corner", 2.0, 1.07e-4, 1.2e-8, 6.9e-9},
          TickCase{"hairpin 1", 1.5, 9.9e-3, 2.13e-4, 2.06e-7},
          TickCase{"hairpin 1", 2.0, 4.3e-2, 2.15e-2, 3.3e-6},
          TickCase{"hairpin 0.3", 1.5, 49, 0, 4.3e-3}, TickCase{"hairpin 0.3", 2.0, 0, 0, 6.54e-2},
          TickCase{"near cusp 0.3", 1.5, 0, 0, 9.9e-3},
          TickCase{"near cusp 0.3", 2.0, 0, 0, 7.0e-2}}) {
        const Cubic cubic = named(test.name);
        const double step = tick_path(test.feed, kSplineTickMs);
        const auto check = [&](Method method, double expected) {
            const Deviation found = follow(cubic, method, 8, step);
            EXPECT_EQ(found.blow_up, expected == 0) << test.name << " at " << test.feed;
            if (expected != 0) {
                EXPECT_NEAR(found.position / expected, 1, 0.03) << test.name << " " << test.feed;
            }
        };
        check(Method::kRungeKutta, test.runge_kutta);
        check(Method::kPropagated, test.propagated);
        if (test.renormalised > 1e-9) {
            check(Method::kRenormalised, test.renormalised);
        }
    }
}

// "Unstable already at 1.5 to 2 m/min": so it is below 0.3 mm, but Runge-Kutta is not the cause.
TEST(SplineTables, SharpHairpinsBlowUpInAnyOrderButNotWithOneVariable) {
    const double step = tick_path(1.5, kSplineTickMs);
    const Cubic sharp = named("hairpin 0.1");
    EXPECT_TRUE(follow(sharp, Method::kRungeKutta, 4, step).blow_up);
    for (const int order : {6, 8, 12}) {
        EXPECT_TRUE(follow(sharp, Method::kPropagated, order, step).blow_up) << order;
    }
    EXPECT_NEAR(follow(named("hairpin 0.3"), Method::kScalar, 4, step).position, 3.3e-4, 0.1e-4);
    EXPECT_NEAR(follow(sharp, Method::kScalar, 4, step).position, 7.1e-3, 0.1e-3);
    EXPECT_NEAR(follow(named("hairpin 0.3"), Method::kRungeKutta, 4, step).feed, 5.1, 0.1);
    // A Newton step refines phi, but does not prevent the blow-up.
    EXPECT_TRUE(follow(sharp, Method::kNewton, 8, step).blow_up);
    EXPECT_NEAR(follow(named("hairpin 1"), Method::kNewton, 8, step).position, 2.06e-7, 0.05e-7);
}

TEST(SplineTables, LargestPeriodsForOneMicrometre) {
    const auto period = [](double radius, Method method, int order, double depth = 20) {
        return largest_step(hairpin(radius, depth), method, order) / tick_path(1.5, 1);
    };
    EXPECT_NEAR(period(0.3, Method::kRungeKutta, 4), 1.35, 0.15);
    EXPECT_NEAR(period(0.3, Method::kPropagated, 8), 2.8, 0.3);
    EXPECT_NEAR(period(0.3, Method::kPropagated, 12), 3.2, 0.3);
    EXPECT_NEAR(period(0.3, Method::kRenormalised, 8), 7.6, 0.8);
    EXPECT_NEAR(period(0.3, Method::kRenormalised, 12), 9.4, 0.8);
    EXPECT_NEAR(period(0.3, Method::kScalar, 4), 12.5, 0.3);
    // "T below 0.05 ms": sixteen variables by Runge-Kutta at 0.01 mm.
    EXPECT_NEAR(period(0.01, Method::kRungeKutta, 4, 5), 0.036, 0.001);
}

TEST(SplineTables, OrderHelpsWhileTheSeriesConverge) {
    const auto at_one_ms = [](double radius, Method method, int order) {
        return follow(hairpin(radius), method, order, tick_path(1.5, 1)).position;
    };
    EXPECT_NEAR(at_one_ms(0.3, Method::kRungeKutta, 4), 1.8e-4, 0.05e-4);
    EXPECT_NEAR(at_one_ms(0.3, Method::kPropagated, 4), 2.2e-4, 0.05e-4);
    EXPECT_NEAR(at_one_ms(0.3, Method::kPropagated, 6), 6.0e-7, 0.05e-7);
    EXPECT_NEAR(at_one_ms(0.3, Method::kPropagated, 8), 1.6e-9, 0.05e-9);
    EXPECT_NEAR(at_one_ms(0.1, Method::kPropagated, 6), 1.1e-2, 0.05e-2);
    EXPECT_NEAR(at_one_ms(0.1, Method::kPropagated, 12), 5.1e-4, 0.05e-4);
    EXPECT_TRUE(follow(hairpin(0.03), Method::kPropagated, 12, tick_path(1.5, 1)).blow_up);
}

TEST(SplineTables, OneStepFromAVertexByShareOfTheRadiusOfConvergence) {
    const auto expect = [](double share, int order, double expected, double tolerance) {
        EXPECT_NEAR(vertex_error(0.3, share, order) / expected, 1, tolerance)
            << share << " order " << order;
    };
    expect(0.1, 4, 9.7e-8, 0.01);
    expect(0.1, 8, 3.5e-12, 0.01);
    expect(0.1, 12, 1.87e-16, 0.01);
    expect(0.2, 8, 1.78e-9, 0.01);
    expect(0.5, 4, 2.92e-4, 0.01);
    expect(0.5, 8, 6.46e-6, 0.01);
    expect(0.5, 12, 2.14e-7, 0.01);
    expect(0.9, 8, 1.15e-3, 0.01);
    expect(0.9, 32, 9.4e-6, 0.01);
}

TEST(SplineTables, SinglePrecisionDriftsAwayUnlessPhiIsCorrected) {
    const Drift lost = drift(hairpin(0.01), Method::kPropagated, 5e-3, true);
    EXPECT_GT(lost.position, 100);
    EXPECT_GT(lost.phi, 10);
    const Drift held = drift(hairpin(0.01), Method::kNewton, 5e-3, true);
    EXPECT_LT(held.position, 1.3e-4);
    EXPECT_LT(std::abs(held.phi), 1e-6);
}

TEST(SplineTables, DoubleDriftsByItsRoundings) {
    const Drift found = drift(named("corner"), Method::kPropagated, 5e-5);
    EXPECT_EQ(found.steps, 360428);
    EXPECT_LT(found.position, 3e-12);
    EXPECT_NEAR(found.phi, -5e-14, 5e-14);
    EXPECT_NE(found.phi, 0);
}

TEST(SplineTables, RungeKuttaIsOfOrderFour) {
    const Cubic cubic = named("corner");
    for (const Method method : {Method::kRungeKutta, Method::kScalar}) {
        const double ratio =
            follow(cubic, method, 4, 0.1).position / follow(cubic, method, 4, 0.05).position;
        EXPECT_NEAR(std::log2(ratio), 4, 0.2);
    }
}

}  // namespace curvecore::ref::spline_tables_test
