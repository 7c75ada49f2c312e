// SPDX-License-Identifier: Apache-2.0
// [Obukhov]'s search along the arc, as published and corrected.
#include <gtest/gtest.h>

#include "ref/curve/arc_length.hpp"
#include "ref/series/search_tables.hpp"
#include "ref/series/spline_tables.hpp"

namespace curvecore::tb::search_test {

using ref::SearchForm;

ref::Cubic spline(const std::string& name) {
    for (const ref::TestSpline& one : ref::test_splines()) {
        if (one.name == name) return one.cubic;
    }
    throw std::invalid_argument(name);
}

constexpr double kTick = 1000. / 60 * 0.01;  // mm in 10 ms at 1 m/min

TEST(Simpson, IsExactForSpeedsOfDegreeThree) {
    // r = u^4 / 4 is beyond a cubic; |r'| = 3 u^2 is not.
    const ref::Cubic line{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    EXPECT_NEAR(ref::simpson(line, 0, 1, 2), 1, 1e-15);
    EXPECT_NEAR(ref::simpson(line, 1, 0, 2), -1, 1e-15);
    EXPECT_NEAR(ref::simpson_runge(line, 0.2, 0.8, 1e-9).length, 0.512 - 0.008, 1e-15);
}

TEST(Simpson, DoublesUntilRungesEstimateIsBelowTheTolerance) {
    const auto intervals = [](const char* name, double tolerance) {
        return ref::simpson_runge(spline(name), 0, 1, tolerance).intervals;
    };
    EXPECT_EQ(intervals("gentle 2D", 1e-3), 8);
    EXPECT_EQ(intervals("gentle 2D", 1e-6), 64);
    EXPECT_EQ(intervals("corner", 1e-3), 16);
    EXPECT_EQ(intervals("corner", 1e-6), 32);
    EXPECT_EQ(intervals("hairpin 1", 1e-3), 32);
    EXPECT_EQ(intervals("hairpin 1", 1e-6), 128);
    EXPECT_EQ(intervals("hairpin 0.1", 1e-3), 64);
    EXPECT_EQ(intervals("hairpin 0.1", 1e-6), 256);
}

/// The paper's rule stops too early; the check of this test is another quadrature.
TEST(Simpson, StopsTooEarlyOnOneCubicInSix) {
    const ref::FalseStops two = ref::false_stops(1e-3, 2, 5000);
    EXPECT_NEAR(two.share, 0.159, 0.02);
    EXPECT_GT(two.worst, 0.1);
    const ref::FalseStops fine = ref::false_stops(1e-6, 2, 5000);
    EXPECT_NEAR(fine.share, 0.03, 0.015);
    EXPECT_LT(ref::false_stops(1e-3, 32, 5000).share, 0.03);
}

TEST(TickSearch, TakesTwoOrThreeIterations) {
    struct Expected {
        const char* name;
        double feed;
        double mean;
        int most;
    };
    const Expected all[] = {
        {"gentle 2D", 1.5, 2.00, 2},   {"gentle 2D", 6, 2.00, 2},   {"gentle 2D", 60, 2.75, 3},
        {"corner", 1.5, 2.38, 3},      {"corner", 6, 3.00, 3},      {"corner", 60, 5.00, 5},
        {"hairpin 1", 1.5, 2.19, 3},   {"hairpin 1", 6, 3.05, 4},   {"hairpin 1", 60, 4.5, 5},
        {"hairpin 0.1", 1.5, 2.22, 4}, {"hairpin 0.1", 6, 3.08, 4}, {"hairpin 0.1", 60, 4.5, 6}};
    for (const Expected& expected : all) {
        const ref::SearchRun run = ref::search_run(spline(expected.name), SearchForm::kMended, 1e-6,
                                                   expected.feed * kTick);
        EXPECT_NEAR(run.mean, expected.mean, 0.02) << expected.name << expected.feed;
        EXPECT_EQ(run.most, expected.most) << expected.name << expected.feed;
        EXPECT_LT(run.error, 2e-6) << expected.name << expected.feed;
    }
}

/// err < tolerance is also true of every step that went too far.
TEST(TickSearch, AsWrittenStopsAfterTheFirstStepTooFar) {
    const auto error = [](const char* name, SearchForm form) {
        return ref::search_run(spline(name), form, 1e-6, 6 * kTick).error;
    };
    EXPECT_NEAR(error("gentle 3D", SearchForm::kSigned), 0.031, 0.001);
    EXPECT_NEAR(error("corner", SearchForm::kSigned), 0.092, 0.001);
    EXPECT_NEAR(error("hairpin 1", SearchForm::kSigned), 0.24, 0.01);
    EXPECT_NEAR(error("hairpin 0.1", SearchForm::kSigned), 0.29, 0.01);
    EXPECT_GT(error("corner", SearchForm::kLiteral), 1);
}

/// Errors below the tolerance add up over a million ticks, unless lengths count from the start.
TEST(TickSearch, LengthsFromTheStartDoNotDrift) {
    for (const char* name : {"corner", "hairpin 0.1"}) {
        const ref::Cubic cubic = spline(name);
        const double ds = ref::ArcLength(cubic).length() / 1e6;
        EXPECT_LT(ref::search_run(cubic, SearchForm::kMended, 1e-6, ds).error, 1e-8);
        EXPECT_GT(ref::search_run(cubic, SearchForm::kSummed, 1e-6, ds).error, 5e-6);
    }
}

TEST(WordSearch, CostsAHundredProductsASample) {
    const ref::WordRun run = ref::word_run(spline("corner"), 34, 1e-6, 0.25);
    EXPECT_GT(run.products, 80);
    EXPECT_LT(run.products, 140);
    // More bits reduce the error, until one panel of Simpson's rule dominates.
    const auto error = [](int fraction) {
        return ref::word_run(spline("gentle 2D"), fraction, 1e-7, 2.5e-3).error;
    };
    EXPECT_GT(error(24), 10 * error(34));
    EXPECT_LT(error(34), 1e-4);
}

}  // namespace curvecore::tb::search_test
