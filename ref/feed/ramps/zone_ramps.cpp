// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/ramps/zone_ramps.hpp"

#include <algorithm>

#include "ref/feed/ramps/ramp_pair.hpp"

namespace curvecore::ref {
namespace {

/// A stretch with settled end speeds and zero acceleration at both.
///
/// Invariant: the fastest motion with this acceleration and jerk violates only limits that are not
/// below v0 and v1.
struct Interval {
    long double s0, s1;
    double v0, v1;
    double acceleration, jerk;
    bool settled = false;  // violates nothing: ready to be drawn
    double cap = 0;        // settled: highest speed
};

class ZoneRamps {
  public:
    explicit ZoneRamps(const std::vector<Zone>& zones) : zones_(zones) {}

    std::vector<Phase> run() {
        const Zone all = zones_.weakest(0, zones_.size() - 1);
        todo_.push_back({0, zones_.end(zones_.size() - 1), 0, 0, all.acceleration, all.jerk});
        while (!todo_.empty()) {
            const Interval next = todo_.back();
            todo_.pop_back();
            if (next.settled) {
                draw(next);
            } else {
                split(next);
            }
        }
        return std::move(phases_);
    }

  private:
    struct Violation {
        std::size_t zone = kNoZone;
        double peak = 0;
    };

    /// The lowest limit that the fastest motion of an interval would violate.
    Violation violation(const Interval& in) const {
        const double length = static_cast<double>(in.s1 - in.s0);
        // Zones without length at the ends are met by v0 and v1.
        const std::size_t first = zones_.first_after(in.s0);
        const std::size_t last = zones_.last_before(in.s1);
        if (last == kNoZone || first > last) return {kNoZone, std::max(in.v0, in.v1)};
        const double top = std::max({zones_.weakest(first, last).velocity, in.v0, in.v1});
        const double peak = peak_speed(in.v0, in.v1, length, in.acceleration, in.jerk, top);
        const Ramp up(in.v0, peak, in.acceleration, in.jerk);
        const Ramp down(peak, in.v1, in.acceleration, in.jerk);
        const long double cruise0 = in.s0 + up.length();
        const long double cruise1 =
            std::max(cruise0, in.s1 - static_cast<long double>(down.length()));

        std::size_t worst = kNoZone;
        const auto consider = [&](std::size_t i) {
            if (zones_[i].velocity * kSpeedSlack >= peak) return;
            if (worst == kNoZone || zones_[i].velocity < zones_[worst].velocity) worst = i;
        };
        // Zones that touch the cruise, however short it is.
        std::size_t a = first;
        while (a < last && zones_.end(a) < cruise0) ++a;
        std::size_t b = last;
        while (b > a && zones_.start(b) > cruise1) --b;
        consider(zones_.slowest(a, b));
        // Zones on ramps: the motion is fastest at the end nearer to the peak.
        for (std::size_t i = first; i < a; ++i) {
            const double v = zones_[i].velocity;
            if (v * kSpeedSlack >= peak) continue;
            if (v < in.v0 || in.s0 + up.length_to(v * kSpeedSlack) < zones_.end(i)) consider(i);
        }
        for (std::size_t i = last; i > b; --i) {
            const double v = zones_[i].velocity;
            if (v * kSpeedSlack >= peak) continue;
            if (v < in.v1 || in.s1 - down.length_to(v * kSpeedSlack) > zones_.start(i)) consider(i);
        }
        return {worst, peak};
    }

    void split(Interval in) {
        // The zones inside may allow more than those around.
        Interval own = in;
        const std::size_t first = zones_.first_after(in.s0);
        const std::size_t last = zones_.last_before(in.s1);
        if (last != kNoZone && first <= last) {
            const Zone weakest = zones_.weakest(first, last);
            own.acceleration = weakest.acceleration;
            own.jerk = weakest.jerk;
        }
        Violation found = violation(own);
        if (found.zone != kNoZone && zones_[found.zone].velocity < std::max(in.v0, in.v1)) {
            found = violation(in);
        } else {
            in = own;
        }
        if (found.zone == kNoZone) {
            in.settled = true;
            in.cap = found.peak;
            todo_.push_back(in);
            return;
        }
        cut_at(in, found.zone);
    }

    /// Passes a zone at its limit; both ramps to that speed fit, since the peak is above it.
    void cut_at(const Interval& in, std::size_t zone) {
        const double v = std::max({zones_[zone].velocity, in.v0, in.v1});
        const long double m0 = zones_.start(zone);
        const long double m1 = zones_.end(zone);
        const long double up = in.s0 + Ramp(in.v0, v, in.acceleration, in.jerk).length();
        const long double down = std::max(
            up,
            in.s1 - static_cast<long double>(Ramp(v, in.v1, in.acceleration, in.jerk).length()));
        const auto part = [&](long double s0, long double s1, double v0, double v1, bool settled) {
            if (s1 > s0) todo_.push_back({s0, s1, v0, v1, in.acceleration, in.jerk, settled, v});
        };
        // Pushed last to first.
        if (up > m1) {  // passes the zone while it speeds up
            part(up, in.s1, v, in.v1, false);
            part(in.s0, up, in.v0, v, true);
        } else if (down < m0) {  // passes it while it slows down
            part(down, in.s1, v, in.v1, true);
            part(in.s0, down, in.v0, v, false);
        } else {
            const long double from = std::max(up, m0);
            const long double to = std::min(down, m1);
            part(to, in.s1, v, in.v1, down < m1);
            part(from, to, v, v, true);
            part(in.s0, from, in.v0, v, up > m0);
        }
    }

    void draw(const Interval& in) {
        const RampPair pair =
            best_pair(zones_, {in.s0, in.s1, in.v0, in.v1, in.acceleration, in.jerk, in.cap});
        s_ = in.s0;
        ramp(pair.up, in.v0, 1);
        if (pair.rest > 0) phase(pair.rest / pair.peak, pair.peak, 0, 0);
        s_ = std::max(s_, in.s1 - static_cast<long double>(pair.down.length()));
        ramp(pair.down, pair.peak, -1);
    }

    void ramp(const Ramp& r, double v, int sign) {
        const double j = sign * r.jerk;
        const double a = j * r.jerk_time;
        const double bend = 0.5 * a * r.jerk_time;
        phase(r.jerk_time, v, 0, j);
        phase(r.flat_time, v + bend, a, 0);
        phase(r.jerk_time, v + bend + a * r.flat_time, a, -j);
    }

    void phase(double t, double v, double a, double j) {
        if (t <= 0) return;
        const bool cruise = a == 0 && j == 0;
        if (cruise && !phases_.empty()) {  // one cruise over many zones
            Phase& last = phases_.back();
            if (last.a == 0 && last.j == 0 && last.v == v) {
                last.duration += t;
                s_ += static_cast<long double>(v) * t;
                return;
            }
        }
        phases_.push_back({t, s_, v, a, j});
        s_ += ((static_cast<long double>(j) / 6 * t + a / 2) * t + v) * t;
    }

    Zones zones_;
    std::vector<Interval> todo_;  // a stack: the leftmost on top
    std::vector<Phase> phases_;
    long double s_ = 0;
};

}  // namespace

std::vector<Phase> ramps_over(const std::vector<Zone>& zones) {
    return zones.empty() ? std::vector<Phase>{} : ZoneRamps(zones).run();
}

}  // namespace curvecore::ref
