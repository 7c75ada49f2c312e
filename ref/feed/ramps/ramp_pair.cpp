// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/ramps/ramp_pair.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace curvecore::ref {
namespace {

constexpr double kWorthwhile = 1.3;  // ratio to the least acceleration or jerk: no search below it

class PairSearch {
  public:
    PairSearch(const Zones& zones, const SpeedGap& gap)
        : zones_(zones),
          gap_(gap),
          first_(zones.first_after(gap.s0)),
          last_(zones.last_before(gap.s1)) {}

    RampPair run() {
        RampLimits up{gap_.acceleration, gap_.jerk};
        RampLimits down = up;
        const double cap = std::max({gap_.cap, gap_.v0, gap_.v1});
        RampPair best = pair(up, down, cap);
        if (last_ == kNoZone || first_ > last_) return best;
        RampLimits most{0, 0};
        double top = cap;
        for (std::size_t i = first_; i <= last_; ++i) {
            const Zone& zone = zones_[i];
            if (zone.length == 0) continue;  // a joint's acceleration is without limit
            most.acceleration = std::max(most.acceleration, zone.acceleration);
            most.jerk = std::max(most.jerk, zone.jerk);
            top = std::max(top, zone.velocity);
        }
        if (most.acceleration < kWorthwhile * gap_.acceleration &&
            most.jerk < kWorthwhile * gap_.jerk) {
            return best;
        }
        // Tries each side once more if the other has changed since.
        const auto improved = [&](RampLimits& side) {
            return improve(up, down, side, most, {cap, top}, best);
        };
        improved(up);
        if (improved(down) && improved(up)) improved(down);
        return best;
    }

  private:
    RampPair pair(const RampLimits& up, const RampLimits& down, double cap) const {
        const auto length = static_cast<double>(gap_.s1 - gap_.s0);
        const double peak = peak_speed(gap_.v0, gap_.v1, length, up, down, cap);
        RampPair pair{Ramp(gap_.v0, peak, up.acceleration, up.jerk),
                      Ramp(peak, gap_.v1, down.acceleration, down.jerk), peak, 0};
        pair.rest = length - pair.up.length() - pair.down.length();
        return pair;
    }

    /// Tries other limits for `side`, which is `up` or `down`. Returns true if some are better.
    bool improve(RampLimits& up, RampLimits& down, RampLimits& side, const RampLimits& most,
                 const std::array<double, 2>& caps, RampPair& best) const {
        RampLimits found = side;
        bool better = false;
        bool capped = true;  // else a higher cap changes nothing
        // Lower limits are slower: no jerk below one that is slower is tried.
        enum class Trial { kBetter, kForbidden, kSlower };
        const auto attempt = [&](double acceleration, double jerk, double cap) {
            side = {acceleration, jerk};
            const RampPair trial = pair(up, down, cap);
            capped = capped || trial.peak >= cap;
            if (trial.duration() >= best.duration()) return Trial::kSlower;
            if (trial.rest < 0 || !allowed(trial)) return Trial::kForbidden;
            best = trial;
            found = side;
            better = true;
            return Trial::kBetter;
        };
        for (const double share : {0.0, 0.5, 1.0}) {
            if (!std::exchange(capped, false)) break;
            const double cap = caps[0] * std::pow(caps[1] / caps[0], share);
            for (double jerk = most.jerk; jerk > most.jerk / 20; jerk /= 1.6) {
                if (attempt(most.acceleration, jerk, cap) != Trial::kForbidden) break;
                double low = gap_.acceleration;
                double high = most.acceleration;
                for (int i = 0; i < 5; ++i) {
                    const double middle = std::sqrt(low * high);
                    (attempt(middle, jerk, cap) == Trial::kForbidden ? high : low) = middle;
                }
            }
        }
        side = found;
        return better;
    }

    bool allowed(const RampPair& pair) const {
        const double length = static_cast<double>(gap_.s1 - gap_.s0);
        const double up = pair.up.length();
        const double down = length - pair.down.length();
        for (std::size_t i = first_; i <= last_; ++i) {
            const Zone& zone = zones_[i];
            const double from = static_cast<double>(std::max(zones_.start(i), gap_.s0) - gap_.s0);
            const double to = static_cast<double>(std::min(zones_.end(i), gap_.s1) - gap_.s0);
            if (to >= up && from <= down && zone.velocity * kSpeedSlack < pair.peak) return false;
            if (from < up && !allowed(pair.up, zone, from, std::min(to, up))) return false;
            if (to > down && !allowed(pair.down, zone, length - to, length - std::max(from, down)))
                return false;
        }
        return true;
    }

    /// Returns true if a zone allows a ramp, with from and to counted from its slow end.
    static bool allowed(const Ramp& ramp, const Zone& zone, double from, double to) {
        if (ramp.jerk_time == 0) return true;
        const double v = zone.velocity * kSpeedSlack;
        if (v < ramp.low || (v < ramp.high && ramp.length_to(v) < to)) return false;
        if (ramp.jerk > zone.jerk * kSpeedSlack) return false;
        if (ramp.jerk * ramp.jerk_time <= zone.acceleration * kSpeedSlack) return true;
        // The acceleration is beyond the zone's between these two speeds.
        const double change = zone.acceleration * zone.acceleration / (2 * ramp.jerk);
        return ramp.length_to(ramp.low + change) >= to ||
               ramp.length_to(ramp.high - change) <= from;
    }

    const Zones& zones_;
    const SpeedGap& gap_;
    std::size_t first_, last_;
};

}  // namespace

RampPair best_pair(const Zones& zones, const SpeedGap& gap) { return PairSearch(zones, gap).run(); }

}  // namespace curvecore::ref
