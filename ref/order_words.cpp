// SPDX-License-Identifier: Apache-2.0
#include "ref/order_words.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr int kLeastBits = 2;
constexpr double kRoundings = 3;  // half last bits, of a coefficient and of a stage's product

int blocks(int bits) { return bits > 18 ? 2 : 1; }

}  // namespace

OrderWords order_words(const WordFormat& format, double max_theta, int spare) {
    OrderWords words = uniform_words(format);
    words.max_theta = max_theta;
    const double half = std::ldexp(1.0, 1 - format.coef_bits);
    double sum = 0;
    double size = 1;  // theta^(i-1) / i!
    std::array<double, 13> sizes{};
    for (int i = 1; i <= format.order; ++i) {
        sizes[static_cast<std::size_t>(i)] = size;
        size *= max_theta / (i + 1);
    }
    for (int i = format.order; i >= 2; --i) {
        const auto order = static_cast<std::size_t>(i);
        sum += sizes[order] + kRoundings * half;
        const int copies = static_cast<int>(std::floor(1 - std::log2(sum)));
        words.sum_bits[order] = std::max(kLeastBits, format.coef_bits - copies);
        const int cut = std::max(0, static_cast<int>(std::floor(-std::log2(2 * sum))) - spare);
        words.tau_bits[order] = std::max(kLeastBits, format.coef_bits - cut);
        if (cut > 0) words.extra += 2 * std::ldexp(sum, cut);
    }
    return words;
}

OrderWords uniform_words(const WordFormat& format) {
    OrderWords words;
    words.sum_bits.fill(format.coef_bits);
    words.tau_bits.fill(format.coef_bits);
    return words;
}

int lane_bits(const WordFormat& format, const OrderWords& words) {
    int bits = 0;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(format.order); ++i) {
        bits += words.sum_bits[i] * words.tau_bits[i];
    }
    return bits;
}

int lane_blocks(const WordFormat& format, const OrderWords& words) {
    int count = 0;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(format.order); ++i) {
        count += blocks(words.sum_bits[i]) * blocks(words.tau_bits[i]);
    }
    return count;
}

}  // namespace curvecore::ref
