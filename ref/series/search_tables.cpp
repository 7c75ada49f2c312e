// SPDX-License-Identifier: Apache-2.0
#include "ref/series/search_tables.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "ref/curve/arc_length.hpp"
#include "ref/series/word_search.hpp"

namespace curvecore::ref {
namespace {

constexpr double kCube = 10;  // mm

/// Visits the places of all ticks except the end: number, path.
template <class Visit>
void each_tick(double length, double ds, Visit visit) {
    for (long k = 1; static_cast<double>(k) * ds < length; ++k) visit(static_cast<double>(k) * ds);
}

}  // namespace

FalseStops false_stops(double tolerance, int first, int cubics) {
    std::mt19937 random(1);
    const auto coordinate = [&random] {
        return kCube * std::generate_canonical<double, 53>(random);
    };
    const auto point = [&] {
        Vec3 p;
        for (double& x : p) x = coordinate();
        return p;
    };
    FalseStops found;
    for (int i = 0; i < cubics; ++i) {
        Bezier control;
        for (Vec3& p : control) p = point();
        const Cubic cubic = from_bezier(control);
        const double error = std::abs(simpson_runge(cubic, 0, 1, tolerance, first).length -
                                      ArcLength(cubic).length());
        if (error <= tolerance) continue;
        found.share += 1.0 / cubics;
        found.worst = std::max(found.worst, error);
    }
    return found;
}

SearchRun search_run(const Cubic& cubic, SearchForm form, double tolerance, double ds) {
    const ArcLength exact(cubic);
    TickSearch search(cubic, form, tolerance);
    SearchRun run;
    long ticks = 0;
    each_tick(exact.length(), ds, [&](double s) {
        const double u = search.at(s);
        run.mean += search.iterations();
        run.most = std::max(run.most, search.iterations());
        run.error = std::max(run.error, std::abs(exact.path(u) - s));
        ++ticks;
    });
    run.mean /= static_cast<double>(std::max(ticks, 1L));
    return run;
}

WordRun word_run(const Cubic& cubic, int fraction, double tolerance, double ds) {
    const ArcLength exact(cubic);
    WordSearch search(cubic, fraction, tolerance);
    WordRun run;
    each_tick(exact.length(), ds, [&](double s) {
        run.error = std::max(run.error, std::abs(exact.path(search.at(s)) - s));
    });
    run.products = search.products_per_sample();
    return run;
}

}  // namespace curvecore::ref
