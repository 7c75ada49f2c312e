// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/limited_places.hpp"

#include <boost/container/small_vector.hpp>
#include <cmath>

#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

constexpr double kLeastPart = 0.1;
constexpr double kBinds = 0.9999;

}  // namespace

double slower(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k,
              double share) {
    const PathMotion start = spline.motion(k);
    double slower = kUnlimited;
    each_limit_at(
        path, spline, k,
        [&](double x, double v) {
            slower = std::min(slower, share * v * v / farther(start, x)[0]);
        },
        [&](double x, const PlaceLimit& limit, double most) {
            const PathMotion m = farther(start, x);
            const double square = acceleration_square(limit, m[0], m[1]);
            slower = std::min(slower, share * most / std::sqrt(std::max(square, 1e-300)));
        },
        [&](double x, const PlaceLimit& limit, double mean, double most) {
            const PathMotion m = farther(start, x);
            const double square = m[0] * jerk_product(limit, mean, m, m);
            const double cube = share * share * most * most / std::max(square, 1e-300);
            if (cube < slower * slower * slower) slower = std::cbrt(cube);
        });
    return slower;
}

double load(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k) {
    const PathMotion start = spline.motion(k);
    const double share = path[k].share;
    double worst = 0;  // square
    each_limit_at(
        path, spline, k, [](double /*x*/, double /*v*/) {},
        [&](double x, const PlaceLimit& limit, double most) {
            const PathMotion m = farther(start, x);
            worst = std::max(worst, acceleration_square(limit, m[0], m[1]) / (most * most));
        },
        [&](double x, const PlaceLimit& limit, double mean, double most) {
            const PathMotion m = farther(start, x);
            worst = std::max(worst, m[0] * jerk_product(limit, mean, m, m) / (most * most));
        });
    return share * std::sqrt(worst);
}

double speed_load(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k) {
    const PathInterval& on = path[k];
    const double middle = spline.rests(k) ? 0 : farther(spline.motion(k), on.length / 2)[0];
    return std::max({std::sqrt(spline.knot(k).q) / on.start_velocity,
                     std::sqrt(middle) / on.velocity,
                     std::sqrt(spline.knot(k + 1).q) / on.end_velocity});
}

void set_means(std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k) {
    if (spline.rests(k)) return;
    PathInterval& interval = path[k];
    const PathMotion start = spline.motion(k);
    const double middle = farther(start, interval.length / 2)[0];
    boost::container::small_vector<double, 16> before;
    boost::container::small_vector<double, 16> wanted;
    for (const LimitedPlace& place : interval.places) {
        before.push_back(place.mean);
        wanted.push_back(std::sqrt(middle / farther(start, place.x)[0]));
    }
    const auto set = [&](double part) {
        for (std::size_t i = 0; i < before.size(); ++i) {
            interval.places[i].mean = before[i] + part * (wanted[i] - before[i]);
        }
    };
    for (double part = 1; part > kLeastPart; part /= 2) {
        set(part);
        if (load(path, spline, k) < kBinds * interval.share) return;
    }
    set(0);
}

}  // namespace curvecore::ref
