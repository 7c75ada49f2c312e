// SPDX-License-Identifier: Apache-2.0
// rtl/queue/word_queue.sv: order, capacity, throughput, reset.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vword_queue.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

class WordQueue : public testing::Test {
  protected:
    WordQueue() {
        offer(false, false);
        dut_.reset();
    }

    void offer(bool write, bool read) {
        dut_->valid_i = write ? 1 : 0;
        dut_->ready_i = read ? 1 : 0;
        dut_->data_i = next_ & low_mask(CFG_Bits);
    }

    /// Advances by one clock. Returns true if a word came out.
    bool clock(bool write, bool read) {
        offer(write, read);
        dut_.settle();
        if (write && dut_->ready_o) {
            expected_.push_back(next_ & low_mask(CFG_Bits));
            next_ = next_ * 6364136223846793005U + 1442695040888963407U;
        }
        const bool taken = read && dut_->valid_o;
        if (taken) {
            EXPECT_FALSE(expected_.empty());
            EXPECT_EQ(dut_->data_o, expected_.front());
            expected_.pop_front();
        }
        dut_.tick();
        return taken;
    }

    ClockedDut<Vword_queue> dut_;
    uint64_t next_ = 1;
    std::deque<uint64_t> expected_;
};

TEST_F(WordQueue, KeepsOrderWithRandomStalls) {
    std::mt19937 random(1);
    for (int n = 0; n < 200000 && !HasFailure(); ++n) {
        const unsigned write = n / 5000 % 3 == 0 ? 90 : 40;
        const unsigned read = n / 7000 % 3 == 0 ? 90 : 40;
        clock(random() % 100 < write, random() % 100 < read);
    }
}

TEST_F(WordQueue, HoldsDepthPlusTwoWords) {
    for (int n = 0; n < CFG_Depth + 10; ++n) clock(true, false);
    EXPECT_EQ(expected_.size(), CFG_Depth + 2U);
    EXPECT_FALSE(dut_->ready_o);
    for (int n = 0; n < CFG_Depth + 10; ++n) clock(false, true);
    EXPECT_TRUE(expected_.empty());
    EXPECT_FALSE(dut_->valid_o);
}

TEST_F(WordQueue, LatencyIsThreeClocks) {
    clock(true, true);
    EXPECT_FALSE(clock(false, true));
    EXPECT_FALSE(clock(false, true));
    EXPECT_TRUE(clock(false, true));
}

TEST_F(WordQueue, PassesAWordPerClock) {
    int words = 0;
    for (int n = 0; n < 1000; ++n) words += clock(true, true) ? 1 : 0;
    EXPECT_EQ(words, 997);
}

TEST_F(WordQueue, ResetEmptiesIt) {
    for (int n = 0; n < CFG_Depth; ++n) clock(true, false);
    offer(false, false);
    dut_.reset();
    expected_.clear();
    EXPECT_FALSE(dut_->valid_o);
    EXPECT_TRUE(dut_->ready_o);
    for (int n = 0; n < 3 * CFG_Depth; ++n) clock(true, n > 5);
    EXPECT_GT(next_, 1U);
}

}  // namespace
}  // namespace curvecore::tb
