// SPDX-License-Identifier: Apache-2.0
// rtl/output/path_outputs.sv equals hls/path_outputs.hpp before each sample is drawn, whatever
// words wait and however many samples are made ahead; nothing is on without the drives.
#include "hls/path_outputs.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vpath_outputs.h"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::tb {
namespace {
using namespace sysc;

constexpr std::size_t kAhead = 15;
constexpr int kPeriod = 64;    // clocks of a sample at least
constexpr int kChange = 7;     // clocks of one change more in it
constexpr unsigned kWord = 6;  // clocks from a word to the next one, at least
constexpr int kTurn = 4095;    // clocks of a period of the level's pin

class PathOutputs : public ::testing::Test {
  protected:
    void SetUp() override {
        dut_.limit_cycles(UINT64_MAX);
        dut_->valid_i = 0;
        dut_->made_i = 0;
        dut_->taken_i = 0;
        dut_->drawn_i = 0;
        dut_->enable_i = 1;
        dut_->flush_i = 0;
        dut_->keep_i = 0;
        dut_->delay_write_i = 0;
        dut_.reset();
    }

    unsigned any(unsigned end) { return static_cast<unsigned>(random_() % end); }

    /// Offers a word for a clock; returns whether it was taken.
    bool offer(std::uint64_t word) {
        dut_->valid_i = 1;
        dut_->word_i = word;
        dut_.settle();
        const bool taken = dut_->next_o && dut_->ready_o;
        clock();
        dut_->valid_i = 0;
        for (unsigned n = 1; n < kWord + any(2); ++n) clock();
        return taken;
    }
    void push(const hls::OutputChange& change) {
        const std::uint64_t word = hls::pack(change, number_++);
        ASSERT_TRUE(offer(word));
        ASSERT_TRUE(twin_.take(word));
    }
    /// Makes a sample `way` quanta behind the last one.
    void make(std::uint64_t way) {
        path_ += way;
        made_.push_back(path_);
        dut_->made_i = 1;
        dut_->path_i = static_cast<std::uint32_t>(path_ >> 8);
        clock();
        dut_->made_i = 0;
    }
    void take() {
        twin_.sample(made_.front());
        made_.pop_front();
        dut_->taken_i = 1;
        clock();
        dut_->taken_i = 0;
        for (unsigned n = any(3) == 0 ? any(100) : 0; n > 0; --n) clock();
        draw();
        dut_->drawn_i = CFG_Delay == 0 && any(4) == 0;  // and none waits
    }
    /// Goes through a period without a sample.
    void none() {
        twin_.none();
        draw();
    }
    void draw() {
        dut_->drawn_i = 1;
        clock();
        since_ = 1;
    }
    /// Sets the delay, without the drives: what was on is off.
    void delay(unsigned samples) {
        dut_->enable_i = 0;
        clock();
        dut_->delay_write_i = 1;
        dut_->delay_i = samples;
        clock();
        dut_->delay_write_i = 0;
        dut_->enable_i = 1;
        twin_.delay(static_cast<int>(samples));
        flush(false);
    }
    /// Drops all that waits, at a standstill.
    void flush(bool keep) {
        twin_.flush(keep);
        dut_->keep_i = keep;
        number_ = 0;
        path_ = 0;
        made_.clear();
        dut_->flush_i = 1;
        clock();
        dut_->flush_i = 0;
        since_ = 0;  // a word at the path's begin is due at once
    }
    void clock() {
        dut_.tick();
        dut_->drawn_i = 0;
        ++since_;
    }
    void expect_equal() {
        dut_.settle();
        ASSERT_EQ(dut_->bits_o, twin_.bits());
        ASSERT_EQ(dut_->power_o, twin_.power());
        ASSERT_EQ(dut_->settled_o != 0, twin_.settled());
        settled_ += twin_.settled();
    }
    int clocks_on() {
        int on = 0;
        for (int n = 0; n < kTurn; ++n) {
            on += dut_->pwm_o;
            clock();
        }
        return on;
    }

    ClockedDut<Vpath_outputs> dut_;
    std::mt19937_64 random_{1};
    hls::PathOutputs twin_;
    unsigned number_ = 0;
    std::uint64_t path_ = 0;
    std::deque<std::uint64_t> made_;
    int settled_ = 0;  // samples in which no way is to come
    int since_ = kPeriod;
};

TEST_F(PathOutputs, EqualTheirTwinInEverySample) {
    constexpr int kSamples = 200'000;
    std::deque<std::uint64_t> places;  // of changes, in length units
    std::uint64_t placed = 0;
    unsigned scale = 1;
    int changes = 0;  // in the sample under way
    unsigned moved = 0, follows = 0, partly = 0, together = 0, kept = 0;
    for (int n = 0; n < kSamples; ++n) {
        if (n % 1000 == 0) scale = 1U << any(20);
        while (made_.size() < 1 + any(kAhead)) {
            make(any(4) == 0 ? 0 : (std::uint64_t(any(1 + scale)) << 16) + any(1 << 16));
        }
        for (unsigned words = any(3); words > 0 && twin_.waiting() < CFG_Words - 3; --words) {
            const std::uint64_t least = (path_ >> 16) > placed ? (path_ >> 16) - placed : 0;
            hls::OutputChange change;
            change.kind = static_cast<hls::OutputKind>(any(3));
            change.value = change.kind == hls::OutputKind::kBits    ? any(256)
                           : change.kind == hls::OutputKind::kLevel ? any(4096)
                           : any(4) == 0                            ? any(2)
                                         : hls::follow_at((1 + any(1 + 2 * scale)) / 128.0);
            change.distance = static_cast<std::uint32_t>(least + any(1 + scale));
            if (any(4) == 0) change.distance = static_cast<std::uint32_t>(least);
            placed += change.distance;
            follows += change.kind == hls::OutputKind::kFollow && change.value > 1;
            push(change);
        }
        while (since_ < kPeriod + kChange * changes + 2 * kPeriod * (any(100) == 0)) clock();
        expect_equal();
        if (any(500) == 0) {
            const bool other = CFG_Delay != 0 && any(2) == 0;
            other ? delay(any(CFG_Delay)) : flush(any(2) == 0);
            kept += twin_.bits() != 0;
            placed = 0;
            expect_equal();
            continue;
        }
        const std::size_t before = twin_.waiting();
        CFG_Delay != 0 && any(4) == 0 ? none() : take();
        changes = static_cast<int>(before - twin_.waiting());
        moved += changes > 0;
        together += changes > 1;
        partly += twin_.power() > 0 && twin_.power() < 4095;
        ASSERT_FALSE(HasFatalFailure()) << "sample " << n;
    }
    EXPECT_GT(moved, kSamples / 10U);
    EXPECT_GT(follows, kSamples / 10U);
    EXPECT_GT(partly, kSamples / 10U);
    EXPECT_GT(together, 100U);
    EXPECT_GT(kept, 100U);
    EXPECT_GT(settled_, 1000);
    if (CFG_Delay != 0) {
        EXPECT_LT(settled_, kSamples / 2);
    }
}

TEST_F(PathOutputs, AreOnForTheirShareOfATurn) {
    for (const std::uint32_t level : {0U, 1U, 2047U, 4094U, 4095U}) {
        push({hls::OutputKind::kLevel, level, 0});
        for (int n = 0; n < kPeriod; ++n) clock();
        EXPECT_EQ(clocks_on(), static_cast<int>(level));
    }
}

TEST_F(PathOutputs, AreOffAtOnceWithoutTheDrivesAndStayOff) {
    push({hls::OutputKind::kBits, 255, 0});
    push({hls::OutputKind::kLevel, 4095, 0});
    push({hls::OutputKind::kBits, 15, 1000});
    for (int n = 0; n < kPeriod; ++n) clock();
    expect_equal();
    EXPECT_EQ(dut_->bits_o, 255);
    EXPECT_EQ(dut_->pwm_o, 1);
    dut_->enable_i = 0;
    dut_.settle();
    EXPECT_EQ(dut_->bits_o, 0);
    EXPECT_EQ(dut_->pwm_o, 0);
    clock();
    dut_->enable_i = 1;
    for (int n = 0; n < kPeriod; ++n) clock();
    EXPECT_EQ(dut_->bits_o, 0);
    EXPECT_EQ(clocks_on(), 0);
    EXPECT_EQ(dut_->room_o, CFG_Words) << "what waited is gone";
}

TEST_F(PathOutputs, LeaveWhatIsNotTheirNextWord) {
    const hls::OutputChange change{hls::OutputKind::kBits, 1, 5};
    EXPECT_FALSE(offer(hls::pack(change, 1))) << "one is missing";
    EXPECT_FALSE(offer(hls::pack_stop(3))) << "of another tag";
    EXPECT_FALSE(offer(hls::pack(change, 0) | std::uint64_t(3) << 38)) << "of no kind";
    EXPECT_TRUE(offer(hls::pack(change, 0)));
    EXPECT_FALSE(offer(hls::pack(change, 0))) << "doubled";
    for (unsigned n = 1; dut_->room_o > 0; ++n) EXPECT_TRUE(offer(hls::pack(change, n)));
    EXPECT_FALSE(offer(hls::pack(change, CFG_Words))) << "without room";
}

}  // namespace
}  // namespace curvecore::tb
