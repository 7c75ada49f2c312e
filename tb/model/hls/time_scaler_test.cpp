// SPDX-License-Identifier: Apache-2.0
// The rate of time: bounded first and second differences, no overshoot, exact arrival.
#include "hls/time_scaler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

namespace curvecore::hls::time_scaler_test {

struct Bounds {
    std::int64_t acceleration;
    std::int64_t slope;
};

class TimeScalerBounds : public ::testing::TestWithParam<Bounds> {};

TEST_P(TimeScalerBounds, DifferencesStayBoundedForAnyTargets) {
    const Bounds bounds = GetParam();
    TimeScaler scaler(bounds.acceleration, bounds.slope);
    std::mt19937 random(3);
    std::int32_t target = 1 << 16;
    std::int64_t rate = scaler.tick(target);
    std::int64_t slope = 0;
    int ticks_fine = 0;
    for (int tick = 0; tick < 200000; ++tick) {
        if (random() % 50 == 0) {
            const int kind = static_cast<int>(random() % 3);
            target = kind == 0   ? 0
                     : kind == 1 ? 1 << 16
                                 : static_cast<std::int32_t>(random() % 65537);
        }
        const std::int64_t next = scaler.tick(target);
        ASSERT_GE(next, 0);
        ASSERT_LE(next, 1 << 16);
        // The output is cut to 16 fraction bits: one last bit per difference.
        const bool fine = std::min({rate - slope, rate, next}) >= ref::kFineRate;
        const int shift = fine ? ref::kFineShift : 0;
        ASSERT_LE(std::llabs(next - rate), (bounds.slope >> shift >> 16) + 1) << "tick " << tick;
        ASSERT_LE(std::llabs(next - rate - slope), (bounds.acceleration >> shift >> 16) + 2)
            << "tick " << tick;
        ticks_fine += fine && next != rate ? 1 : 0;
        slope = next - rate;
        rate = next;
    }
    EXPECT_GT(ticks_fine, 500);
}

TEST_P(TimeScalerBounds, ArrivesExactlyAndWithoutOvershoot) {
    const Bounds bounds = GetParam();
    for (const std::int32_t target : {0, 1, 12345, 65535, 65536}) {
        TimeScaler scaler(bounds.acceleration, bounds.slope);
        std::int32_t rate = scaler.tick(1 << 16);
        int ticks = 0;
        while (rate != target && ticks < 10000000) {
            const std::int32_t next = scaler.tick(target);
            ASSERT_LE(next, rate);
            ASSERT_GE(next, target);
            rate = next;
            ++ticks;
        }
        ASSERT_EQ(rate, target);
        for (int rest = 0; rest < 10; ++rest) {
            EXPECT_EQ(scaler.tick(target), target);
        }
    }
}

std::string name_of(const ::testing::TestParamInfo<Bounds>& bounds) {
    return "accel_" + std::to_string(bounds.param.acceleration) + "_slope_" +
           std::to_string(bounds.param.slope);
}

INSTANTIATE_TEST_SUITE_P(Machines, TimeScalerBounds,
                         ::testing::Values(Bounds{1 << 16, 1 << 24}, Bounds{1000, 1000 * 4000},
                                           Bounds{std::int64_t(1) << 31, std::int64_t(1) << 32},
                                           Bounds{77777, 77777}, Bounds{200000, 2000001},
                                           Bounds{200000, 2199999}),
                         name_of);

TEST(TimeScaler, FirstTickThatIsNotHeldLandsOnItsTarget) {
    for (const std::int32_t target : {0, 1, 12345, 65536}) {
        TimeScaler scaler(1 << 10, 1 << 20);
        for (int tick = 0; tick < target; tick += 1000) EXPECT_EQ(scaler.tick(0), 0);
        for (int tick = 0; tick < 10; ++tick) EXPECT_EQ(scaler.tick(target), target);
    }
}

TEST(TimeScaler, WhileNothingIsUnderWayTheRateIsItsTarget) {
    TimeScaler scaler(1 << 10, 1 << 20);
    EXPECT_EQ(scaler.tick(65536), 65536);
    // In motion it goes there step by step; at its end it is there.
    for (int tick = 0; tick < 100; ++tick) EXPECT_GT(scaler.tick(655), 60000);
    for (const std::int32_t target : {655, 0, 65536, 12345}) {
        for (int tick = 0; tick < 3; ++tick) EXPECT_EQ(scaler.tick(target, true), target);
    }
    // It begins a motion at rest on 12345.
    EXPECT_EQ(scaler.tick(12345), 12345);
    EXPECT_LE(scaler.tick(65536), 12346);
}

TEST(TimeScaler, StopsNearlyAsFastAsTheBoundsAllow) {
    const std::int64_t acceleration = 1 << 20;
    TimeScaler scaler(acceleration, acceleration * 1000);
    scaler.tick(1 << 16);
    int ticks = 0;
    while (scaler.tick(0) != 0) ++ticks;
    // It waits for a branch first. No slope limit in reach: 2 sqrt(d / a) ticks, 128 to 7/8 and 120
    // from there.
    EXPECT_LE(ticks, ref::kStopLead - 1 + 252);
}

}  // namespace curvecore::hls::time_scaler_test
