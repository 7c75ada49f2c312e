// SPDX-License-Identifier: Apache-2.0
// rtl/engine/engine_entry.sv: order of each stream, room, which stream's word is there and when.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <random>

#include "Vengine_entry.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

class EngineEntry : public testing::Test {
  protected:
    EngineEntry() {
        dut_->take_i = 0;
        dut_->of_profile_i = 0;
        offer(false, false);
        dut_.reset();
    }

    void offer(bool segment, bool profile) {
        dut_->segment_valid_i = segment ? 1 : 0;
        dut_->profile_valid_i = profile ? 1 : 0;
        dut_->segment_i = next_ & low_mask(48);
        dut_->profile_i = ~next_ & low_mask(48);
    }

    /// Advances by one clock; the streams' words enter where there is room.
    void clock(bool segment, bool profile) {
        offer(segment, profile);
        dut_.settle();
        const bool room = expected_[0].size() < CFG_Words;
        ASSERT_EQ(dut_->segment_ready_o, room);
        ASSERT_EQ(dut_->segment_room_o, CFG_Words - expected_[0].size());
        ASSERT_EQ(dut_->profile_room_o, CFG_Words - expected_[1].size());
        ASSERT_EQ(dut_->profile_ready_o, expected_[1].size() < CFG_Words && !(segment && room));
        ASSERT_EQ(dut_->segment_waits_o, !expected_[0].empty());
        ASSERT_EQ(dut_->profile_waits_o, !expected_[1].empty());
        refused_ += segment && profile && !room && dut_->profile_ready_o == 0 ? 1 : 0;
        std::deque<uint64_t>& at_hand = expected_[dut_->of_profile_i];
        if (dut_->take_i != 0) at_hand.pop_front();
        if (segment && dut_->segment_ready_o) expected_[0].push_back(dut_->segment_i);
        if (profile && dut_->profile_ready_o) expected_[1].push_back(dut_->profile_i);
        next_ = next_ * 6364136223846793005U + 1442695040888963407U;
        dut_.tick();
    }

    /// Takes a word as the engine does: it finds one waiting, then says whose it wants.
    void take(int stream, std::mt19937& random, unsigned offered) {
        const auto pass = [&] { clock(random() % 100 < offered, random() % 100 < offered); };
        if (expected_[stream].empty()) return pass();
        dut_->of_profile_i = static_cast<unsigned>(stream);
        pass();
        pass();
        for (int n = 0; n < 3; ++n) {
            ASSERT_EQ(dut_->word_o, expected_[stream].front());
            pass();
        }
        dut_->take_i = 1;
        pass();
        dut_->take_i = 0;
        ++taken_;
    }

    ClockedDut<Vengine_entry> dut_;
    uint64_t next_ = 1;
    std::array<std::deque<uint64_t>, 2> expected_;
    int taken_ = 0;
    int refused_ = 0;  // clocks in which neither stream found room
};

TEST_F(EngineEntry, KeepsTheOrderOfEachStream) {
    std::mt19937 random(1);
    for (int n = 0; n < 100'000 && !HasFatalFailure(); ++n) {
        take(static_cast<int>(random() % 2), random, n / 5000 % 2 == 0 ? 60 : 3);
    }
    EXPECT_GT(taken_, 40'000);
    EXPECT_GT(refused_, 1000);
}

TEST_F(EngineEntry, AWordIsThereTwoClocksAfterItCame) {
    clock(true, false);
    const uint64_t word = expected_[0].front();
    clock(false, false);
    EXPECT_EQ(dut_->word_o, word);
}

TEST_F(EngineEntry, IsEmptyAfterAReset) {
    for (int n = 0; n < 2 * CFG_Words; ++n) clock(n % 2 == 0, true);
    dut_.reset();
    expected_ = {};
    for (int n = 0; n < 4; ++n) clock(false, false);
    clock(true, true);
    EXPECT_EQ(expected_[0].size(), 1U);
}

}  // namespace
}  // namespace curvecore::tb
