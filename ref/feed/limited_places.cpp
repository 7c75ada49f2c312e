// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/limited_places.hpp"

#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kLeastPart = 0.1;
constexpr double kInside = 0.9999;

}  // namespace

double slower(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k,
              double share) {
    const PathMotion start = spline.motion(k);
    double slower = 1e9;
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
        [&](double x, const Eigen::Matrix3d& jerk, double most) {
            const PathMotion m = farther(start, x);
            const double square = m[0] * m.dot(jerk * m);
            slower =
                std::min(slower, std::cbrt(share * share * most * most / std::max(square, 1e-300)));
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
        [&](double x, const Eigen::Matrix3d& jerk, double most) {
            const PathMotion m = farther(start, x);
            worst = std::max(worst, m[0] * m.dot(jerk * m) / (most * most));
        });
    return share * std::sqrt(worst);
}

double speed_load(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k) {
    const PathInterval& on = path[k];
    const double q = std::max(spline.knot(k).q, spline.knot(k + 1).q);
    const double middle = spline.rests(k) ? 0 : farther(spline.motion(k), on.length / 2)[0];
    return std::sqrt(std::max(q, middle)) / std::min(on.velocity, on.end_velocity);
}

void set_means(std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t k) {
    if (spline.rests(k)) return;
    PathInterval& interval = path[k];
    const PathMotion start = spline.motion(k);
    const double middle = farther(start, interval.length / 2)[0];
    const std::vector<LimitedPlace> before = interval.places;
    for (double part = 1; part > kLeastPart; part /= 2) {
        for (std::size_t i = 0; i < before.size(); ++i) {
            const double wanted = std::sqrt(middle / farther(start, before[i].x)[0]);
            interval.places[i].mean = before[i].mean + part * (wanted - before[i].mean);
        }
        if (load(path, spline, k) < kInside * interval.share) return;
    }
    interval.places = before;
}

}  // namespace curvecore::ref
