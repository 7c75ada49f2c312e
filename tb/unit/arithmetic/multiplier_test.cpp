// SPDX-License-Identifier: Apache-2.0
// rtl/multiplier/multiplier.sv in every form against 128-bit integers.
#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <vector>

#include "Vmultiplier.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

__extension__ using Wide = __int128;
constexpr int kABits = CFG_ABits;
constexpr int kBBits = CFG_BBits;
constexpr int kShift = CFG_Shift;
constexpr int kProductBits = kABits + kBBits - kShift;
constexpr int kLatency = 5;

Wide product(int64_t a, int64_t b) {
    const Wide exact = static_cast<Wide>(a) * b;
    return kShift == 0 ? exact : (exact + (static_cast<Wide>(1) << (kShift - 1))) >> kShift;
}

std::vector<int64_t> edge_words(int bits) {
    const int64_t least = -(int64_t{1} << (bits - 1));
    std::vector<int64_t> words = {least, least + 1, -1, 0, 1, -least - 1};
    for (int bit = 15; bit < bits - 1; ++bit) {
        for (const int64_t offset : {-1, 0, 1}) {
            words.push_back((int64_t{1} << bit) + offset);
            words.push_back(-(int64_t{1} << bit) + offset);
        }
    }
    return words;
}

class Multiplier : public testing::Test {
  protected:
    /// Advances by one clock; with `enabled` the operands are taken.
    void clock(int64_t a, int64_t b, bool enabled = true) {
        dut_->a_i = to_port(a, kABits);
        dut_->b_i = to_port(b, kBBits);
        dut_->en_i = enabled;
        dut_.tick();
        if (enabled) expected_.push_back({a, b, product(a, b)});
    }

    /// Checks the product of the oldest operands in flight, once it has arrived.
    void check() {
        if (expected_.size() < kLatency) return;
        const Case& now = expected_.front();
        ASSERT_TRUE(now.product == observed()) << now.a << " * " << now.b;
        if (expected_.size() == kLatency) expected_.pop_front();
    }

    Wide observed() {
        constexpr int kLow = kProductBits > 32 ? 32 : 0;
        const int64_t high = signed_field(dut_->product_o, kLow, kProductBits - kLow);
        return static_cast<Wide>(high) * (Wide{1} << kLow) + field(dut_->product_o, 0, kLow);
    }

    struct Case {
        int64_t a;
        int64_t b;
        Wide product;
    };
    ClockedDut<Vmultiplier> dut_;
    std::deque<Case> expected_;
};

TEST_F(Multiplier, LatencyIsFive) {
    for (int n = 0; n < 10; ++n) clock(0, 0);
    clock(3, 5 << 10);
    for (int n = 1; n < kLatency; ++n) {
        ASSERT_TRUE(observed() == product(0, 0)) << n;
        clock(0, 0);
    }
    EXPECT_TRUE(observed() == product(3, 5 << 10));
}

TEST_F(Multiplier, IsExactOnEdgeWords) {
    for (const int64_t a : edge_words(kABits)) {
        for (const int64_t b : edge_words(kBBits)) {
            clock(a, b);
            ASSERT_NO_FATAL_FAILURE(check());
        }
    }
}

TEST_F(Multiplier, IsExactOnRandomWordsWithRandomStalls) {
    std::mt19937_64 random(1);
    for (int n = 0; n < 200'000; ++n) {
        const int64_t a = from_port(random(), kABits) >> (random() % kABits);
        const int64_t b = from_port(random(), kBBits) >> (random() % kBBits);
        const bool enabled = n < 100'000 || random() % 4 != 0;
        clock(a, b, enabled);
        if (!enabled) continue;
        ASSERT_NO_FATAL_FAILURE(check());
    }
}

TEST_F(Multiplier, HoldsProductWhileDisabled) {
    for (int n = 0; n < kLatency; ++n) clock(-7, 9 << 12);
    for (int n = 0; n < 20; ++n) {
        clock(n, n, false);
        ASSERT_TRUE(observed() == product(-7, 9 << 12)) << n;
    }
}

}  // namespace
}  // namespace curvecore::tb
