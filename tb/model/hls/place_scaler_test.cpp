// SPDX-License-Identifier: Apache-2.0
// Places and rates of hls/place_scaler.hpp against wide integers.
#include "hls/place_scaler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tb/support/pins/step_motion.hpp"

namespace curvecore::hls::place_scaler_test {

TEST(PlaceScaler, PlacesAreTheProductRoundedDown) {
    std::mt19937_64 random(1);
    for (int n = 0; n < 300'000; ++n) {
        const int bits = 18 + static_cast<int>(random() % 27);
        const std::int64_t half = std::int64_t(1) << (bits - 1);
        std::int64_t position = static_cast<std::int64_t>(random() & (2 * half - 1)) - half;
        if (n % 8 == 0) position = n % 16 == 0 ? -half : half - 1;
        std::int64_t scale = static_cast<std::int64_t>(random() >> (8 + random() % 56));
        if (n % 5 == 0) scale = (std::int64_t(1) << 56) - 1;
        ASSERT_EQ(place(position, scale, bits), tb::exact_place(position, scale, bits))
            << position << " " << scale << " " << bits;
    }
}

TEST(PlaceScaler, AScaleInItsWordMovesNoPlaceByMoreThanAQuarterOfALastBit) {
    // Steps per unit as a ratio that no word holds: 2000 / 3 steps per mm, positions of 2^-10 nm.
    const int bits = 42;
    const double steps = 2000.0 / 3 / 1e6 / 1024;
    const auto scale = std::llround(steps * std::exp2(bits + kStepFraction));
    std::mt19937_64 random(1);
    double worst = 0;
    for (int n = 0; n < 100'000; ++n) {
        const auto position = static_cast<std::int64_t>(random()) >> (64 - bits);
        const long double exact = 2000.0L / 3 / 1e6L / 1024 * position * 65536;
        const long double rounding = exact - place(position, scale, bits);
        ASSERT_GE(rounding, -0.25L);
        ASSERT_LT(rounding, 1.25L);
        worst = std::max(worst, std::abs(static_cast<double>(rounding) - 0.5));
    }
    EXPECT_GT(worst, 0.5);
}

TEST(PlaceScaler, ARateThatIsNoWordIsRefusedAndMovesNothingElse) {
    const int period_log2 = 13;
    PlaceScaler scaler(42, period_log2);
    scaler.set_scale(std::int64_t(1) << 42);  // a unit of position is 2^-16 step
    const std::int64_t half = std::int64_t(1) << (kStepFraction + period_log2 - 1);
    EXPECT_TRUE(scaler.next(98304, true, false).fresh);
    EXPECT_EQ(scaler.next(98304 + half - 1, false, true).rate, half - 1);
    EXPECT_EQ(scaler.next(98303, false, true).rate, -half);
    EXPECT_FALSE(scaler.next(98303, false, true).moves);
    EXPECT_TRUE(scaler.next(98303 + half, false, true).refused);
    EXPECT_TRUE(scaler.next(98302, false, true).refused);
    EXPECT_FALSE(scaler.next(98302 + half, false, false).refused) << "it does not count";
    // A program begins less than a step from where the axis stands.
    const std::int64_t step = std::int64_t(1) << kStepFraction;
    EXPECT_TRUE(scaler.next(0, true, false).fresh);
    EXPECT_EQ(scaler.next(step - 1, false, true, true).rate, step - 1);
    EXPECT_EQ(scaler.next(-1, false, true, true).rate, -step);
    EXPECT_TRUE(scaler.next(step - 1, false, true, true).refused);
    EXPECT_TRUE(scaler.next(-2, false, true, true).refused);
    EXPECT_FALSE(scaler.next(step, false, false, true).refused) << "it does not count";
    // The fraction of a step at which it stands.
    EXPECT_EQ(scaler.next(98304, true, false).rate, -32768);
    EXPECT_EQ(scaler.next(98303, true, false).rate, 32767);
    EXPECT_EQ(scaler.next(-1, true, false).rate, -1);
}

}  // namespace curvecore::hls::place_scaler_test
