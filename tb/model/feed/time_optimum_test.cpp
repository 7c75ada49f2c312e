// SPDX-License-Identifier: Apache-2.0
// The fastest motion along a path: against the seven phases of a line, on circles, at every place.
#include "ref/feed/optimum/time_optimum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ref/feed/ramps/ramp.hpp"
#include "ref/feed/windows/sliding.hpp"

namespace curvecore::tb::time_optimum_test {

using ref::KnotMotion;
using ref::PathInterval;
using ref::PlaceLimit;
using ref::TimeOptimum;

constexpr double kVelocity = 500;
constexpr double kAcceleration = 5000;
constexpr double kJerk = 1e5;

/// Limit on a circle of curvature k; 0: a line.
PlaceLimit limit(double k) { return {1, 0, -k * k, k * k, 0, k * k * k * k, kAcceleration, kJerk}; }

struct Path {
    std::vector<PathInterval> path;
    std::vector<KnotMotion> start;

    /// Optimum in windows of `window` intervals, of which a half is kept.
    std::vector<KnotMotion> optimum(std::size_t window = 1 << 20) const {
        TimeOptimum optimum(path, start);
        const std::size_t end = path.size() - 1;
        EXPECT_TRUE(optimum.slow_down(1, end));
        for (std::size_t first = 1; first < end; first += window / 2) {
            optimum.improve(first, std::min(end, first + window), 0.5, 0.002);
        }
        return motion(optimum);
    }
    static std::vector<KnotMotion> motion(const TimeOptimum& optimum) {
        std::vector<KnotMotion> knots;
        for (std::size_t k = 0; k <= optimum.intervals(); ++k) {
            knots.push_back(optimum.spline().knot(k));
        }
        return knots;
    }
};

/// Knots, even in time, of a smooth motion of `seconds`; curvature(place) is that of the path.
template <class Curvature>
Path path_along(double length, Curvature curvature, int n, double seconds) {
    Path run;
    const auto place = [&](double u) { return length * u * u * u * (10 - 15 * u + 6 * u * u); };
    for (int i = 0; i <= n; ++i) {
        const double u = 1. * i / n;
        const double v = length * 30 * u * u * (1 - u) * (1 - u) / seconds;
        const double a = length * 60 * u * (1 - u) * (1 - 2 * u) / (seconds * seconds);
        run.start.push_back({v * v, a});
        if (i == n) break;
        PathInterval interval;
        interval.length = place(1. * (i + 1) / n) - place(u);
        interval.start_velocity = interval.velocity = interval.end_velocity = kVelocity;
        const PlaceLimit seen = limit(curvature(place(u) + interval.length / 2));
        interval.places = {{interval.length / 2, i == 0 || i == n - 1, true, seen, 1},
                           {interval.length, true, false, seen, 1}};
        run.path.push_back(interval);
    }
    return run;
}

Path path_of(double length, double k, int n = 400, double seconds = 0.5) {
    return path_along(
        length, [k](double /*s*/) { return k; }, n, seconds);
}

double duration(const Path& run, const std::vector<KnotMotion>& motion) {
    double time = 0;
    for (std::size_t i = 0; i < run.path.size(); ++i) {
        const double h = run.path[i].length;
        if (i == 0 || i + 1 == run.path.size()) {
            time += 3 * h / std::sqrt(std::max(motion[i].q, motion[i + 1].q));
            continue;
        }
        const double bend = (motion[i + 1].a - motion[i].a) / h;
        for (int part = 0; part < 40; ++part) {
            const double s = (part + 0.5) / 40 * h;
            time += h / 40 / std::sqrt(motion[i].q + (2 * motion[i].a + bend * s) * s);
        }
    }
    return time;
}

TEST(TimeOptimum, OfALineIsItsSevenPhases) {
    for (const double length : {1., 10., 100., 300.}) {
        const double peak = ref::peak_speed(0, 0, length, kAcceleration, kJerk, kVelocity);
        const ref::Ramp ramp(0, peak, kAcceleration, kJerk);
        const double best = 2 * ramp.duration() + (length - 2 * ramp.length()) / peak;
        const Path line = path_of(length, 0);
        const double time = duration(line, line.optimum());
        EXPECT_GE(time, best * (1 - 1e-4)) << length;
        EXPECT_LE(time, best * 1.005) << length;
    }
}

// The values were found by collocation with a separate interior-point method, on three grids.
TEST(TimeOptimum, OfACircleFromRestToRest) {
    for (const auto& [radius, best] : {std::pair(25., 0.5820), std::pair(2., 0.2404)}) {
        const Path circle = path_of(2 * M_PI * radius, 1 / radius);
        const double time = duration(circle, circle.optimum());
        EXPECT_GE(time, best * 0.999) << radius;
        EXPECT_LE(time, best * 1.005) << radius;
    }
}

TEST(TimeOptimum, KeepsEveryLimitAndUsesOne) {
    const Path circle = path_of(2 * M_PI * 5, 1. / 5);
    const std::vector<KnotMotion> motion = circle.optimum();
    int tight = 0;
    for (std::size_t i = 1; i + 1 < circle.path.size(); ++i) {
        const double h = circle.path[i].length;
        const double bend = (motion[i + 1].a - motion[i].a) / h;
        const double q = motion[i].q + motion[i].a * h + bend * h * h / 4;
        const double a = motion[i].a + bend * h / 2;
        const double v = std::sqrt(q);
        const double jerk = ref::jerk_of(limit(1. / 5), v, a, v * bend) / kJerk;
        const double acceleration =
            ref::acceleration_of(limit(1. / 5), std::sqrt(motion[i].q), motion[i].a) /
            kAcceleration;
        EXPECT_LE(jerk, 1);
        EXPECT_LE(acceleration, 1);
        EXPECT_LE(motion[i].q, kVelocity * kVelocity);
        tight += jerk > 0.97 || acceleration > 0.97 ? 1 : 0;
    }
    EXPECT_GE(tight, 360);
}

TEST(TimeOptimum, MindsAJointsVelocity) {
    Path line = path_of(100, 0);
    line.path[199].end_velocity = 20;
    const std::vector<KnotMotion> motion = line.optimum();
    EXPECT_LE(std::sqrt(motion[200].q), 20);
    EXPECT_GE(std::sqrt(motion[200].q), 19.5);
    EXPECT_GE(std::sqrt(motion[150].q), 100);
}

TEST(TimeOptimum, ComesFromARoughStart) {
    Path line = path_of(100, 0);
    const double smooth = duration(line, line.optimum());
    for (std::size_t i = 1; i + 1 < line.start.size(); ++i) {
        line.start[i].q *= i % 3 == 0 ? 0.2 : 1;
        line.start[i].a = 0;
    }
    EXPECT_LE(duration(line, line.optimum()), 1.005 * smooth);
}

/// The motion slows only around a place that is too fast.
TEST(TimeOptimum, SlowsDownWhereItMust) {
    Path line = path_of(100, 0, 400, 1);
    line.path[199].end_velocity = 20;
    TimeOptimum optimum(line.path, line.start);
    ASSERT_TRUE(optimum.slow_down(1, line.path.size() - 1));
    const std::vector<KnotMotion> motion = Path::motion(optimum);
    EXPECT_LE(std::sqrt(motion[200].q), 20);
    EXPECT_GE(std::sqrt(motion[200].q), 12);
    for (const std::size_t far : {60U, 340U}) {
        EXPECT_GE(motion[far].q, 0.9 * line.start[far].q) << far;
    }
}

/// A window as long as a stop loses almost nothing, a shorter one much.
TEST(TimeOptimum, InWindowsIsNearlyTheWhole) {
    const auto wave = [](double s) { return 0.3 * std::sin(s / 3); };
    const Path path = path_along(300, wave, 1200, 4);
    const double whole = duration(path, path.optimum());
    EXPECT_LE(duration(path, path.optimum(160)), 1.005 * whole);
    EXPECT_GE(duration(path, path.optimum(10)), 1.02 * whole);
}

TEST(TimeOptimum, TakesTheShareOfAnInterval) {
    const Path line = path_of(20, 0);
    TimeOptimum optimum(line.path, line.start);
    for (std::size_t k = 190; k < 210; ++k) optimum.ease(k, 0.5, 1);
    ASSERT_TRUE(optimum.slow_down(1, line.path.size() - 1));
    optimum.improve(1, line.path.size() - 1, 0.5, 0.002);
    for (std::size_t k = 1; k + 1 < line.path.size(); ++k) {
        EXPECT_LE(optimum.load(k), k >= 190 && k < 210 ? 0.5 : 1) << k;
    }
    EXPECT_GE(optimum.load(200), 0.48);
    EXPECT_GE(optimum.load(100), 0.96);
}

TEST(Sliding, LeastAndMean) {
    const std::vector<double> values{5, 3, 8, 1, 9, 9, 9, 2};
    EXPECT_EQ(ref::sliding_least(values, 1), (std::vector<double>{3, 3, 1, 1, 1, 9, 2, 2}));
    EXPECT_EQ(ref::sliding_least(values, 9), std::vector<double>(8, 1));
    EXPECT_EQ(ref::sliding_mean({1, 2, 6, 4}, 1), (std::vector<double>{1.5, 3, 4, 5}));
}

}  // namespace curvecore::tb::time_optimum_test
