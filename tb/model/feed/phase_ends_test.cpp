// SPDX-License-Identifier: Apache-2.0
// Ends of phases that move to another tick: on the same motion, for the same time.
#include "ref/feed/pieces/phase_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace curvecore::tb::phase_ends_test {

using ref::Phase;

constexpr double kTick = 1e-4;

/// A motion of phases between 0.2 and 30 ticks.
std::vector<Phase> random_motion(std::mt19937& random) {
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    std::vector<Phase> phases;
    Phase phase;
    phase.v = 20;
    for (int i = 0; i < 60; ++i) {
        phase.duration = kTick * (i % 5 == 0 ? uniform(0.2, 1) : uniform(2, 30));
        phase.j = (phase.a > 0 ? -1 : 1) * uniform(0, 1e5);
        phases.push_back(phase);
        phase = {0, phase.place(phase.duration), phase.speed(phase.duration),
                 phase.acceleration(phase.duration), 0};
    }
    return phases;
}

TEST(PhaseEnds, MoveToTheOtherTickOnTheSameMotion) {
    std::mt19937 random(1);
    int moved = 0;
    int stayed = 0;
    for (int round = 0; round < 20; ++round) {
        const std::vector<Phase> phases = random_motion(random);
        const ref::PhaseEnds before(phases, kTick);
        std::vector<std::size_t> ends;
        for (std::size_t i = 1 + random() % 3; i < phases.size(); i += 1 + random() % 3) {
            ends.push_back(i);
        }
        const std::vector<Phase> after = before.moved(ends);
        const ref::PhaseEnds now(after, kTick);
        ASSERT_EQ(after.size(), phases.size());
        EXPECT_EQ(now.ticks(), before.ticks());
        EXPECT_NEAR(static_cast<double>(now.times().back() - before.times().back()), 0, 1e-12);
        auto asked = ends.begin();
        for (std::size_t i = 1; i < phases.size(); ++i) {
            const bool may = asked != ends.end() && *asked == i;
            if (may) ++asked;
            const long double time = now.times()[i];
            if (std::abs(static_cast<double>(time - before.times()[i])) < 1e-12) {
                stayed += may ? 1 : 0;
                continue;
            }
            ++moved;
            EXPECT_TRUE(may) << i;
            const auto ticks = static_cast<double>(time / now.tick());
            EXPECT_NEAR(ticks, std::round(ticks), 1e-6);
            EXPECT_EQ(std::abs(std::lround(ticks) - static_cast<long>(before.nearest(i))), 1);
            EXPECT_LT(std::abs(static_cast<double>(time - before.times()[i])), kTick);
            const std::size_t on = time < before.times()[i] ? i - 1 : i;
            const auto t = static_cast<double>(time - before.times()[on]);
            EXPECT_NEAR(static_cast<double>(after[i].s - phases[on].place(t)), 0, 1e-12);
            EXPECT_NEAR(after[i].v, phases[on].speed(t), 1e-9);
            EXPECT_NEAR(after[i - 1].speed(after[i - 1].duration), after[i].v, 1e-6);
        }
    }
    EXPECT_GT(moved, 300);
    EXPECT_GT(stayed, 10) << "ends beside which there is no room";
}

}  // namespace curvecore::tb::phase_ends_test
