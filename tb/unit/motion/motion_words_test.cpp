// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv and the host: late words, and invalid words. In each case the path is
// the kernel's, time's rate keeps its bounds, and a sample comes or a fault is reported.
#include "hls/registers/registers.h"
#include "hls/word_entry.hpp"
#include "tb/support/bench/motion_bench.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/unit/motion/damaged_words.hpp"

namespace curvecore::tb {
namespace {

class MotionWords : public MotionInterpolator {
  protected:
    int stalls() const {
        const char* count = std::getenv("CURVECORE_STALLS");
        const bool engine = core_.build == Build::kEngine;
        return count ? std::atoi(count) : cases(engine ? 20 : 60, engine ? 500 : 5000);
    }
    /// A host that sometimes stops feeding a stream, for any time.
    class Host {
      public:
        Host(uint32_t seed, int pace) : pace_(pace), random_(seed) {}
        /// Percentage of clocks in which it feeds nothing.
        int stall() {
            if (left_-- == 0) {
                away_ = !away_;
                left_ = static_cast<int>(std::exp(static_cast<double>(random_() % 1000) / 120));
                if (away_) left_ *= 8 * pace_;
                stalls_ += away_ ? 1 : 0;
            }
            return away_ ? 100 : 0;
        }
        int stalls() const { return stalls_; }

      private:
        int pace_;
        std::mt19937 random_;
        bool away_ = false;
        int left_ = 1;
        int stalls_ = 0;
    };

    /// Requests samples until all words are taken and the machine stands or is idle.
    void run_out() {
        requesting_ = true;
        int64_t path = -1;
        for (int still = 0; still < 3 && !HasFatalFailure();) {
            const int64_t samples = samples_;
            wait(3000);
            if (fault() == 0 && dut_->active_o) {
                ASSERT_GT(samples_, samples) << "no sample, and no fault";
            }
            const bool words = !segment_words_.empty() || !profile_words_.empty();
            still = words || path_ != path ? 0 : still + 1;
            path = path_;
        }
    }

    uint32_t fault() { return dut_->fault_o; }

    /// Returns true if a full queue of the program's pieces covers a stop wherever it begins; their
    /// branches take most of it.
    bool pieces_cover_a_stop() const {
        constexpr std::size_t kGuarded = 64;  // ticks that started, and those that the guard keeps
        const std::size_t room = core_configuration().profile_queue_words - hls::kProfileBusWords;
        const auto words = [this](std::size_t piece) {
            const Stop& stop = stops_[piece];
            return hls::kProfileBusWords + (stop.wait == 0 ? 0
                                            : stop.again   ? 1
                                                           : 1 + stop.steps.size());
        };
        std::size_t end = 0;
        std::size_t queued = 0;  // words and ticks of first .. end - 1
        std::size_t ticks = 0;
        for (std::size_t first = 0; first < pieces_.size(); ++first) {
            for (; end < pieces_.size() && queued + words(end) <= room; ++end) {
                queued += words(end);
                ticks += static_cast<std::size_t>(pieces_[end].ticks);
            }
            if (end == pieces_.size()) return true;
            if (ticks <= dut_->stop_ticks_i + kGuarded) return false;
            queued -= words(first);
            ticks -= static_cast<std::size_t>(pieces_[first].ticks);
        }
        return true;
    }
};

TEST_F(MotionWords, KeepTheLimitsHoweverTheHostStalls) {
    int stalls_seen = 0;
    // Also until a stall was so long that time stopped, and behind it.
    const auto more = [&] { return stalls_seen < stalls() || !dut_->underrun_o; };
    for (uint32_t seed = 1; more() && seed < 10'000 && !HasFatalFailure(); ++seed) {
        Host segments(2 * seed, pace_);
        Host profile(2 * seed + 1, pace_);
        program(pieces(seed, 60, 5, 40, (seed % 8) << 16));
        int64_t waited = 0;  // clocks of a program without a requested sample
        int64_t samples = 0;
        run([&] {
            segment_stall_ = seed % 3 == 0 ? 0 : segments.stall();
            profile_stall_ = seed % 3 == 1 ? 0 : profile.stall();
            const bool waits = dut_->active_o && samples_ < requested_ && samples_ == samples;
            waited = waits ? waited + 1 : 0;
            samples = samples_;
            ASSERT_LT(waited, 20000) << "no sample, and no fault";
        });
        stalls_seen += segments.stalls() + profile.stalls();
        if (HasFatalFailure()) FAIL() << "seed " << seed;
    }
    EXPECT_TRUE(dut_->underrun_o) << "the stalls are too short";
}

TEST_F(MotionWords, StandUntilTheyCoverAStop) {
    program(pieces(3, 300, 5, 20, 1 << 16));
    segment_stall_ = 100;
    fill();
    requesting_ = true;
    fill();
    EXPECT_EQ(path_, 0);
    EXPECT_FALSE(dut_->active_o);
    segment_stall_ = 0;
    if (core_.build == Build::kEngine && core_.aux_axes > 1) {
        // Long frames enter it more slowly than samples can be asked for.
        requesting_ = false;
        fill();
    }
    run();
    EXPECT_FALSE(dut_->underrun_o);
}

// The program before is complete, and so are the next one's pieces: its segments come later.
TEST_F(MotionWords, OfTheNextProgramStandUntilTheyCoverAStop) {
    program(pieces(3, 30, 10, 20, 3 << 16));
    const int64_t first = length_;
    const auto words = static_cast<std::ptrdiff_t>(segment_words_.size());
    program(pieces(4, 60, 10, 20, 3 << 16));
    const std::deque<uint64_t> later(segment_words_.begin() + words, segment_words_.end());
    segment_words_.erase(segment_words_.begin() + words, segment_words_.end());
    fill();
    run_out();
    EXPECT_EQ(path_, first);
    EXPECT_FALSE(dut_->active_o);
    segment_words_ = later;
    requesting_ = false;
    fill();
    run();
    EXPECT_FALSE(dut_->underrun_o);
}

TEST_F(MotionWords, OfSegmentsThatRunLowStopTheMotionInTime) {
    program(pieces(7, 600, 5, 20, 3 << 16));
    const std::size_t all = segment_words_.size();
    while (all - segment_words_.size() < 600) clock();
    segment_stall_ = 100;
    fill();
    int64_t stood = 0;
    run([&] {
        // The host feeds segments, slowly, only while the motion stands.
        segment_stall_ = rate_ == 0 || !dut_->active_o ? 97 : 100;
        stood += rate_ == 0 ? 1 : 0;
    });
    EXPECT_TRUE(dut_->underrun_o);
    EXPECT_GT(stood, 0);
}

// A program of pieces so short that a full queue of them is shorter than a stop.
TEST_F(MotionWords, ThatNeverCoverAStopAreAFault) {
    program(pieces(5, 400, 1, 1, 3 << 16));
    dut_->stop_ticks_i = 500;
    dut_.reset();
    requesting_ = true;
    wait(20000);
    EXPECT_EQ(fault(), CURVECORE_STATE_MOTION_SHORT_QUEUE);
    EXPECT_EQ(path_, 0);
}

// Segments that claim more time than they have, and then do not come: they mislead the guard.
TEST_F(MotionWords, ThatLieAboutTheirTicksAreFoundOut) {
    const auto whole = pieces(9, 200, 20, 20, 3 << 16);
    LegalSegments shapes(core_, 9, kMaxStepExponent);
    auto segments = chain(shapes, 200 * 20 * (int64_t{3} << 16));
    join(segments);
    program(whole, segments);
    segment_words_.clear();
    set_ticks(whole, segments);
    const std::size_t cut = segments.size() / 3;
    uint32_t stolen = 0;
    for (std::size_t n = cut; n < segments.size(); ++n) {
        stolen += segments[n].ticks;
        segments[n].ticks = 0;
    }
    segments[0].ticks += stolen;
    hls::WordCheck check(static_cast<uint16_t>(dut_->digest_i));
    for (std::size_t n = 0; n < cut; ++n) {
        std::vector<uint64_t> bus = bus_words(segments[n], static_cast<unsigned>(n));
        check.seal(bus.data(), bus.size());
        segment_words_.insert(segment_words_.end(), bus.begin(), bus.end());
    }
    fill();
    requesting_ = true;
    const int most = std::max(1'000'000, 60'000 * pace_);
    for (int n = 0; n < most && fault() == 0; ++n) clock();
    EXPECT_EQ(fault(), CURVECORE_STATE_MOTION_NO_SAMPLE);
}

TEST_F(MotionWords, ThatCannotBeCutTheStreamAndDrawWhatIsQueuedToAStop) {
    std::mt19937 random(11);
    int found = 0;
    int short_of_ticks = 0;  // programs
    int unseen = 0;
    const int rounds = stalls();
    rates_ = Rates::kAny;
    most_wait_ = 10;
    constexpr int kLongestBranch = 250;  // ticks
    dut_->stop_ticks_i = kStopTicks + static_cast<uint32_t>(most_wait_ + kLongestBranch);
    dut_.limit_cycles(~std::uint64_t{0});  // some two million of a round on the engine
    start_afresh();
    for (int round = 0; round < rounds; ++round) {
        branch_percent_ = round % 4 == 1 ? 40 : 0;
        program(pieces(300 + round, 60, 5, 20, (round % 8) << 16));
        if (!pieces_cover_a_stop()) {
            ++short_of_ticks;
            start_afresh();
            continue;
        }
        const bool of_segments = round % 2 == 0;
        const Stream stream =
            of_segments
                ? Stream{segment_words_, profile_words_, segment_frame(), hls::Tag::kLength}
                : Stream{profile_words_, segment_words_, hls::kProfileBusWords, hls::Tag::kPiece};
        const std::deque<uint64_t> intended = stream.words;
        damage(stream, random);

        // The entry's twin predicts the result
        const auto digest = static_cast<uint16_t>(dut_->digest_i);
        hls::SegmentEntry<RunTimeFormat> segment_entry(format_, core_.splines != 0, digest);
        hls::PieceEntry piece_entry(digest);
        uint32_t expected = 0;
        std::size_t until = 0;  // words until the first that is refused, or one more than all
        for (const uint64_t word : stream.words) {
            const hls::Entry entry =
                of_segments ? segment_entry.take(word) : piece_entry.take(word);
            until += expected == 0 ? 1 : 0;
            if (entry == hls::Entry::kBadWord) {
                expected |= of_segments ? CURVECORE_STATE_MOTION_SEGMENT_WORD
                                        : CURVECORE_STATE_MOTION_PIECE_WORD;
            }
            if (entry == hls::Entry::kBadOrder) {
                expected |= of_segments ? CURVECORE_STATE_MOTION_SEGMENT_ORDER
                                        : CURVECORE_STATE_MOTION_PIECE_ORDER;
            }
        }
        const bool same = stream.words == intended;
        until += expected == 0 ? 1 : 0;
        if (passes(stream, intended, until)) {
            ++unseen;
            start_afresh();
            continue;
        }
        run_out();
        EXPECT_EQ(fault(), expected) << "round " << round;
        if (same) {
            EXPECT_EQ(path_, length_) << "round " << round;
        }
        found += expected != 0 ? 1 : 0;
        start_afresh();
        if (HasFailure()) FAIL() << "round " << round;
    }
    EXPECT_GT(found, rounds / 2);
    EXPECT_LE(short_of_ticks, rounds / 20);
    EXPECT_LE(unseen, 1 + rounds / 500);
}

// Each program has its own digest, which applies from its first word on.
TEST_F(MotionWords, AreOfTheDigestThatTheyAreMadeFor) {
    const uint16_t first = 0x1234;
    for (const int other : {0, 1, 0x100, 0x101, 0x8000, 0x5555}) {
        for (const bool told : {true, false}) {
            make_for(first);
            program(pieces(31, 30, 10, 20, 3 << 16));
            run();
            const int64_t length = length_;
            make_for(static_cast<uint16_t>(first ^ other));
            if (!told) dut_->digest_i = first;
            program(pieces(32, 30, 10, 20, 3 << 16));
            run_out();
            if (told || other == 0) {
                EXPECT_EQ(fault(), 0U);
                EXPECT_EQ(path_, length_);
            } else {
                EXPECT_TRUE(fault() == CURVECORE_STATE_MOTION_SEGMENT_WORD ||
                            fault() == CURVECORE_STATE_MOTION_PIECE_WORD)
                    << fault();
                EXPECT_EQ(path_, length);
            }
            start_afresh();
            if (HasFailure()) FAIL() << other << " " << told;
        }
    }
}

// A program, queued behind another, that begins elsewhere than the first one ended. Its pieces are
// queued, and time does not begin on them.
TEST_F(MotionWords, OfAProgramThatBeginsElsewhereAreAFaultAndTheOneBeforeIsDrawn) {
    const int64_t far = int64_t{1} << (core_.position_bits + core_.guard_bits - 3);
    for (const int64_t off : {int64_t{1}, int64_t{-3}, far}) {
        program(pieces(21, 30, 10, 20, 3 << 16));
        const int64_t length = length_;
        const auto whole = pieces(22, 30, 10, 20, 3 << 16);
        LegalSegments shapes(core_, 22, kMaxStepExponent);
        int64_t more = 0;
        for (const hls::ProfileWords& piece : whole) more += piece.ds;
        auto segments = chain(shapes, more);
        join(segments);
        segments.front().start[random_() % 3] ^= off;
        set_ticks(whole, segments);
        send(whole, segments);
        run_out();
        EXPECT_EQ(fault(), CURVECORE_STATE_MOTION_SEGMENT_ORDER) << off;
        EXPECT_EQ(path_, length) << off;
        EXPECT_FALSE(dut_->active_o) << off;
        start_afresh();
        if (HasFailure()) FAIL() << off;
    }
}

// Fields that are legal on their own: a path or ticks that differ from the other stream's.
TEST_F(MotionWords, ThatEndApartAreAFault) {
    for (int round = 0; round < 8; ++round) {
        const auto whole = pieces(400 + round, 40, 10, 20, 3 << 16);
        LegalSegments shapes(core_, 9, kMaxStepExponent);
        int64_t length = 0;
        for (const hls::ProfileWords& piece : whole) length += piece.ds;
        auto segments = chain(shapes, length + (round % 2 == 0 ? 1 : round % 4 == 1 ? -1 : 0));
        join(segments);
        set_ticks(whole, segments);
        if (round % 4 == 3) segments[1].ticks ^= 1;
        send(whole, segments);
        run_out();
        EXPECT_EQ(fault(), CURVECORE_STATE_MOTION_APART) << "round " << round;
        start_afresh();
        if (HasFailure()) FAIL() << "round " << round;
    }
}

}  // namespace
}  // namespace curvecore::tb
