// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/time_optimum.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/optimum/time_barrier.hpp"
#include "ref/feed/windows/sliding.hpp"
#include "ref/numeric/newton_work.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSlowedFrom = 0.995;  // share of a limit above which a place is slowed down
constexpr double kSlowedTo = 0.98;     // share of it that slowing down leads to
constexpr std::size_t kNearby = 3;     // intervals to both sides that are slowed down first
constexpr double kStage = 6.2;         // factor by which the weight of the time grows
constexpr int kMostSteps = 100;        // Newton steps in a stage
constexpr double kCentred = 0.1;       // half the square of Newton's decrement
constexpr double kLeastStep = 1e-6;    // share of a Newton step
constexpr double kLonger = 4;          // next step tried, as a multiple of the last one
constexpr double kHeld = 1e100;        // force that moves a control point by one, whatever holds it
constexpr double kLittle = 0.02;       // share of that which is as good as nothing
constexpr double kGain = 0.1;  // share of what Newton's method promises that a step must gain

std::vector<double> lengths(const std::vector<PathInterval>& path) {
    std::vector<double> lengths;
    lengths.reserve(path.size());
    for (const PathInterval& interval : path) lengths.push_back(interval.length);
    return lengths;
}

/// Moves the free control points to the minimum of the barrier.
class Descent {
  public:
    Descent(const TimeBarrier& barrier, SpeedSpline& spline, std::size_t first, std::size_t last)
        : barrier_(barrier), spline_(spline), first_(first), count_(last - first), by_(count_) {}

    /// Minimises the barrier by Newton's method.
    void centre(double weight) {
        double here = barrier_.value(spline_, weight);
        if (!std::isfinite(here)) return;
        double most = 1;
        for (int step = 0; step < kMostSteps; ++step) {
            newton_work() += count_;
            barrier_.differentiate(spline_, weight, by_);
            by_.hessian.decompose();
            std::vector<double> direction = by_.gradient;
            by_.hessian.solve(direction);
            double decrement = 0;
            for (std::size_t i = 0; i < count_; ++i) decrement += by_.gradient[i] * direction[i];
            if (!(decrement > 2 * kCentred)) return;
            const double part = go(direction, most, weight, here, kGain * decrement);
            if (part == 0) return;
            most = std::min(1.0, kLonger * part);
        }
    }

  private:
    /// Returns the part of the direction, `most` or less, that lowers the barrier from `here` by
    /// its part of `gain`; 0 if none does.
    double go(const std::vector<double>& direction, double most, double weight, double& here,
              double gain) {
        std::vector<double> from(count_);
        for (std::size_t i = 0; i < count_; ++i) from[i] = spline_.control(first_ + i);
        const auto set = [&](double part) {
            for (std::size_t i = 0; i < count_; ++i) {
                spline_.control(first_ + i) = from[i] - part * direction[i];
            }
        };
        for (double part = most; part >= kLeastStep; part /= 2) {
            set(part);
            const double there = barrier_.value(spline_, weight);
            if (!(there <= here - part * gain)) continue;
            here = there;
            return part;
        }
        set(0);
        return 0;
    }

    const TimeBarrier& barrier_;
    SpeedSpline& spline_;
    std::size_t first_, count_;
    TimeBarrier::Derivatives by_;
};

}  // namespace

TimeOptimum::TimeOptimum(std::vector<PathInterval> path, const std::vector<KnotMotion>& start)
    : path_(std::move(path)), spline_(lengths(path_), start) {}

TimeOptimum::State TimeOptimum::state(std::size_t first, std::size_t last) const {
    State state{first, {}, {}};
    for (std::size_t k = first; k < last; ++k) state.controls.push_back(spline_.control(k));
    for (std::size_t k = first - 1; k <= last; ++k) {
        for (const LimitedPlace& place : path_[k].places) state.means.push_back(place.mean);
    }
    return state;
}

void TimeOptimum::restore(const State& state) {
    const std::size_t last = state.first + state.controls.size();
    for (std::size_t k = state.first; k < last; ++k) {
        spline_.control(k) = state.controls[k - state.first];
    }
    auto mean = state.means.begin();
    for (std::size_t k = state.first - 1; k <= last; ++k) {
        for (LimitedPlace& place : path_[k].places) place.mean = *mean++;
    }
}

void TimeOptimum::ease(std::size_t k, double share, double speed) {
    path_[k].share = share;
    path_[k].speed = speed;
}

bool TimeOptimum::slow_down(std::size_t first, std::size_t last) {
    const std::size_t count = last - first;
    const State before = state(first, last);
    for (std::size_t width = kNearby;; width *= 2) {
        std::vector<double> factor(count, 1);
        bool kept = true;
        for (std::size_t k = first - 1; k <= last; ++k) {
            if (slower(path_, spline_, k, kSlowedFrom) >= 1) continue;
            kept = false;
            const double needed = std::min(1.0, slower(path_, spline_, k, kSlowedTo));
            for (std::size_t i = std::max(k, first + 1) - 1; i < std::min(k + 2, last); ++i) {
                factor[i - first] = std::min(factor[i - first], needed);
            }
        }
        if (kept) return true;
        if (width > 2 * count) {
            restore(before);
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
        Descent(barrier, spline_, first, last).centre(weight);
        if (share <= to) return;
    }
}

/// Finds how points move one another by second derivatives, since the barrier is flat there.
std::size_t TimeOptimum::led_by_end(std::size_t first, std::size_t last, double to) const {
    const TimeBarrier barrier(path_, spline_, first, last + 2);
    const std::size_t count = last + 2 - first;
    TimeBarrier::Derivatives by(count);
    newton_work() += count;
    barrier.differentiate(spline_,
                          static_cast<double>(barrier.rooms()) / (to * barrier.time(spline_)), by);
    std::vector<double> moved(count, 0);
    for (std::size_t i = count - 2; i < count; ++i) {
        by.hessian.add(i, i, kHeld);
        moved[i] = kHeld;
    }
    by.hessian.decompose();
    by.hessian.solve(moved);
    const auto led = std::find_if(moved.begin(), moved.end(),
                                  [](double by_one) { return std::abs(by_one) > kLittle; });
    return first + static_cast<std::size_t>(led - moved.begin());
}

}  // namespace curvecore::ref
