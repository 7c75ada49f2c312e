// SPDX-License-Identifier: Apache-2.0
// rtl/path/path_generator.sv against PathKernel, tick by tick.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vpath_generator.h"
#include "hls/path_kernel.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/segments/random_pieces.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kInterval = CFG_Interval;
constexpr int kLatency = kInterval == 1 ? 35 : kInterval == 2 ? 37 : 43;

class PathGenerator : public testing::Test {
  protected:
    PathGenerator() {
        dut_->word_valid_i = 0;
        dut_->begin_i = 1;
        dut_->queued_i = 0;
        dut_->rate_valid_i = 0;
        dut_->scaled_i = 0;
        dut_->steady_i = 0;
        dut_->passed_i = 0;
        dut_->step_ready_i = 0;
        dut_.reset();
    }

    /// Puts whole pieces into the queue.
    void publish(const std::vector<hls::ProfileWords>& pieces) {
        for (const hls::ProfileWords& piece : pieces) {
            published_.push_back(piece);
            uint64_t words[hls::kProfileBusWords];
            hls::pack(piece, 0, words);
            words_.insert(words_.end(), words, words + hls::kProfileBusWords);
        }
    }

    /// Advances by one clock; a tick of `rate` is offered unless it is negative. Returns true if it
    /// was taken.
    bool clock(int32_t rate, bool word_allowed = true) {
        dut_->queued_i = published_.size() > taken_ ? 1 : 0;
        dut_->word_valid_i = word_allowed && !words_.empty() ? 1 : 0;
        if (dut_->word_valid_i) dut_->word_i = words_.front();
        dut_->rate_valid_i = rate >= 0 ? 1 : 0;
        dut_->rate_i = to_port(std::max(rate, 0), 17);
        dut_->held_i = static_cast<int>(random_() % 100) < held_percent_;
        dut_.settle();
        // The ticks left are those of a piece as soon as it has begun: the ledger no longer counts
        // it.
        if (taken_ticks_ > 8) {
            EXPECT_NEAR(static_cast<double>(from_port(dut_->ticks_left_o, 22)),
                        static_cast<double>(taken_ticks_), 3.0);
            ++lefts_;
        }
        taken_ticks_ = dut_->piece_take_o ? static_cast<int>(dut_->next_ticks_o) : 0;
        const bool ticked = rate >= 0 && dut_->rate_ready_o;
        if (ticked) rates_.push_back({rate, dut_->held_i != 0});
        if (dut_->tick_taken_o) predict();
        if (dut_->piece_take_o) ++taken_;
        if (dut_->word_valid_i && dut_->word_ready_o) words_.pop_front();
        if (dut_->ds_valid_o) compare();
        dut_.tick();
        return ticked;
    }

    void predict() {
        const auto [rate, held] = rates_.front();
        rates_.pop_front();
        const auto next_piece = [this](hls::ProfileWords& piece) {
            if (next_ == published_.size()) return false;
            piece = published_[next_++];
            return true;
        };
        const int64_t ds = kernel_.tick(rate, next_piece, held);
        expected_.push_back({ds, rate, dut_.cycle()});
        ++ticks_;
    }

    void compare() {
        ASSERT_FALSE(expected_.empty()) << "an increment without a tick";
        const Expected expected = expected_.front();
        expected_.pop_front();
        ASSERT_EQ(static_cast<int64_t>(dut_->ds_o), expected.ds) << "tick " << compared_;
        ASSERT_EQ(static_cast<int32_t>(dut_->ds_rate_o), expected.rate) << "tick " << compared_;
        ASSERT_EQ(static_cast<int>(dut_.cycle() - expected.cycle), kLatency)
            << "tick " << compared_;
        walked_ += expected.ds;
        ++compared_;
    }

    /// Runs ticks until the program is over and compared.
    template <class Rate>
    void run(Rate&& rate, int idle_percent, int word_stall_percent) {
        bool begun = false;
        int32_t offered = -1;
        while (!begun || kernel_.active()) {
            if (offered < 0 && static_cast<int>(random_() % 100) >= idle_percent) offered = rate();
            if (clock(offered, static_cast<int>(random_() % 100) >= word_stall_percent)) {
                offered = -1;
            }
            begun = begun || kernel_.active();
            if (HasFatalFailure()) return;
        }
        drain();
    }

    void run_long(int exponent) {
        const int32_t ticks = (1 << exponent) - (exponent % 2);
        publish({piece_of(int64_t{1} << (20 + exponent), ticks, 0.3, false),
                 piece_of((int64_t{1} << 43) + 12345, ticks / 2 + 1, 1.7, true)});
        run([] { return 65536; }, 0, 0);
    }

    void drain() {
        for (int n = 0; n < kLatency + 50; ++n) clock(-1);
        EXPECT_TRUE(expected_.empty());
    }

    static int64_t length(const std::vector<hls::ProfileWords>& pieces) {
        int64_t sum = 0;
        for (const hls::ProfileWords& piece : pieces) sum += piece.ds;
        return sum;
    }

    int32_t any_rate() {
        const uint32_t kind = random_() % 4;
        if (kind == 0) return 65536;
        if (kind == 1) return 0;
        return static_cast<int32_t>(random_() % 65537);
    }

    struct Expected {
        int64_t ds;
        int32_t rate;
        uint64_t cycle;
    };

    ClockedDut<Vpath_generator> dut_;
    hls::PathKernel kernel_;
    std::vector<hls::ProfileWords> published_;
    std::size_t next_ = 0;   // next piece of the kernel
    std::size_t taken_ = 0;  // pieces taken by the RTL
    std::deque<uint64_t> words_;
    std::deque<std::pair<int32_t, bool>> rates_;  // rates, and whether each was held
    int held_percent_ = 0;
    std::deque<Expected> expected_;
    int taken_ticks_ = 0;  // ticks of the piece that began in the clock before, or 0
    int lefts_ = 0;        // number of such pieces compared
    int64_t walked_ = 0;
    int64_t ticks_ = 0;
    int64_t compared_ = 0;
    std::mt19937 random_{1};
};

TEST_F(PathGenerator, EqualsKernelAtFullRate) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        publish(random_pieces(seed, 50, 200));
        run([] { return 65536; }, 0, 0);
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
    EXPECT_EQ(walked_, length(published_));
    EXPECT_GT(lefts_, 500);
}

TEST_F(PathGenerator, EqualsKernelAtAnyRateWithStalls) {
    for (uint32_t seed = 1; seed <= 60; ++seed) {
        publish(random_pieces(seed, 40, seed % 2 ? 300 : 4));
        const int stall = seed % 3 == 0 ? 0 : 70;
        run([this] { return any_rate(); }, seed % 5 == 0 ? 0 : 30, stall);
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
    EXPECT_EQ(walked_, length(published_));
}

TEST_F(PathGenerator, EqualsKernelWithLongPieces) {
    for (int exponent = 10; exponent < 19; ++exponent) {
        run_long(exponent);
        ASSERT_FALSE(HasFatalFailure()) << "exponent " << exponent;
    }
    EXPECT_EQ(walked_, length(published_));
}

TEST_F(PathGenerator, EqualsKernelWithTheLongestPieces) {
    run_long(19);
    EXPECT_EQ(walked_, length(published_));
}

TEST_F(PathGenerator, WaitsAtThePiecesEndWhenItIsNotFed) {
    for (uint32_t seed = 1; seed <= 40; ++seed) {
        const std::vector<hls::ProfileWords> pieces = random_pieces(seed, 30, 6);
        for (const hls::ProfileWords& piece : pieces) {
            publish({piece});
            const int clocks = static_cast<int>(random_() % 60);
            for (int n = 0; n < clocks; ++n) {
                clock(seed % 2 ? 65536 : any_rate());
                if (HasFatalFailure()) FAIL() << "seed " << seed;
            }
        }
        while (kernel_.active()) clock(65536);
        drain();
    }
    EXPECT_EQ(walked_, length(published_));
}

TEST_F(PathGenerator, ClampsPiecesWhoseWordsGoAstray) {
    for (uint32_t seed = 1; seed <= 60; ++seed) {
        std::vector<hls::ProfileWords> pieces = random_pieces(seed, 30, 60);
        for (hls::ProfileWords& piece : pieces) {
            for (int64_t& c : piece.c) c = from_port(random_() * uint64_t{0x9e3779b97f4a7c15}, 34);
        }
        publish(pieces);
        run([this] { return any_rate(); }, 0, 0);
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
    EXPECT_EQ(walked_, length(published_));
}

TEST_F(PathGenerator, TakesATickEveryIntervalAcrossPieces) {
    std::vector<hls::ProfileWords> pieces;
    const int shortest = (6 + kInterval - 1) / kInterval;
    for (int n = 0; n < 200; ++n) {
        // The tick that begins a program is the first one of its first piece.
        const int ticks = shortest + (n == 0 ? 1 : n % 3);
        pieces.push_back(piece_of(1000 + n, ticks, 1.0, n == 199));
    }
    publish(pieces);
    for (int n = 0; n < 20; ++n) clock(-1);  // the first piece is loaded
    while (!kernel_.active()) clock(65536);
    const uint64_t first = dut_.cycle();
    const int64_t ticks = ticks_;
    while (kernel_.active()) clock(65536);
    EXPECT_EQ(dut_.cycle() - first, static_cast<uint64_t>(kInterval * (ticks_ - ticks)));
    drain();
}

TEST_F(PathGenerator, NoProgramBeginsInATickThatIsHeld) {
    for (uint32_t seed = 1; seed <= 40; ++seed) {
        publish(random_pieces(seed, 20, seed % 2 ? 100 : 4));
        const int64_t walked = walked_;
        held_percent_ = 100;
        for (int n = 0; n < 200; ++n) clock(any_rate());
        drain();
        ASSERT_EQ(walked_, walked) << "seed " << seed;
        ASSERT_FALSE(dut_->active_o) << "seed " << seed;
        // A program that has begun continues at its rates, held or not.
        held_percent_ = 90;
        run([this] { return any_rate(); }, 30, 30);
        ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
    EXPECT_EQ(walked_, length(published_));
}

TEST_F(PathGenerator, StandsStillWithoutAPiece) {
    for (int n = 0; n < 100; ++n) clock(any_rate());
    drain();
    EXPECT_EQ(walked_, 0);
    EXPECT_FALSE(dut_->active_o);
    EXPECT_GE(compared_, 100 / kInterval - 1);
}

}  // namespace
}  // namespace curvecore::tb
