// SPDX-License-Identifier: Apache-2.0
// The one rounding and the word formats.
#include "hls/fixed_word.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hls/quantise.hpp"

namespace curvecore::hls::fixed_word_test {

std::int64_t floor_half_up(std::int64_t value, int shift) {
    return static_cast<std::int64_t>(
        std::floor(std::ldexp(static_cast<long double>(value), -shift) + 0.5L));
}

TEST(FixedWord, RoundsToNearestTiesUp) {
    EXPECT_EQ(round_shift(std::int64_t{5}, 2), 1);    // 1.25
    EXPECT_EQ(round_shift(std::int64_t{6}, 2), 2);    // 1.5
    EXPECT_EQ(round_shift(std::int64_t{-6}, 2), -1);  // -1.5
    EXPECT_EQ(round_shift(std::int64_t{-7}, 2), -2);  // -1.75
    EXPECT_EQ(round_shift(std::int64_t{-7}, 0), -7);
}

TEST(FixedWord, RoundsAtEveryShift) {
    std::mt19937_64 random(1);
    for (int n = 0; n < 100000; ++n) {
        const std::int64_t value = static_cast<std::int64_t>(random()) >> 22;
        const int shift = static_cast<int>(random() % 40);
        ASSERT_EQ(round_shift(value, shift), floor_half_up(value, shift))
            << value << " >> " << shift;
    }
}

TEST(FixedWord, ProductIsRoundedOnceFromFullWidth) {
    using Product = Word<72>;
    std::mt19937_64 random(2);
    for (int n = 0; n < 100000; ++n) {
        const std::int64_t a = static_cast<std::int64_t>(random()) >> 28;
        const std::int64_t b = static_cast<std::int64_t>(random()) >> 29;
        const long double exact =
            std::ldexp(static_cast<long double>(a) * static_cast<long double>(b), -35);
        // 71 bits do not fit a long double: within its last bit of the exact tie only.
        ASSERT_NEAR(static_cast<double>(rounded_product<Product>(a, b, 35) - exact), 0, 0.5 + 1e-9);
    }
    const std::int64_t half = std::int64_t{1} << 34;
    EXPECT_EQ(rounded_product<Product>(half, std::int64_t{1}, 35), 1);   // a tie goes up
    EXPECT_EQ(rounded_product<Product>(half, std::int64_t{-1}, 35), 0);  // also below zero
}

TEST(FixedWord, ReciprocalsAreNearest) {
    for (int i = 2; i <= 12; ++i) {
        EXPECT_EQ(reciprocal(i, 35), std::llround(std::ldexp(1.0L, 35) / i)) << i;
        EXPECT_EQ(reciprocal(i, 17), std::llround(std::ldexp(1.0L, 17) / i)) << i;
    }
}

TEST(Words, ALengthThatItsWordCannotHoldIsRefusedNotCut) {
    using C = DefaultConfiguration;
    ref::Segment segment;
    segment.length = (std::uint64_t{1} << kBusLengthBits) - 1;
    EXPECT_EQ(to_int(to_words<C>(segment).length), (std::int64_t{1} << 44) - 1);
    ++segment.length;
    EXPECT_THROW(to_words<C>(segment), std::range_error);
    ref::ProfilePiece piece;
    piece.ds = segment.length;
    EXPECT_THROW(to_words(piece), std::range_error);
}

TEST(Words, SegmentFieldsKeepTheirPlacesOnTheBus) {
    using C = Configuration<6, 36, 32, 10, 1, SamplerMode::kSeries>;
    SegmentWords<C> segment;
    segment.length = 1;
    segment.theta = 2;
    segment.step_exponent = 27;
    segment.ticks = 0x44332211;
    segment.last = true;
    for (int axis = 0; axis < C::kAxes; ++axis) {
        segment.start[axis] = 100 + axis;
        segment.end[axis] = -1 - axis;
        segment.advance[axis] = 400 + axis;
    }
    for (int axis = 0; axis < 3; ++axis) {
        segment.tangent[axis] = 200 + axis;
        segment.normal[axis] = 300 + axis;
    }
    std::uint64_t bus[ref::segment_bus_words(C::kAuxAxes)];
    pack(segment, 0x1AB, bus);
    EXPECT_EQ(bus[0], 0x100000000001U);
    EXPECT_EQ(bus[1], 0x2EC000000002U);  // last, k = 27, kind 0
    EXPECT_EQ(bus[2], 0x300000000064U);
    EXPECT_EQ(bus[3], 0x4FFFFFFFFFFFU);  // sign-extended to 44 bits
    EXPECT_EQ(bus[4], 0x5AB0000000C8U);  // the low byte of the sequence
    EXPECT_EQ(bus[5], 0x60000000012CU);
    EXPECT_EQ(bus[6], 0x700000000190U);
    EXPECT_EQ(bus[7], 0x300000000065U);
    EXPECT_EQ(bus[9], 0x5110000000C9U);  // a byte of ticks each
    EXPECT_EQ(bus[10], 0x62200000012DU);
    EXPECT_EQ(bus[14], 0x5330000000CAU);
    EXPECT_EQ(bus[15], 0x64400000012EU);
    EXPECT_EQ(bus[17], 0x300000000067U);  // the auxiliary axis: start, end, advance
    EXPECT_EQ(bus[18], 0x4FFFFFFFFFFCU);
    EXPECT_EQ(bus[19], 0x700000000193U);
}

TEST(Words, ASplineHasItsKindBesideTheStepExponentAndItsScaleInTheNormal) {
    using C = Configuration<6, 36, 32, 10, 0, SamplerMode::kPolynomial>;
    SegmentWords<C> segment;
    segment.kind = SegmentKind::kSpline;
    segment.theta = std::int64_t(3) << 33;
    segment.step_exponent = 21;
    segment.lambda = 25;
    std::uint64_t bus[ref::segment_bus_words(C::kAuxAxes)];
    pack(segment, 0, bus);
    EXPECT_EQ(bus[1], (3ULL << 33) | (1ULL << 36) | (21ULL << 38) | (2ULL << 44));
    EXPECT_EQ(bus[5], (25ULL << 36) | (6ULL << 44));
}

TEST(Words, ProfileFieldsKeepTheirPlacesOnTheBus) {
    ProfileWords piece;
    piece.ticks = 1 << 19;
    piece.time_exponent = 19;
    piece.exponent = 46;
    piece.final = true;
    piece.ds = 7;
    piece.c[0] = -1;
    std::uint64_t bus[kProfileBusWords];
    pack(piece, 5, bus);
    EXPECT_EQ(bus[0], (1U << 19) | (19U << 20) | (46ULL << 25) | (1ULL << 31) | (5ULL << 36) |
                          (8ULL << 44));
    EXPECT_EQ(bus[1], 0x900000000007U);
    EXPECT_EQ(bus[2], 0xA00FFFFFFFFFU);
    EXPECT_EQ(bus[4], 0xC00000000000U);
}

}  // namespace curvecore::hls::fixed_word_test
