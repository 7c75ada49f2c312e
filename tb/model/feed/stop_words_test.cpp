// SPDX-License-Identifier: Apache-2.0
// Stop branches as words: which may enter, which of them counts, how a stop uses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hls/stop_schedule.hpp"
#include "hls/word_entry.hpp"

namespace curvecore::tb::stop_words_test {

using hls::Entry;
using hls::StopStep;

std::vector<std::uint64_t> piece_words(unsigned sequence, bool final = false) {
    std::vector<std::uint64_t> words(hls::kProfileBusWords);
    hls::ProfileWords piece;
    piece.final = final;
    hls::pack(piece, sequence, words.data());
    return words;
}

std::vector<Entry> enter(const std::vector<std::uint64_t>& words) {
    hls::PieceEntry entry;
    std::vector<Entry> all;
    for (const std::uint64_t word : words) all.push_back(entry.take(word));
    return all;
}

std::vector<std::uint64_t> joined(std::vector<std::uint64_t> a,
                                  const std::vector<std::uint64_t>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const std::vector<std::uint64_t> kBranch{hls::pack_stop(300), hls::pack(StopStep{16, -5, false}),
                                         hls::pack(StopStep{16, 5, true})};

TEST(StopWords, StandBeforeAPiece) {
    hls::WordCheck check;
    std::vector<std::uint64_t> words;
    for (unsigned n = 0; n < 3; ++n) {
        auto frame = n == 1 ? piece_words(n) : joined(kBranch, piece_words(n));
        check.seal(frame.data(), frame.size());
        words = joined(words, frame);
    }
    for (const Entry entry : enter(words)) {
        EXPECT_TRUE(entry == Entry::kPassed || entry == Entry::kCompleted);
    }
}

TEST(StopWords, ThatCannotBeAreRefused) {
    EXPECT_EQ(enter(joined(kBranch, kBranch)).at(3), Entry::kBadWord) << "two before one piece";
    EXPECT_EQ(enter({hls::pack_stop(0)}).at(0), Entry::kBadWord) << "no wait";
    EXPECT_EQ(enter({kBranch[0], hls::pack(StopStep{0, -5, true})}).at(1), Entry::kBadWord);
    EXPECT_EQ(enter({kBranch[1]}).at(0), Entry::kBadWord) << "a step without a stop";
    EXPECT_EQ(enter({kBranch[0], kBranch[1], piece_words(0)[0]}).at(2), Entry::kBadWord)
        << "no last step";
}

TEST(StopWords, OfTheBranchBeforeComeAloneBehindOneWithSteps) {
    const auto stream = [](const std::vector<bool>& again, std::size_t final) {
        hls::WordCheck check;
        std::vector<std::uint64_t> words;
        for (unsigned n = 0; n < again.size(); ++n) {
            auto frame = joined(again[n] ? std::vector{hls::pack_stop(7, true)} : kBranch,
                                piece_words(n, n == final));
            check.seal(frame.data(), frame.size());
            words = joined(words, frame);
        }
        return enter(words);
    };
    for (const Entry entry : stream({false, true, true, false, true}, 2)) {
        EXPECT_TRUE(entry == Entry::kPassed || entry == Entry::kCompleted);
    }
    EXPECT_EQ(stream({true}, 9).at(0), Entry::kBadWord) << "none before";
    EXPECT_EQ(enter({hls::pack_stop(7) | std::uint64_t{1} << 21}).at(0), Entry::kBadWord);
}

TEST(StopWords, KeepTheirSteps) {
    for (const StopStep& step : {StopStep{2047, -1, true}, StopStep{1, INT32_MIN, false},
                                 StopStep{77, INT32_MAX, false}}) {
        const StopStep back = hls::unpack_step(hls::pack(step));
        EXPECT_EQ(back.ticks, step.ticks);
        EXPECT_EQ(back.change, step.change);
        EXPECT_EQ(back.last, step.last);
    }
}

constexpr std::int32_t kOne = 1 << 16;

/// A scaler with branches of 64 ticks to rest before some pieces, one of which begins in `begin`.
class Stops {
  public:
    std::int32_t tick(std::int32_t target, bool begin = false) {
        const std::int32_t rate = schedule_.tick(scaler_, target, false);
        if (begin) {
            schedule_.load_wait(100);
            schedule_.load_step({32, -(1 << 22), false});
            schedule_.load_step({32, 1 << 22, true});
            schedule_.begin_piece(false);
        }
        return rate;
    }
    /// Runs some ticks; in the last a program begins that has no branches.
    void begin_program(int ticks) {
        for (int n = 0; n < ticks; ++n) tick(kOne);
        schedule_.begin_piece(true);
    }

    /// Ticks until the rate is 0, at most 100,000; a piece begins every `every` ticks.
    int stop(int every = 1 << 20) {
        int ticks = 0;
        while (tick(0, ticks % every == every - 1) != 0 && ticks < 100000) ++ticks;
        return ticks;
    }

  private:
    hls::TimeScaler scaler_{1 << 14, 1 << 20};  // 4,000 ticks and some to rest
    hls::StopSchedule schedule_;
};

/// A branch with the steps of the one before is what it would be with steps of its own.
TEST(StopSchedule, ABranchAgainIsTheOneBefore) {
    constexpr std::int32_t kTargets[] = {0, kOne, 3 * kOne / 4};
    std::mt19937 random(1);
    int stops = 0;  // that took steps of a branch
    for (int run = 0; run < 200; ++run) {
        hls::StopSchedule own, again;
        hls::TimeScaler own_scaler{1 << 24, 1 << 27}, again_scaler{1 << 24, 1 << 27};
        std::vector<StopStep> steps;
        std::int32_t target = kOne;
        bool takes = false;
        for (int tick = 0; tick < 600; ++tick) {
            if (random() % 50 == 0) target = kTargets[random() % 3];
            const std::int32_t rate = own.tick(own_scaler, target, false);
            int taken = 0;
            const auto next_step = [&] {
                ++taken;
                return again.next_step();
            };
            ASSERT_EQ(rate, again_scaler.tick(target, false, again.due(), next_step))
                << run << ", tick " << tick;
            again.count(again_scaler.steady(), again_scaler.passed());
            if (taken > 0 && !takes) ++stops;
            takes = taken > 0 || (takes && rate > 0);
            if (random() % 8 != 0) continue;
            // Seldom, so that the steps of a stop come again behind it.
            const bool fresh = steps.empty() || random() % 20 == 0;
            if (fresh) {
                const auto log2 = static_cast<int>(2 + random() % 4);
                const auto change = static_cast<std::int32_t>((std::int64_t{1} << 32) >> 2 * log2);
                steps = {{1 << log2, -change, false}, {1 << log2, change, true}};
            }
            const auto wait = static_cast<std::int32_t>(1 + random() % 100);
            own.load_wait(wait);
            again.load_wait(wait, !fresh);
            for (const StopStep& step : steps) {
                own.load_step(step);
                if (fresh) again.load_step(step);
            }
            const bool first = random() % 20 == 0;
            own.begin_piece(first);
            again.begin_piece(first);
        }
    }
    EXPECT_GT(stops, 200) << "more than one a run";
}

TEST(StopSchedule, AStopBeginsWhereTheBranchDoes) {
    Stops stops;
    for (int n = 0; n < 10; ++n) stops.tick(1 << 16);
    stops.tick(1 << 16, true);
    for (int n = 1; n < hls::kStopLead; ++n) EXPECT_EQ(stops.tick(1 << 16), 1 << 16);
    EXPECT_LT(stops.tick(0), 1 << 16) << "the tick of the branch";
    EXPECT_EQ(stops.stop(), 61);
}

TEST(StopSchedule, AStopWaitsForTheNextBranch) {
    Stops stops;
    stops.tick(1 << 16);
    stops.tick(1 << 16);
    stops.tick(1 << 16, true);
    for (int n = 0; n < hls::kStopLead; ++n) stops.tick(1 << 16);
    for (int n = 0; n < 20; ++n) EXPECT_EQ(stops.tick(0), 1 << 16);
    EXPECT_EQ(stops.tick(0, true), 1 << 16);
    EXPECT_EQ(stops.stop(), hls::kStopLead - 1 + 62);
}

TEST(StopSchedule, AStopInAProgramsFirstTicksWaitsForTheirBranch) {
    for (int after = 0; after < hls::kStopLead; ++after) {
        Stops stops;
        stops.tick(kOne);
        stops.tick(kOne);
        stops.tick(kOne, true);
        for (int n = 0; n < after; ++n) stops.tick(kOne);
        EXPECT_EQ(stops.stop(), hls::kStopLead - 1 - after + 62) << after;
    }
}

/// Ticks of a stop after time was slower for a while, in which a branch passed; the next one
/// follows 100 ticks at the rate 1 after it was announced, or does not.
int stop_after_slower(bool follows) {
    Stops stops;
    for (int n = 0; n < 10; ++n) stops.tick(kOne);
    for (int n = 0; n < 1000; ++n) stops.tick(30000, n == 200);
    int ones = 0;
    while (ones < 3) ones += stops.tick(kOne) == kOne ? 1 : 0;
    for (int n = 0; n < 100 - hls::kStopLead - 10; ++n) {
        if (stops.tick(0) != kOne) return -1;
    }
    stops.tick(0, follows);
    return stops.stop();
}
TEST(StopSchedule, AStopWaitsForABranchOfWhichASlowerOneTold) {
    EXPECT_EQ(stop_after_slower(true), hls::kStopLead - 1 + 62);
    EXPECT_GT(stop_after_slower(false), 4000);
}

TEST(StopSchedule, AStopWaitsForTheBranchAfterTheOneThatWasTaken) {
    Stops stops;
    for (int n = 0; n < 5 + hls::kStopLead; ++n) stops.tick(kOne, n == 5);
    EXPECT_LT(stops.stop(), 200);
    while (stops.tick(kOne) != kOne) {
    }
    for (int n = 0; n < 3; ++n) stops.tick(kOne);
    for (int n = 0; n < 60; ++n) ASSERT_EQ(stops.tick(0), kOne) << n;
    stops.tick(0, true);
    EXPECT_EQ(stops.stop(), hls::kStopLead - 1 + 62);
}

TEST(StopSchedule, AProgramDoesNotWaitForBranchesOfTheOneBefore) {
    Stops stops;
    stops.tick(kOne);
    stops.tick(kOne, true);
    stops.begin_program(hls::kStopLead + 1);
    for (int n = 0; n < hls::kStopLead; ++n) stops.tick(kOne);
    int ticks = 0;
    while (stops.tick(0) == kOne) ++ticks;
    EXPECT_LT(ticks, hls::kStopLead + 10);
}

TEST(StopSchedule, AStopThatIsLetDownGoesTheSlowWay) {
    Stops stops;
    stops.tick(1 << 16);
    stops.tick(1 << 16);
    stops.tick(1 << 16, true);
    for (int n = 0; n < hls::kStopLead; ++n) stops.tick(1 << 16);
    EXPECT_GT(stops.stop(), 4000);
}

/// R of the branch after some ticks of path time.
double branch_rate(double time) {
    double rate = 1;
    double slope = 0;
    for (int n = 0; n < 64; ++n) {
        slope += std::ldexp(n < 32 ? -1 : 1, -10);
        rate += slope * std::clamp(time - n, 0.0, 1.0);
    }
    return rate;
}

TEST(StopSchedule, AStopFromASlowerRateIsTheBranchInItsTime) {
    for (const std::int32_t rate : {ref::kBranchRate, 36865, 40000, 50001, 65000, 65535, kOne}) {
        Stops stops;
        const double r0 = std::ldexp(rate, -16);
        double time = 1 - hls::kStopLead;  // since the branch began
        stops.tick(rate, true);
        while (time <= -1) {
            ASSERT_EQ(stops.tick(rate), rate);
            time += r0;
        }
        std::int32_t before = rate;
        for (int n = 0; before != 0; ++n) {
            const std::int32_t now = stops.tick(0);
            time += r0;
            ASSERT_NEAR(now, 65536 * r0 * branch_rate(time), 2.5) << rate << " " << n;
            ASSERT_LE(now, before);
            before = now;
        }
        EXPECT_NEAR(time, 63.5, 0.51) << rate;
    }
}

TEST(StopSchedule, AStopFromARateThatChangedSinceTakesNoBranch) {
    for (const int later : {1, 5, hls::kStopLead - 2}) {
        Stops stops;
        for (int n = 0; n < 20; ++n) stops.tick(kOne);
        stops.tick(kOne, true);
        for (int n = 0; n < later; ++n) stops.tick(kOne);
        stops.tick(65535);
        EXPECT_GT(stops.stop(), 3000) << later;
    }
}

TEST(StopSchedule, AStopFromLessThanTheBranchRateTakesNoBranch) {
    Stops stops;
    for (int n = 0; n < 5000; ++n) stops.tick(ref::kBranchRate - 1, n % 50 == 0);
    EXPECT_GT(stops.stop(50), 2000);
}

TEST(StopSchedule, AfterAStopTimeGoesOn) {
    Stops stops;
    for (int n = 0; n < 50; ++n) stops.tick(1 << 16, n == 5);
    EXPECT_LT(stops.stop(50), 200);
    std::int32_t rate = 0;
    std::int32_t most = 0;
    for (int n = 0; n < 20000; ++n) {
        const std::int32_t next = stops.tick(1 << 16, n % 40 == 0);
        most = std::max(most, next - rate);
        rate = next;
    }
    EXPECT_EQ(rate, 1 << 16);
    EXPECT_LE(most, (1 << 4) + 1) << "by the slow bounds";
    EXPECT_LT(stops.stop(50), 200) << "and stops by a branch again";
}

}  // namespace curvecore::tb::stop_words_test
