// SPDX-License-Identifier: Apache-2.0
// Words of a width of their own for each order: Horner's rule in them stays within what the study
// says, and a bit less does not.
#include "ref/order_words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace curvecore::tb {
namespace {

using Wide = std::int64_t;  // products of 30 bits each

Wide rounded(Wide value, int shift) { return (value + (Wide(1) << (shift - 1))) >> shift; }

struct Worst {
    double error = 0;  // half last bits of a coefficient
    int beyond = 0;    // sums that their word cannot hold
};

/// Horner in these words against the exact sum, over random series of an arc.
Worst evaluate(const ref::WordFormat& format, const ref::OrderWords& words) {
    std::mt19937_64 random(5);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const int frac = format.coef_bits - 2;
    Worst worst;
    for (int n = 0; n < 100000; ++n) {
        const double theta = words.max_theta * (n % 2 == 0 ? 1 : uniform(0, 1));
        const int tau_frac = format.coef_bits - 1;
        const auto tau = static_cast<std::int64_t>(uniform(n % 3 == 0 ? 0.99 : 0, 1) *
                                                   std::ldexp(1.0, tau_frac));
        Wide sum = 0;
        long double exact = 0;
        const long double real_tau = std::ldexp(static_cast<long double>(tau), -tau_frac);
        for (int i = format.order; i >= 1; --i) {
            double size = 1;
            for (int j = 2; j <= i; ++j) size *= theta / j;
            const std::int64_t word =
                std::llround(size * (n % 5 == 0 ? 1 : uniform(-1, 1)) * std::ldexp(1.0, frac));
            sum += word;
            exact = (exact + static_cast<long double>(word)) * real_tau;
            const auto order = static_cast<std::size_t>(i);
            const Wide limit = Wide(1) << (words.sum_bits[order] - 1);
            if (sum >= limit || sum < -limit) ++worst.beyond;
            const int cut = format.coef_bits - words.tau_bits[order];
            sum = rounded(sum * ((tau >> cut) << cut), tau_frac);
        }
        const double error =
            2 * static_cast<double>(std::abs(static_cast<long double>(sum) - exact));
        worst.error = std::max(worst.error, error);
    }
    return worst;
}

TEST(OrderWords, HoldEverySumAndLoseNoMoreThanSaid) {
    for (const int order : {2, 3, 4, 6, 8}) {
        for (const double theta : {0.5, 0.125, 1.0 / 64}) {
            for (const int spare : {1, 3}) {
                const ref::WordFormat format{order, 30, 32, 10, false};
                const ref::OrderWords words = ref::order_words(format, theta, spare);
                const Worst worst = evaluate(format, words);
                EXPECT_EQ(worst.beyond, 0);
                EXPECT_LE(worst.error, order + words.extra);
                EXPECT_LT(ref::lane_bits(format, words), order * 30 * 30);
            }
        }
    }
}

TEST(OrderWords, ABitLessDoesNotHoldTheSums) {
    const ref::WordFormat format{4, 30, 32, 10, false};
    ref::OrderWords words = ref::order_words(format, 0.5, 3);
    for (std::size_t i = 2; i <= 4; ++i) {
        ref::OrderWords narrow = words;
        narrow.sum_bits[i] -= 2;
        EXPECT_GT(evaluate(format, narrow).beyond, 0) << i;
    }
}

TEST(OrderWords, ATauCutByMoreLosesMore) {
    const ref::WordFormat format{4, 30, 32, 10, false};
    ref::OrderWords words = ref::order_words(format, 0.5, 3);
    words.tau_bits[2] -= 6;
    EXPECT_GT(evaluate(format, words).error, 4 + words.extra);
}

}  // namespace
}  // namespace curvecore::tb
