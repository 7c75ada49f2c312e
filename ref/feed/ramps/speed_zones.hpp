// SPDX-License-Identifier: Apache-2.0
// Limits of zones, looked up along the path.
#pragma once

#include <algorithm>
#include <limits>

#include "ref/feed/ramps/zone_ramps.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {

constexpr double kSpeedSlack = 1 + 1e-9;  // a limit met is no limit violated
constexpr std::size_t kNoZone = std::numeric_limits<std::size_t>::max();

/// Zones as an array of places, with minima over any range of them in logarithmic time.
class Zones {
  public:
    explicit Zones(const std::vector<Zone>& zones) {
        long double s = 0;
        for (const Zone& zone : zones) {
            // Equal neighbours are one zone: a bottleneck is as wide as it can be.
            if (!zone_.empty() && same(zone_.back(), zone)) {
                zone_.back().length += zone.length;
            } else {
                zone_.push_back(zone);
                start_.push_back(s);
            }
            s += zone.length;
        }
        start_.push_back(s);
        leaves_ = zone_.size();
        slowest_.resize(2 * leaves_);
        weakest_.resize(2 * leaves_);
        for (std::size_t i = 0; i < leaves_; ++i) {
            slowest_[leaves_ + i] = i;
            weakest_[leaves_ + i] = zone_[i];
        }
        for (std::size_t i = leaves_; i-- > 1;) {
            slowest_[i] = slower(slowest_[2 * i], slowest_[2 * i + 1]);
            weakest_[i] = weaker(weakest_[2 * i], weakest_[2 * i + 1]);
        }
    }

    std::size_t size() const { return zone_.size(); }
    const Zone& operator[](std::size_t i) const { return zone_[i]; }
    long double start(std::size_t i) const { return start_[i]; }
    long double end(std::size_t i) const { return start_[i + 1]; }

    /// Returns the slowest zone of [first, last], kNoZone if empty.
    std::size_t slowest(std::size_t first, std::size_t last) const {
        std::size_t best = kNoZone;
        each(first, last, [&](std::size_t node) { best = slower(best, slowest_[node]); });
        return best;
    }

    /// Returns the least acceleration and jerk and the highest speed of [first, last].
    Zone weakest(std::size_t first, std::size_t last) const {
        Zone all{0, 0, kUnlimitedChange, kUnlimitedChange};
        each(first, last, [&](std::size_t node) { all = weaker(all, weakest_[node]); });
        return all;
    }

    /// Returns the first zone that reaches beyond s, and the last zone that begins before s.
    std::size_t first_after(long double s) const {
        return std::upper_bound(start_.begin() + 1, start_.end(), s) - start_.begin() - 1;
    }
    std::size_t last_before(long double s) const {
        return std::lower_bound(start_.begin(), start_.end() - 1, s) - start_.begin() - 1;
    }

  private:
    static bool same(const Zone& a, const Zone& b) {
        return a.velocity == b.velocity && a.acceleration == b.acceleration && a.jerk == b.jerk;
    }
    std::size_t slower(std::size_t a, std::size_t b) const {
        if (a == kNoZone || b == kNoZone) return a == kNoZone ? b : a;
        return zone_[b].velocity < zone_[a].velocity ? b : a;
    }
    static Zone weaker(const Zone& a, const Zone& b) {
        return {0, std::max(a.velocity, b.velocity), std::min(a.acceleration, b.acceleration),
                std::min(a.jerk, b.jerk)};
    }
    template <class Visit>
    void each(std::size_t first, std::size_t last, Visit visit) const {
        if (last == kNoZone || first > last) return;
        std::size_t a = first + leaves_;
        std::size_t b = last + 1 + leaves_;
        for (; a < b; a /= 2, b /= 2) {
            if (a & 1) visit(a++);
            if (b & 1) visit(--b);
        }
    }

    std::vector<Zone> zone_;
    std::vector<long double> start_;  // one more than zones
    std::vector<std::size_t> slowest_;
    std::vector<Zone> weakest_;  // with velocity the highest
    std::size_t leaves_ = 0;
};

}  // namespace curvecore::ref
