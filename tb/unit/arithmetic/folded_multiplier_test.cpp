// SPDX-License-Identifier: Apache-2.0
// rtl/multiplier/folded_multiplier.sv in both forms against 128-bit integers.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "Vfolded_multiplier.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

__extension__ using Wide = __int128;
constexpr int kBits = CFG_Bits;

struct Pair {
    int64_t a;
    int64_t b;
};

class FoldedMultiplier : public testing::Test {
  protected:
    FoldedMultiplier() { idle(10); }

    void idle(int clocks) {
        dut_->valid_i = 0;
        dut_->first_i = 1;
        dut_->drop_i = 1;
        dut_->a_i = low_mask(kBits);
        for (int n = 0; n < clocks; ++n) dut_.tick();
    }

    /// Sum of the products by the RTL; `pauses` inserts clocks without operands.
    int64_t run(const std::vector<Pair>& pairs, bool wide, bool no_sign, std::mt19937_64* pauses) {
        for (int part = 0; part < 4; ++part) {
            for (std::size_t n = 0; n < pairs.size(); ++n) {
                if (pauses != nullptr) idle(static_cast<int>((*pauses)() % 3));
                dut_->valid_i = 1;
                dut_->part_i = static_cast<uint8_t>(part);
                dut_->first_i = part == 0 && n == 0;
                dut_->drop_i = (part == 1 || part == 3) && n == 0;
                dut_->wide_i = wide;
                dut_->unsigned_i = no_sign;
                dut_->a_i = to_port(pairs[n].a, kBits);
                dut_->b_i = to_port(pairs[n].b, kBits);
                dut_.tick();
            }
        }
        idle(3);
        before_ = from_port(dut_->sum_o, kBits);
        idle(1);
        return from_port(dut_->sum_o, kBits);
    }

    static int64_t expected(const std::vector<Pair>& pairs, bool wide, bool no_sign) {
        const int shift = wide ? CFG_WideShift : CFG_NarrowShift;
        Wide sum = Wide{1} << (shift - 1);
        for (const Pair& pair : pairs) {
            const Wide b = no_sign ? static_cast<Wide>(to_port(pair.b, kBits)) : Wide{pair.b};
            sum += pair.a * b;
        }
        return from_port(static_cast<uint64_t>(sum >> shift), kBits);
    }

    ClockedDut<Vfolded_multiplier> dut_;
    int64_t before_ = 0;
};

TEST_F(FoldedMultiplier, IsExactOnEdgeWords) {
    const int64_t top = (int64_t{1} << (kBits - 1)) - 1;
    std::vector<int64_t> words = {-top - 1, -top, -1, 0, 1, top, top - 0x1ffff, top - 0x20000};
    for (int bit = 15; bit < kBits - 1; ++bit) {
        for (const int64_t offset : {-1, 0}) words.push_back((int64_t{1} << bit) + offset);
        words.push_back(-(int64_t{1} << bit));
    }
    for (const int64_t a : words) {
        for (const int64_t b : words) {
            for (const bool wide : {false, true}) {
                ASSERT_EQ(run({{a, b}}, wide, wide, nullptr), expected({{a, b}}, wide, wide))
                    << a << " * " << b;
            }
        }
    }
}

TEST_F(FoldedMultiplier, SumsUpToThirteenProductsInFull) {
    std::mt19937_64 random(1);
    for (int n = 0; n < 4000; ++n) {
        std::vector<Pair> pairs(1 + random() % 13);
        const int small = n % 3 == 0 ? 0 : static_cast<int>(random() % kBits);
        for (Pair& pair : pairs) {
            pair.a = n % 50 == 0 ? -(int64_t{1} << (kBits - 1))
                                 : from_port(random(), kBits) >> (random() % (small + 1));
            pair.b = n % 100 == 0 ? -(int64_t{1} << (kBits - 1)) : from_port(random(), kBits);
        }
        const bool wide = random() % 2 != 0;
        const bool no_sign = random() % 2 != 0;
        ASSERT_EQ(run(pairs, wide, no_sign, n % 2 == 0 ? nullptr : &random),
                  expected(pairs, wide, no_sign))
            << n;
    }
}

TEST_F(FoldedMultiplier, LatencyIsFour) {
    const int64_t one = int64_t{1} << (kBits - 2);
    ASSERT_EQ(run({{0, 0}}, false, false, nullptr), 0);
    const int64_t sum = run({{-one, -one}}, false, false, nullptr);
    EXPECT_EQ(sum, expected({{-one, -one}}, false, false));
    EXPECT_EQ(before_ != sum, kBits > 24) << "narrow words are complete before the last part";
    idle(20);
    EXPECT_EQ(from_port(dut_->sum_o, kBits), sum) << "kept";
}

}  // namespace
}  // namespace curvecore::tb
