// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/time_optimum.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/sliding.hpp"
#include "ref/feed/time_barrier.hpp"

namespace curvecore::ref {
namespace {

constexpr double kKept = 0.995;      // of a limit: what is slowed down
constexpr double kInside = 0.98;     // of it: what that leads to
constexpr std::size_t kNearby = 3;   // intervals to both sides that are slowed down first
constexpr double kStage = 11.2;      // by which the weight of the time grows
constexpr int kMostSteps = 30;       // of Newton's method in a stage
constexpr double kCentred = 0.1;     // half the square of Newton's decrement
constexpr double kLeastStep = 1e-6;  // of one of Newton's

std::vector<double> lengths(const std::vector<PathInterval>& path) {
    std::vector<double> lengths;
    lengths.reserve(path.size());
    for (const PathInterval& interval : path) lengths.push_back(interval.length);
    return lengths;
}

/// Makes the barrier as low as it can be.
void centre(const TimeBarrier& barrier, SpeedSpline& spline, std::size_t first, std::size_t last,
            double weight) {
    const std::size_t count = last - first;
    BandMatrix<2> hessian(count);
    std::vector<double> gradient;
    std::vector<double> direction;
    std::vector<double> from(count);
    double here = barrier.value(spline, weight);
    for (int step = 0; step < kMostSteps; ++step) {
        barrier.differentiate(spline, weight, gradient, hessian);
        direction = gradient;
        hessian.decompose();
        hessian.solve(direction);
        double decrement = 0;
        for (std::size_t i = 0; i < count; ++i) decrement += gradient[i] * direction[i];
        if (!(decrement > 2 * kCentred)) return;
        for (std::size_t i = 0; i < count; ++i) from[i] = spline.control(first + i);
        for (double part = 1;; part /= 2) {
            if (part < kLeastStep) part = 0;
            for (std::size_t i = 0; i < count; ++i) {
                spline.control(first + i) = from[i] - part * direction[i];
            }
            if (part == 0) return;
            const double there = barrier.value(spline, weight);
            if (there <= here - 0.1 * part * decrement) {
                here = there;
                break;
            }
        }
    }
}

}  // namespace

TimeOptimum::TimeOptimum(std::vector<PathInterval> path, const std::vector<KnotMotion>& start)
    : path_(std::move(path)), spline_(lengths(path_), start) {}

void TimeOptimum::ease(std::size_t k, double share, double speed) {
    path_[k].share = share;
    path_[k].speed = speed;
}

bool TimeOptimum::slow_down(std::size_t first, std::size_t last) {
    const std::size_t count = last - first;
    std::vector<double> before;
    for (std::size_t k = first; k < last; ++k) before.push_back(spline_.control(k));
    for (std::size_t width = kNearby;; width *= 2) {
        std::vector<double> factor(count, 1);
        bool kept = true;
        for (std::size_t k = first - 1; k <= last; ++k) {
            if (slower(path_, spline_, k, kKept) >= 1) continue;
            kept = false;
            const double needed = std::min(1.0, slower(path_, spline_, k, kInside));
            for (std::size_t i = std::max(k, first + 1) - 1; i < std::min(k + 2, last); ++i) {
                factor[i - first] = std::min(factor[i - first], needed);
            }
        }
        if (kept) return true;
        if (width > 2 * count) {
            for (std::size_t i = 0; i < count; ++i) spline_.control(first + i) = before[i];
            return false;
        }
        const std::vector<double> smooth =
            sliding_mean(sliding_mean(sliding_least(factor, 2 * width), width), width);
        for (std::size_t i = 0; i < count; ++i) spline_.control(first + i) *= smooth[i];
    }
}

void TimeOptimum::improve(std::size_t first, std::size_t last, double from, double to) {
    for (double share = from;; share = std::max(share / kStage, to)) {
        for (std::size_t k = first - 1; k <= last; ++k) set_means(path_, spline_, k);
        const TimeBarrier barrier(path_, spline_, first, last);
        const double weight =
            static_cast<double>(barrier.rooms()) / (share * barrier.time(spline_));
        centre(barrier, spline_, first, last, weight);
        if (share <= to) return;
    }
}

}  // namespace curvecore::ref
