// SPDX-License-Identifier: Apache-2.0
// Ramps over zones whose limits differ by orders of magnitude, as along a hairpin.
#include "ref/feed/ramps/zone_ramps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ref/feed/ramps/ramp_pair.hpp"

namespace curvecore::tb::zone_ramps_test {

using ref::Phase;
using ref::Zone;

/// Zones towards a tip and away from it: speed falls as s^0.8, acceleration as s^0.5.
std::vector<Zone> hairpin(double tip, double largest) {
    std::vector<Zone> half;
    for (double s = tip; s < largest; s *= 1.3) {
        half.push_back(
            {0.3 * s, 100 * std::pow(s / largest, 0.8), 4000 * std::sqrt(s / largest), 7e4});
    }
    std::vector<Zone> zones(half.rbegin(), half.rend());
    zones.insert(zones.end(), half.begin(), half.end());
    return zones;
}

std::vector<Zone> random_zones(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    std::vector<Zone> zones;
    for (int i = 0; i < 60; ++i) {
        if (uniform(0, 1) < 0.3) zones.push_back({0, std::pow(10, uniform(0, 2)), 1e300, 1e300});
        zones.push_back({std::pow(10, uniform(-3, 1)), std::pow(10, uniform(0, 2)),
                         std::pow(10, uniform(1.5, 3.7)), std::pow(10, uniform(3.5, 5))});
    }
    return zones;
}

/// Worst ratio of a motion to the limits of its zone; to both zones' at a border.
double worst_ratio(const std::vector<Phase>& phases, const std::vector<Zone>& zones) {
    double worst = 0;
    for (const Phase& phase : phases) {
        for (int i = 0; i <= 100; ++i) {
            const double t = phase.duration * i / 100;
            const double v = phase.v + (phase.a + phase.j * t / 2) * t;
            const double a = phase.a + phase.j * t;
            const double s =
                static_cast<double>(phase.s) + ((phase.j * t / 6 + phase.a / 2) * t + phase.v) * t;
            double begin = 0;
            for (const Zone& zone : zones) {
                const double end = begin + zone.length;
                const double edge = 1e-9 * (1 + end);
                if (s > begin + edge && s < end - edge) {
                    worst = std::max({worst, v / zone.velocity, std::abs(a) / zone.acceleration,
                                      std::abs(phase.j) / zone.jerk});
                }
                begin = end;
            }
        }
    }
    return worst;
}

TEST(ZoneRamps, KeepsToTheLimitsOfEveryZone) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const std::vector<Zone> zones = random_zones(seed);
        EXPECT_LE(worst_ratio(ramps_over(zones), zones), 1 + 1e-6) << seed;
    }
    const std::vector<Zone> zones = hairpin(1e-3, 10);
    const std::vector<Phase> phases = ramps_over(zones);
    EXPECT_LE(worst_ratio(phases, zones), 1 + 1e-6);
    // Control: limits of half the size are broken by it.
    std::vector<Zone> weak = zones;
    for (Zone& zone : weak) zone.acceleration /= 2;
    EXPECT_GT(worst_ratio(phases, weak), 1.2);
}

TEST(ZoneRamps, EndsAtTheEnd) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const std::vector<Zone> zones = random_zones(seed);
        double length = 0;
        for (const Zone& zone : zones) length += zone.length;
        const std::vector<Phase> phases = ramps_over(zones);
        const Phase& last = phases.back();
        const double t = last.duration;
        const double end =
            static_cast<double>(last.s) + ((last.j * t / 6 + last.a / 2) * t + last.v) * t;
        EXPECT_NEAR(end, length, 1e-9 * length);
        EXPECT_NEAR(last.v + (last.a + last.j * t / 2) * t, 0, 1e-6);
    }
}

// With the least acceleration of all its zones, a hairpin would take twice as long.
TEST(ZoneRamps, AHairpinsTipDoesNotSlowItsLegs) {
    const std::vector<Zone> zones = hairpin(1e-3, 10);
    double least = 0;  // at every zone's speed, without ramps
    for (const Zone& zone : zones) least += zone.length / zone.velocity;
    EXPECT_LT(duration(ramps_over(zones)), 2.2 * least);
    std::vector<Zone> uniform = zones;
    for (Zone& zone : uniform) zone.acceleration = zones[zones.size() / 2].acceleration;
    EXPECT_GT(duration(ramps_over(uniform)), 2 * duration(ramps_over(zones)));
}

TEST(RampPair, IsTheGapsOwnWhereLimitsAreEqual) {
    const ref::Zones zones({{10, 100, 1000, 1e4}, {5, 80, 1000, 1e4}});
    const ref::RampPair pair = best_pair(zones, {0, 15, 0, 0, 1000, 1e4, 80});
    EXPECT_EQ(pair.peak, ref::peak_speed(0, 0, 15, 1000, 1e4, 80));
    EXPECT_EQ(pair.up.jerk, 1e4);
    EXPECT_GE(pair.rest, 0);
}

}  // namespace curvecore::tb::zone_ramps_test
