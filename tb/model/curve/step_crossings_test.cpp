// SPDX-License-Identifier: Apache-2.0
// ref/numeric/step_crossings.hpp against a place that is followed clock by clock.
#include "ref/numeric/step_crossings.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace curvecore::ref::step_crossings_test {

TEST(StepCrossings, AreWhereTheNearestStepChanges) {
    std::mt19937_64 random(1);
    const std::int64_t clocks = 64;
    for (int n = 0; n < 20'000; ++n) {
        // Small numbers meet middles often.
        const auto steps = static_cast<std::int64_t>(1 + random() % 8);
        const auto units = static_cast<std::int64_t>(1 + random() % 40);
        const auto from = static_cast<std::int64_t>(random() % 200) - 100;
        const auto to = from + static_cast<std::int64_t>(random() % 60) - 30;
        // The same place at each clock, in units of 1 / clocks.
        const StepCrossings place(steps, units);
        const StepCrossings fine(steps, units * clocks);
        std::vector<std::int64_t> expected;
        std::int64_t count = place.count(from);
        for (std::int64_t clock = 1; clock <= clocks; ++clock) {
            const std::int64_t now = fine.count(from * clocks + (to - from) * clock);
            for (; count < now; ++count) expected.push_back(clock);
            for (; count > now; --count) expected.push_back(-clock);
        }
        std::vector<std::int64_t> found;
        double last = 0;
        place.between(from, to, [&](const StepCrossing& crossing) {
            found.push_back(crossing.back ? -crossing.clock(clocks) : crossing.clock(clocks));
            EXPECT_GE(crossing.time(clocks), last);
            EXPECT_LE(crossing.time(clocks), static_cast<double>(crossing.clock(clocks)));
            last = crossing.time(clocks);
        });
        ASSERT_EQ(found, expected) << steps << "/" << units << " " << from << " to " << to;
        ASSERT_EQ(count, place.count(to));
    }
}

TEST(StepCrossings, TheNearestStepOfAMiddleIsTheOneAbove) {
    const StepCrossings place(1, 2);
    EXPECT_EQ(place.count(1), 1);
    EXPECT_EQ(place.count(-1), 0);
    EXPECT_EQ(place.count(-3), -1);
    EXPECT_EQ(StepCrossings(1, 4).count(1), 0);
    EXPECT_EQ(StepCrossings(3, 4).count(-2), -1);
}

}  // namespace curvecore::ref::step_crossings_test
