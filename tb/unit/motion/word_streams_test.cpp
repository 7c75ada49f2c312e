// SPDX-License-Identifier: Apache-2.0
// rtl/queue/word_streams.sv, its entries, ledgers and guard, beside the rule without clocks that
// hls/word_entry.hpp and hls/word_ledger.hpp are: one event after the other, and time to settle.
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "Vword_streams.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/segments/random_streams.hpp"
#include "tb/support/segments/word_rule.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kAge = 10;      // ticks that the guard keeps for the age of its counts
constexpr int kSettles = 24;  // clocks

CoreParameters core_of_test() {
    CoreParameters core;
    core.coef_bits = CFG_CoefBits;
    core.guard_bits = 10;
    core.position_bits = CFG_FineBits - core.guard_bits;
    core.aux_axes = CFG_AuxAxes;
    core.splines = CFG_Splines;
    return core;
}

class WordStreams : public testing::Test {
  protected:
    /// Lets in random programs from a reset on.
    void programs(std::uint64_t seed, int count) {
        random_.seed(seed);
        digest_ = static_cast<std::uint16_t>(random_());
        stop_ticks_ = 1 + static_cast<std::int64_t>(random_() >> (52 + random_() % 12));
        RandomStreams maker(core_, digest_, random_(), static_cast<int>(random_() % 9));
        Streams streams;
        for (int n = 0; n < count; ++n) maker.program(streams, random_() % 8 == 0);
        if (random_() % 2 == 0) maker.change(streams, static_cast<int>(seed) % maker.kChanges);
        if (random_() % 4 == 0) maker.damage(streams);
        auto words = streams.words();
        reset();
        for (int still = 0; still < 100 && !HasFailure() && !lifted_; ++still) {
            const Stream stream = random_() % 2 == 0 ? kSegments : kPieces;
            if (!pending_[stream] && !words[stream].empty()) {
                give(stream, words[stream].front());
                words[stream].pop_front();
                still = 0;
            }
            settle();
            if (random_() % 16 == 0 && rule_->frames(kSegments) > 0) take_frame(kSegments);
            settle();
            if (random_() % 8 == 0) tick();
            settle();
        }
        rule_->fault() != 0 ? ++faults_ : 0;
    }

    int words_ = 0;
    int faults_ = 0;
    int holds_ = 0;
    int begins_ = 0;
    int short_queues_ = 0;

  private:
    void reset() {
        rule_.emplace(core_,
                      std::array<int, 2>{CFG_SegmentQueueWords + 2, CFG_ProfileQueueWords + 2},
                      digest_, true);
        guard_ = hls::UnderrunGuard();
        pending_ = {};
        lifted_ = false;
        next_.reset();
        active_ = false;
        dut_->digest_i = digest_;
        dut_->segment_valid_i = dut_->profile_valid_i = 0;
        dut_->segment_ready_i = dut_->profile_ready_i = 0;
        dut_->take_i = 0;
        dut_->started_i = 0;
        dut_->stop_ticks_i = static_cast<std::uint32_t>(stop_ticks_);
        show_present();
        dut_.reset();
        settle();
    }

    void show_present() {
        dut_->active_i = active_ ? 1 : 0;
        dut_->present_final_i = active_ && present_.final ? 1 : 0;
        dut_->present_ticks_i = static_cast<std::uint32_t>(to_port((rest() >> 16) + kAge, 22));
    }

    /// Puts a word into an entry, where it waits for the rule.
    void give(Stream stream, std::uint64_t word) {
        auto& valid = stream == kSegments ? dut_->segment_valid_i : dut_->profile_valid_i;
        (stream == kSegments ? dut_->segment_data_i : dut_->profile_data_i) = word;
        valid = 1;
        dut_.settle();
        ASSERT_TRUE(stream == kSegments ? dut_->segment_ready_o : dut_->profile_ready_o);
        dut_.tick();
        valid = 0;
        pending_[stream] = word;
        ++words_;
    }

    /// Applies the rule to what waits, and gives the module time; both say the same then.
    void settle() {
        look();
        for (bool moves = true; moves;) {
            moves = false;
            for (const Stream stream : {kSegments, kPieces}) {
                if (!pending_[stream]) continue;
                if (rule_->offer(stream, *pending_[stream]) == WordRule::Fate::kStays) continue;
                pending_[stream].reset();
                look();
                moves = true;
            }
        }
        for (int n = 0; n < kSettles; ++n) dut_.tick();
        const int fault = rule_->fault() | (guard_.short_queue() ? 32 : 0);
        EXPECT_EQ(dut_->fault_o, fault);
        EXPECT_EQ(dut_->begin_o, guard_.may_begin() ? 1 : 0);
        EXPECT_EQ(dut_->queued_o, rule_->frames(kPieces) + (next_ ? 1 : 0) > 0 ? 1 : 0);
        // Both streams of programs that are apart are complete for the clocks of the comparison. A
        // queue that did not cover a stop, and is full for some clocks when it does, is ample.
        const hls::WordLedger& ledger = rule_->ledger();
        const std::int64_t queued = std::min(ledger.queued_ticks(), ledger.queued_segment_ticks());
        const bool covers = guard_.short_queue() && queued + (rest() >> 16) > stop_ticks_;
        lifted_ = (ledger.apart() || covers) && guard_.hold() && !dut_->hold_o;
        if (lifted_) return;
        EXPECT_EQ(dut_->hold_o, guard_.hold() ? 1 : 0);
        EXPECT_EQ(dut_->underrun_o, guard_.underrun() ? 1 : 0);
        holds_ += guard_.hold() ? 1 : 0;
        begins_ += guard_.may_begin() ? 1 : 0;
        short_queues_ += guard_.short_queue() ? 1 : 0;
    }
    void look() {
        guard_.tick(rule_->ledger(), {active_, active_ && present_.final, rest()}, rule_->full(),
                    stop_ticks_);
    }

    /// Takes a whole frame out of a queue; its words are those that came in.
    WordRule::Frame take_frame(Stream stream) {
        const WordRule::Frame frame = rule_->take(stream);
        auto& ready = stream == kSegments ? dut_->segment_ready_i : dut_->profile_ready_i;
        for (const std::uint64_t word : frame) {
            EXPECT_TRUE(stream == kSegments ? dut_->segment_valid_o : dut_->profile_valid_o);
            EXPECT_EQ(stream == kSegments ? dut_->segment_data_o : dut_->profile_data_o, word);
            ready = 1;
            dut_.tick();
            ready = 0;
            for (int n = 0; n < 4; ++n) dut_.tick();
        }
        return frame;
    }

    /// The present piece goes on, the next one begins, another is fetched.
    void tick() {
        if (active_) {
            time_ += static_cast<std::int64_t>(random_() >> (38 + random_() % 26));
            if (rest() <= 0) {
                active_ = !present_.final;
                time_ = end();
                if (active_ && next_) begin();
            }
        } else if (next_ && guard_.may_begin() && random_() % 2 == 0) {
            begin();
        }
        show_present();
        settle();
        if (!next_ && rule_->frames(kPieces) > 0) next_ = WordRule::piece_of(take_frame(kPieces));
    }
    std::int64_t end() const { return std::int64_t{present_.ticks} << hls::kRateFrac; }
    std::int64_t rest() const { return active_ ? end() - time_ : 0; }

    void begin() {
        dut_->take_i = 1;
        dut_->take_ticks_i = static_cast<std::uint32_t>(next_->ticks);
        dut_->take_final_i = next_->final ? 1 : 0;
        dut_.tick();
        dut_->take_i = 0;
        rule_->ledger().take(next_->ticks, next_->final);
        active_ = true;
        present_ = *next_;
        next_.reset();
        time_ = 0;
    }

    CoreParameters core_ = core_of_test();
    ClockedDut<Vword_streams> dut_;
    std::mt19937_64 random_;
    std::uint16_t digest_ = 0;
    std::int64_t stop_ticks_ = 1;
    std::optional<WordRule> rule_;
    hls::UnderrunGuard guard_;
    std::array<std::optional<std::uint64_t>, 2> pending_;
    std::optional<hls::ProfileWords> next_;
    hls::ProfileWords present_;
    bool active_ = false;
    std::int64_t time_ = 0;
    bool lifted_ = false;  // a hold, by programs that are apart
};

TEST_F(WordStreams, AreTheRuleWithoutClocks) {
    for (std::uint64_t seed = 1; seed <= 150 && !HasFailure(); ++seed) {
        programs(seed, 1 + static_cast<int>(seed % 4));
        if (HasFailure()) FAIL() << "seed " << seed;
    }
    EXPECT_GT(words_, 10'000);
    EXPECT_GT(faults_, 20);
    EXPECT_GT(holds_, 50);
    EXPECT_GT(begins_, 1000);
    EXPECT_GT(short_queues_, 100);
}

}  // namespace
}  // namespace curvecore::tb
