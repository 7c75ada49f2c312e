// SPDX-License-Identifier: Apache-2.0
// Sample period that a core keeps, from the clocks at which its samples came.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hls/clocks.hpp"

namespace curvecore::sysc {

/// Samples came as fast as the core could make them. With samples taken at a period of T clocks
/// instead, and requests always waiting, sample n is due (n - k) T after sample k, and the `ahead`
/// samples that the core holds cover as many periods. So time is kept if for all k < n
///
///     clock[n] - clock[k] <= (n - k + ahead) T
///
/// and the least T is the largest slope from (k, clock[k]) to (n + ahead, clock[n]): k is a
/// corner of the lower convex hull of the points before n.
///
/// If a core makes steps beside the samples, `sample` is called only for the first sample of each
/// step: at the others the core runs ahead of T without making a step earlier.
class SamplePace {
  public:
    /// Creates a pace; `ahead`: samples that the core holds, hls::samples_ahead().
    explicit SamplePace(int ahead) : ahead_(ahead) {}

    void sample(std::uint64_t n, std::uint64_t clock) {
        const Point due{static_cast<double>(n) + ahead_, static_cast<double>(clock)};
        if (!hull_.empty()) period_ = std::max(period_, steepest(due));
        const Point point{static_cast<double>(n), static_cast<double>(clock)};
        while (hull_.size() > 1 &&
               slope(hull_[hull_.size() - 2], hull_.back()) >= slope(hull_.back(), point)) {
            hull_.pop_back();
        }
        hull_.push_back(point);
    }

    /// Returns the least T, clocks.
    double period() const { return period_; }

  private:
    struct Point {
        double n, clock;
    };

    static double slope(const Point& a, const Point& b) {
        return (b.clock - a.clock) / (b.n - a.n);
    }

    /// Slopes to a point on the right rise along the hull, then fall.
    double steepest(const Point& due) const {
        std::size_t low = 0;
        for (std::size_t high = hull_.size() - 1; low < high;) {
            const std::size_t middle = (low + high) / 2;
            if (slope(hull_[middle], due) < slope(hull_[middle + 1], due)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return slope(hull_[low], due);
    }

    std::vector<Point> hull_;
    int ahead_;
    double period_ = 0;
};

}  // namespace curvecore::sysc
