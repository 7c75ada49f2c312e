// SPDX-License-Identifier: Apache-2.0
// Words of a width of their own for each order: in real numbers every sum fits its word, of every
// configuration, and would not fit one that is a bit narrower; what a cut of tau loses.
#include "ref/format/order_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ref/format/parameters.hpp"

namespace curvecore::tb {
namespace {

constexpr double kMostSteps = 4096;  // of a segment, ref/geometry/geometry.hpp

TEST(OrderWords, FactorialBitsAreThoseOfTheFactorial) {
    for (int i = 1; i <= 12; ++i) {
        EXPECT_EQ(ref::factorial_bits(i), std::ceil(std::log2(std::tgamma(i + 1.0)))) << i;
    }
}

/// Largest sum of the words of stage i at a step of theta: t and n as long as they grow within a
/// quarter turn, 2 half last bits for a coefficient's rounding and one for a product's.
double most_sum(int order, int coef_bits, double theta, int i) {
    const double half = std::ldexp(1.0, 1 - coef_bits);
    const double steps = std::min(kMostSteps, std::ceil(M_PI_2 / theta));
    const double last = std::pow(theta, order + 1) / std::tgamma(order + 2.0);
    const double growth = std::exp(steps * (last + half + theta * 2 * order * half));
    double sum = 0;
    for (int j = order; j >= i; --j) {
        sum += growth * std::pow(theta, j - 1) / std::tgamma(j + 1.0) + 3 * half;
    }
    return sum;
}

template <class Visit>
void each_stage(Visit visit) {
    for (int turn_bits = 1; turn_bits <= ref::parameter_of(&ref::CoreParameters::turn_bits).high;
         ++turn_bits) {
        for (int order = 2; order <= 12; ++order) {
            for (int coef_bits = 18; coef_bits <= 36; ++coef_bits) {
                for (int i = 2; i <= order; ++i) visit(turn_bits, order, coef_bits, i);
            }
        }
    }
}

TEST(OrderWords, HoldEverySumOfEveryConfiguration) {
    int stages = 0;
    each_stage([&](int turn_bits, int order, int coef_bits, int i) {
        const int bits = ref::sum_bits(coef_bits, turn_bits, i);
        EXPECT_GE(bits, 18);
        EXPECT_LE(bits, coef_bits);
        const double range = std::ldexp(1.0, bits - 1 - (coef_bits - 2));
        for (const double part : {1.0, 0.7, 0.3, 0.01, 1e-4}) {
            const double theta = std::ldexp(part, -turn_bits);
            ASSERT_LT(most_sum(order, coef_bits, theta, i), range)
                << turn_bits << ' ' << order << ' ' << coef_bits << ' ' << i;
        }
        ++stages;
    });
    EXPECT_EQ(stages, 14 * 19 * 66);
}

TEST(OrderWords, AreOfNoUseABitNarrower) {
    int narrowed = 0;
    each_stage([&](int turn_bits, int, int coef_bits, int i) {
        const int bits = ref::sum_bits(coef_bits, turn_bits, i);
        if (bits == 18 || bits == coef_bits) return;
        const double coefficient = std::ldexp(1.0, -turn_bits * (i - 1)) / std::tgamma(i + 1.0);
        EXPECT_GE(coefficient, std::ldexp(1.0, bits - 2 - (coef_bits - 2)));
        ++narrowed;
    });
    EXPECT_GT(narrowed, 1000);
}

TEST(OrderWords, ACutOfTauLosesLessThanARounding) {
    each_stage([&](int turn_bits, int order, int coef_bits, int i) {
        const int cut = coef_bits - ref::tau_bits(coef_bits, turn_bits, i);
        if (cut == 0) return;
        const double sum = most_sum(order, coef_bits, std::ldexp(1.0, -turn_bits), i);
        EXPECT_LT(std::ldexp(sum, cut), 1) << turn_bits << ' ' << order << ' ' << i;
    });
}

TEST(OrderWords, AreAllAlikeWithoutTurnBits) {
    for (int i = 1; i <= 12; ++i) {
        EXPECT_EQ(ref::sum_bits(30, 0, i), 30);
        EXPECT_EQ(ref::tau_bits(30, 0, i), 30);
    }
    EXPECT_EQ(ref::sum_bits(30, 5, 1), 30);
    EXPECT_EQ(ref::tau_bits(30, 5, 1), 30);
}

}  // namespace
}  // namespace curvecore::tb
