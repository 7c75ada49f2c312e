// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv against the kernels: path increments from the rates it reports,
// samples from its path increments, whatever stalls, holds, overrides and gaps in the feed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>
#include <functional>
#include <random>

#include "Vmotion_interpolator.h"
#include "hls/curve_kernel.hpp"
#include "hls/path_kernel.hpp"
#include "hls/time_scaler.hpp"
#include "tb/support/clocked_dut.hpp"
#include "tb/support/core_configuration.hpp"
#include "tb/support/legal_segments.hpp"
#if CFG_Splines
#include "tb/support/mixed_segments.hpp"
#endif
#include "tb/support/port_word.hpp"
#include "tb/support/random_pieces.hpp"

namespace curvecore::tb {
namespace {

using C = Config;
constexpr int64_t kAcceleration = int64_t{1} << 22;
constexpr int64_t kSlope = 40 * kAcceleration;
constexpr int kMaxStepExponent = 9;  // short steps: many segments in a short program

int ticks_of_a_stop() {
    hls::TimeScaler scaler(kAcceleration, kSlope);
    int ticks = 1;
    while (scaler.tick(0) != 0) ++ticks;
    return ticks;
}

class MotionInterpolator : public testing::Test {
  protected:
    MotionInterpolator() {
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        dut_->sample_request_valid_i = 0;
        dut_->sample_ready_i = 0;
        dut_->hold_i = 0;
        dut_->override_i = 65536;
        dut_->kill_i = 0;
        dut_->samples_per_tick_log2_i = 0;
        dut_->hold_acceleration_i = kAcceleration;
        dut_->hold_slope_i = kSlope;
        dut_->stop_ticks_i = static_cast<uint32_t>(ticks_of_a_stop());
        dut_.reset();
    }

    /// A program, after those before it: `pieces` and random segments as long.
    void program(const std::vector<hls::ProfileWords>& pieces) {
#if CFG_Splines
        MixedSegments<C> shapes(random_(), kMaxStepExponent);
        segments(chain(shapes, profile(pieces), int64_t{1} << (kMaxStepExponent + hls::kPathFrac)));
#else
        LegalSegments<C> shapes(random_(), kMaxStepExponent);
        segments(chain(shapes, profile(pieces)));
#endif
    }

    /// Returns the length of the path.
    int64_t profile(const std::vector<hls::ProfileWords>& pieces) {
        int64_t length = 0;
        for (const hls::ProfileWords& piece : pieces) {
            pieces_.push_back(piece);
            uint64_t words[hls::kProfileBusWords];
            hls::pack(piece, words);
            profile_words_.insert(profile_words_.end(), words, words + hls::kProfileBusWords);
            length += piece.ds;
        }
        length_ += length;
        return length;
    }

    void segments(const std::vector<hls::SegmentWords<C>>& added) {
        for (const hls::SegmentWords<C>& segment : added) {
            segments_.push_back(segment);
            uint64_t words[hls::segment_bus_words<C>()];
            hls::pack<C>(segment, words);
            segment_words_.insert(segment_words_.end(), words, words + hls::segment_bus_words<C>());
        }
    }

    /// Pieces of a machine: `mean` quanta per tick.
    static std::vector<hls::ProfileWords> pieces(uint32_t seed, int count, int shortest,
                                                 int longest, int64_t mean) {
        std::mt19937 random(seed);
        std::vector<hls::ProfileWords> result;
        for (int n = 0; n < count; ++n) {
            const int ticks = shortest + static_cast<int>(random() % (longest - shortest + 1));
            result.push_back(piece_of(ticks * mean + random() % 1000, ticks,
                                      1e-3 * (random() % 1900), n == count - 1));
        }
        return result;
    }

    void samples_per_tick_log2(int n) {
        dut_->samples_per_tick_log2_i = to_port(n, 4);
        share_ = hls::SampleShare(n);
    }

    /// One clock. Valid words and requests stay until they are taken.
    void clock() {
        if (!dut_->segment_valid_i && !segment_words_.empty() && go(stall_)) {
            dut_->segment_data_i = segment_words_.front();
            dut_->segment_valid_i = 1;
        }
        if (!dut_->profile_valid_i && !profile_words_.empty() && go(profile_stall_)) {
            dut_->profile_data_i = profile_words_.front();
            dut_->profile_valid_i = 1;
        }
        if (requesting_ && go(stall_)) dut_->sample_request_valid_i = 1;
        dut_->sample_ready_i = go(stall_) ? 1 : 0;
        dut_.settle();
        const bool segment_word = dut_->segment_valid_i && dut_->segment_ready_o;
        const bool profile_word = dut_->profile_valid_i && dut_->profile_ready_o;
        const bool request = dut_->sample_request_valid_i && dut_->sample_request_ready_o;
        if (dut_->path_valid_o) check_move();
        if (dut_->sample_valid_o && dut_->sample_ready_i) check_sample();
        dut_.tick();
        if (segment_word) segment_words_.pop_front();
        if (profile_word) profile_words_.pop_front();
        if (segment_word) dut_->segment_valid_i = 0;
        if (profile_word) dut_->profile_valid_i = 0;
        if (request) dut_->sample_request_valid_i = 0;
        requested_ += request ? 1 : 0;
    }

    void check_move() {
        const auto rate = static_cast<int32_t>(dut_->path_rate_o);
        if (share_.needs_tick()) {
            share_.tick(path_kernel_.tick(rate, [this](hls::ProfileWords& piece) {
                if (next_piece_ == pieces_.size()) return false;
                piece = pieces_[next_piece_++];
                return true;
            }));
            check_rate(rate);
        }
        const int64_t ds = share_.sample();
        path_ += ds;
        ASSERT_EQ(static_cast<int64_t>(dut_->path_ds_o), ds) << "move " << moves_.size();
        ASSERT_EQ(static_cast<int64_t>(dut_->path_o), path_);
        moves_.push_back(ds);
    }

    /// First and second differences are bounded; the port has 16 of the 32 fraction bits.
    void check_rate(int32_t rate) {
        ASSERT_LE(std::abs(rate - rate_), (kSlope >> 16) + 1) << "move " << moves_.size();
        ASSERT_LE(std::abs(rate - 2 * rate_ + rate_before_), (kAcceleration >> 16) + 2)
            << "move " << moves_.size();
        rate_before_ = rate_;
        rate_ = rate;
    }

    void check_sample() {
        ASSERT_LT(samples_, static_cast<int64_t>(moves_.size())) << "a sample before its move";
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel_.sample(
            moves_[static_cast<std::size_t>(samples_)],
            [this] { return segments_.at(next_segment_++); }, fine);
        for (int axis = 0; axis < C::kAxes; ++axis) {
            ASSERT_EQ(signed_field(dut_->sample_fine_o, axis * C::kFineBits, C::kFineBits),
                      from_port(static_cast<uint64_t>(fine[axis]), C::kFineBits))
                << "sample " << samples_ << " axis " << axis;
            ASSERT_EQ(
                signed_field(dut_->sample_position_o, axis * C::kPositionBits, C::kPositionBits),
                from_port(static_cast<uint64_t>(hls::to_position<C>(fine[axis])), C::kPositionBits))
                << "sample " << samples_ << " axis " << axis;
        }
        ++samples_;
    }

    /// Fills the queues.
    void fill() {
        for (int n = 0; n < 6000; ++n) clock();
    }

    /// Requests until the program is over; `each` runs before every clock.
    void run(const std::function<void()>& each = [] {}) {
        requesting_ = true;
        while (!HasFatalFailure() && (path_ < length_ || path_kernel_.active())) {
            each();
            clock();
        }
        if (HasFatalFailure()) return;
        requesting_ = false;
        const int rest = 20000;
        for (int n = 0; n < rest && (samples_ < requested_ || n < 200); ++n) clock();
        EXPECT_EQ(samples_, requested_);
        EXPECT_EQ(path_, length_);
        EXPECT_FALSE(dut_->active_o);
    }

    /// Resets the core, and forgets all programs.
    void start_afresh() {
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        dut_->sample_request_valid_i = 0;
        dut_->hold_i = 0;
        dut_->kill_i = 0;
        requesting_ = false;
        dut_.reset();
        pieces_.clear();
        segments_.clear();
        profile_words_.clear();
        segment_words_.clear();
        next_piece_ = 0;
        next_segment_ = 0;
        length_ = 0;
        path_kernel_ = {};
        share_ = hls::SampleShare(0);
        kernel_ = {};
        rate_ = 65536;
        rate_before_ = 65536;
        path_ = 0;
        moves_.clear();
        requested_ = 0;
        samples_ = 0;
    }

    bool go(int stall_percent) { return static_cast<int>(random_() % 100) >= stall_percent; }

    ClockedDut<Vmotion_interpolator> dut_;
    std::mt19937 random_{1};
    int stall_ = 0;  // percent of clocks, every handshake
    int profile_stall_ = 0;
    bool requesting_ = false;

    std::vector<hls::ProfileWords> pieces_;
    std::vector<hls::SegmentWords<C>> segments_;
    std::deque<uint64_t> profile_words_;
    std::deque<uint64_t> segment_words_;
    std::size_t next_piece_ = 0;
    std::size_t next_segment_ = 0;
    int64_t length_ = 0;

    hls::PathKernel path_kernel_;
    hls::SampleShare share_{0};
    hls::MotionKernel<C> kernel_;
    int32_t rate_ = 65536;
    int32_t rate_before_ = 65536;
    int64_t path_ = 0;
    std::deque<int64_t> moves_;
    int64_t requested_ = 0;
    int64_t samples_ = 0;
};

TEST_F(MotionInterpolator, EqualsKernels) {
    program(pieces(1, 100, 20, 100, 3 << 16));
    fill();
    run();
    EXPECT_FALSE(dut_->underrun_o);
}

TEST_F(MotionInterpolator, EqualsKernelsWithRandomStalls) {
    for (const int stall : {20, 60, 90}) {
        program(pieces(stall, 60, 20, 60, 5 << 16));
        stall_ = stall;
        profile_stall_ = 0;
        fill();
        run();
        if (HasFatalFailure()) FAIL() << "stall " << stall << " %";
    }
}

TEST_F(MotionInterpolator, SharesTicksAmongSamples) {
    samples_per_tick_log2(3);
    program(pieces(2, 30, 20, 60, 9 << 16));
    fill();
    run();
}

TEST_F(MotionInterpolator, TakesARequestEveryInterval) {
    if (CFG_Build == 1) GTEST_SKIP() << "the serial core's samples take as long as their steps";
    // Segments of one step each, of 256 samples: more clocks than a step or a segment's words take.
    profile(pieces(3, 30, 100, 200, 1 << 14));
    LegalSegments<C> shapes(3);
    for (int n = 0; n < 20; ++n) segments({shapes.whole(6, 1)});
    fill();
    requesting_ = true;
    while (samples_ < 500) clock();
    const uint64_t begin = dut_.cycle();
    while (samples_ < 2500) clock();
    EXPECT_EQ(dut_.cycle() - begin, 2000U * CFG_SampleInterval);
}

TEST_F(MotionInterpolator, HoldAtEverySampleKeepsTheGeometry) {
    program(pieces(4, 12, 20, 40, 3 << 16));
    fill();
    int64_t held = 0;
    run([&] {
        const int64_t phase = static_cast<int64_t>(dut_.cycle()) % 900;
        dut_->hold_i = phase < 400 + requested_ % 64 ? 1 : 0;
        held += rate_ == 0 ? 1 : 0;
    });
    EXPECT_GT(held, 0);
}

TEST_F(MotionInterpolator, OverrideAtRandomKeepsTheGeometry) {
    program(pieces(5, 100, 20, 100, 3 << 16));
    fill();
    run([&] {
        if (random_() % 300 != 0) return;
        const uint32_t kind = random_() % 3;
        dut_->override_i = kind == 0 ? 65536 : kind == 1 ? 6554 : random_() % 65537;
    });
}

TEST_F(MotionInterpolator, KillStopsForGood) {
    program(pieces(6, 90, 200, 400, 3 << 16));
    fill();
    requesting_ = true;
    for (int n = 0; n < 4000 * CFG_SampleInterval; ++n) clock();
    dut_->kill_i = 1;
    clock();
    dut_->kill_i = 0;
    for (int n = 0; n < 4000 * CFG_SampleInterval; ++n) clock();
    EXPECT_TRUE(dut_->killed_o);
    EXPECT_EQ(rate_, 0);
    const int64_t path = path_;
    for (int n = 0; n < 1000; ++n) clock();
    EXPECT_EQ(path_, path);
    dut_.reset();
    EXPECT_FALSE(dut_->killed_o);
}

TEST_F(MotionInterpolator, StopsInTimeWhenTheProfileRunsLowAndGoesOnWhenFed) {
    program(pieces(7, 600, 5, 20, 3 << 16));
    profile_stall_ = 50;
    fill();
    int64_t stood = 0;
    run([&] {
        // The host feeds, slowly, only when the motion stands.
        profile_stall_ = rate_ == 0 ? 97 : 100;
        stood += rate_ == 0 ? 1 : 0;
    });
    EXPECT_TRUE(dut_->underrun_o);
    EXPECT_GT(stood, 0);
}

TEST_F(MotionInterpolator, StartsAfreshAfterAReset) {
    for (int round = 0; round < 24; ++round) {
        program(pieces(100 + round, 20, 5, 40, 3 << 16));
        stall_ = 30 * (round % 3);
        requesting_ = true;
        const auto clocks = static_cast<int>(random_() % 3000);
        for (int n = 0; n < clocks && !HasFatalFailure(); ++n) {
            dut_->hold_i = round % 4 == 1 && n > clocks / 2;
            dut_->kill_i = round % 4 == 2 && n == clocks / 2;
            clock();
        }
        start_afresh();
        program(pieces(200 + round, 10, 10, 20, 3 << 16));
        fill();
        run();
        if (HasFailure()) FAIL() << "round " << round;
    }
}

TEST_F(MotionInterpolator, CountsEmptySegments) {
    program(pieces(8, 40, 20, 40, 99 << 16));
    const auto empty = static_cast<int>(
        std::count_if(segments_.begin(), segments_.end(),
                      [](const hls::SegmentWords<C>& segment) { return segment.length == 0; }));
    fill();
    run();
    EXPECT_GT(empty, 0);
    EXPECT_EQ(dut_->empty_segments_o, empty);
}

}  // namespace
}  // namespace curvecore::tb
