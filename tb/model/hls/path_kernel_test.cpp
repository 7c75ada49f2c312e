// SPDX-License-Identifier: Apache-2.0
// The path generator's words against the pieces' exact polynomials.
#include "hls/path_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tb/support/segments/random_pieces.hpp"

namespace curvecore::hls::path_kernel_test {

using tb::piece_of;

struct Feeder {
    std::vector<ProfileWords> pieces;
    std::size_t next = 0;
    bool operator()(ProfileWords& out) {
        if (next == pieces.size()) return false;
        out = pieces[next++];
        return true;
    }
};

Feeder random_program(std::uint32_t seed, std::int64_t& total) {
    Feeder feeder{tb::random_pieces(seed, 40, 300)};
    total = 0;
    for (const ProfileWords& piece : feeder.pieces) total += piece.ds;
    return feeder;
}

TEST(PathKernel, FollowsThePolynomialWithinItsRounding) {
    std::mt19937_64 random(4);
    for (int n = 0; n < 2000; ++n) {
        const ProfileWords piece =
            piece_of(static_cast<std::int64_t>(random() >> (24 + random() % 30)),
                     1 + static_cast<std::int32_t>(random() % 1000), 0.5, true);
        const std::int64_t time = static_cast<std::int64_t>(
            random() % (static_cast<std::uint64_t>(piece.ticks) << kRateFrac));
        const double tau = std::ldexp(static_cast<double>(time), -kRateFrac - piece.time_exponent);
        double exact = 0;
        for (int i = 2; i >= 0; --i) {
            exact = (exact +
                     std::ldexp(static_cast<double>(piece.c[i]), piece.exponent - kProfileFrac)) *
                    tau;
        }
        // Three products of half a last bit each, 2^(e-35), and half a quantum.
        const double bound = 3 * std::ldexp(0.5, piece.exponent - kProfileFrac) + 0.5 +
                             1e-6 * std::fabs(exact) * 1e-6;
        ASSERT_NEAR(static_cast<double>(piece_path(piece, time)), exact, bound + 1e-3);
    }
}

TEST(PathKernel, PiecesEndExactlyAtAnyRate) {
    for (std::uint32_t seed = 1; seed <= 50; ++seed) {
        std::int64_t total = 0;
        Feeder feeder = random_program(seed, total);
        std::mt19937 random(seed);
        PathKernel path;
        std::int64_t walked = 0;
        int ticks = 0;
        do {
            const std::int32_t rate =
                seed == 1 ? 65536 : static_cast<std::int32_t>(random() % 65537);
            const std::int64_t ds = path.tick(rate, feeder);
            ASSERT_GE(ds, 0);
            walked += ds;
            ASSERT_LE(walked, total);
            ASSERT_LT(++ticks, 1000000);
        } while (path.active());
        EXPECT_EQ(walked, total) << "seed " << seed;
    }
}

TEST(PathKernel, WaitsAtThePiecesEndWhenItIsNotFed) {
    std::int64_t total = 0;
    Feeder feeder = random_program(7, total);
    feeder.pieces.resize(2);
    const std::int64_t fed = feeder.pieces[0].ds + feeder.pieces[1].ds;
    PathKernel path;
    std::int64_t walked = 0;
    for (int tick = 0; tick < 2000; ++tick) walked += path.tick(65536, feeder);
    EXPECT_EQ(walked, fed);
    EXPECT_TRUE(path.active());
    feeder.pieces.push_back(piece_of(1000, 10, 1.0, true));
    for (int tick = 0; tick < 20; ++tick) walked += path.tick(65536, feeder);
    EXPECT_EQ(walked, fed + 1000);
    EXPECT_FALSE(path.active());
}

TEST(PathKernel, NoProgramBeginsInATickThatIsHeld) {
    std::int64_t total = 0;
    Feeder feeder = random_program(7, total);
    PathKernel path;
    for (int tick = 0; tick < 100; ++tick) EXPECT_EQ(path.tick(65536, feeder, true), 0);
    EXPECT_FALSE(path.active());
    std::int64_t walked = path.tick(65536, feeder);
    EXPECT_TRUE(path.active());
    while (path.active()) walked += path.tick(65536, feeder, true);
    EXPECT_EQ(walked, total);
}

TEST(SampleShare, SharesATickEvenlyAndWholly) {
    std::mt19937_64 random(5);
    for (int n = 0; n <= 8; ++n) {
        SampleShare share(n);
        for (int tick = 0; tick < 100; ++tick) {
            const std::int64_t ds = static_cast<std::int64_t>(random() >> 30);
            ASSERT_TRUE(share.needs_tick());
            share.tick(ds);
            std::int64_t sum = 0;
            for (int j = 1; j <= (1 << n); ++j) {
                sum += share.sample();
                ASSERT_EQ(sum, (ds * j) >> n);
            }
        }
    }
}

}  // namespace curvecore::hls::path_kernel_test
