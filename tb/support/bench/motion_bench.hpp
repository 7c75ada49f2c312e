// SPDX-License-Identifier: Apache-2.0
// A bench for motion_interpolator against the kernels: path increments from the rates that it
// reports, samples from its path increments.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>
#include <functional>
#include <random>

#include "hls/path_kernel.hpp"
#include "hls/stop_schedule.hpp"
#include "hls/time_scaler.hpp"
#include "hls/word_check.hpp"
#include "ref/feed/stops/hold_bounds.hpp"
#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/bench/bench_format.hpp"
#include "tb/support/bench/motion_ports.hpp"
#include "tb/support/segments/mixed_segments.hpp"
#include "tb/support/segments/random_pieces.hpp"
#include "tb/support/segments/random_stops.hpp"

namespace curvecore::tb {
using namespace sysc;
constexpr int64_t kAcceleration = int64_t{1} << 25;
constexpr int64_t kSlope = 40 * kAcceleration;
const uint32_t kStopTicks = ref::stop_ticks(kAcceleration, 40);
constexpr int kMaxStepExponent = 9;  // short steps: many segments in a short program

class MotionInterpolator : public testing::Test, protected BenchFormat {
  protected:
    explicit MotionInterpolator(std::shared_ptr<const ref::CurveTable> table = {})
        : BenchFormat(std::move(table)) {
        dut_->hold_acceleration_i = kAcceleration;
        dut_->hold_slope_i = kSlope;
        dut_->stop_ticks_i = kStopTicks;
        make_for(0x5a3c);
        dut_.reset();
    }

    /// Sets the digest of the core and of each stream's next program.
    void make_for(uint16_t digest) {
        dut_->digest_i = digest;
        piece_check_ = hls::WordCheck(digest);
        segment_check_ = hls::WordCheck(digest);
    }

    /// Adds a program after those before it: `pieces` and random segments of the same length.
    void program(const std::vector<hls::ProfileWords>& pieces) {
        int64_t length = 0;
        for (const hls::ProfileWords& piece : pieces) length += piece.ds;
        if (core_.splines != 0) {
            MixedSegments shapes(core_, random_(), kMaxStepExponent);
            const int64_t longest = int64_t{1} << (kMaxStepExponent + hls::kPathFrac);
            program(pieces, chain(shapes, length, longest));
        } else {
            LegalSegments shapes(core_, random_(), kMaxStepExponent);
            program(pieces, chain(shapes, length));
        }
    }

    void program(const std::vector<hls::ProfileWords>& pieces, std::vector<RunSegment> segments) {
        join(segments);
        set_ticks(pieces, segments);
        send(pieces, segments);
    }

    void send(const std::vector<hls::ProfileWords>& pieces,
              const std::vector<RunSegment>& segments) {
        for (const hls::ProfileWords& words : pieces) {
            pieces_.push_back(words);
            stops_.push_back(stop_before(stops_.size()));
            std::vector<uint64_t> bus = branches_.words(stops_.back());
            if (words.final) branches_ = {};
            bus.resize(bus.size() + hls::kProfileBusWords);
            hls::pack(words, piece_sequence_++, &bus[bus.size() - hls::kProfileBusWords]);
            piece_check_.seal(bus.data(), bus.size());
            profile_words_.insert(profile_words_.end(), bus.begin(), bus.end());
            length_ += words.ds;
        }
        for (const RunSegment& words : segments) {
            segments_.push_back(words);
            std::vector<uint64_t> bus = bus_words(words, segment_sequence_++);
            segment_check_.seal(bus.data(), bus.size());
            segment_words_.insert(segment_words_.end(), bus.begin(), bus.end());
        }
    }

    /// Makes each segment end where the next one starts, with auxiliary axes in another turn or
    /// not; an empty segment leads there from the program before.
    void join(std::vector<RunSegment>& segments) {
        if (!segments_.empty()) {
            RunSegment way = segments.front();
            way.length = 0;
            copy(segments_.back().end, way.start);
            segments.insert(segments.begin(), way);
        }
        for (std::size_t n = 1; n < segments.size(); ++n) {
            copy(segments[n].start, segments[n - 1].end);
            if (core_.aux_axes == 0 || go(90)) continue;
            segments[n].other_turn = true;
            for (int axis = 3; axis < core_.axes(); ++axis) segments[n - 1].end[axis] >>= 1;
        }
    }
    static void copy(const int64_t (&from)[kMostAxes], int64_t (&to)[kMostAxes]) {
        std::copy(std::begin(from), std::end(from), std::begin(to));
    }

    Stop stop_before(std::size_t piece) {
        if (piece < planned_stops_.size()) return planned_stops_[piece];
        return branch_percent_ > 0 && go(100 - branch_percent_) ? random_stops_.any(most_wait_)
                                                                : Stop();
    }

    /// Sets the ticks in which the pieces draw each segment: whole pieces only, so never too many.
    static void set_ticks(const std::vector<hls::ProfileWords>& pieces,
                          std::vector<RunSegment>& segments) {
        std::size_t piece = 0;
        int64_t begin = 0;  // path and ticks of the pieces before
        int64_t ticks = 0;
        int64_t path = 0;  // path of the segments so far
        int64_t drawn = 0;
        for (RunSegment& segment : segments) {
            path += segment.length;
            while (piece < pieces.size() && begin + pieces[piece].ds <= path) {
                begin += pieces[piece].ds;
                ticks += pieces[piece++].ticks;
            }
            segment.ticks = static_cast<uint32_t>(ticks - drawn);
            drawn = ticks;
        }
        segments.back().last = true;
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
        dut_->samples_per_tick_log2_i = static_cast<unsigned>(n);
        share_ = hls::SampleShare(n);
    }

    /// Advances by one clock. Valid words and requests stay until they are taken.
    void clock() {
        if (!dut_->segment_valid_i && !segment_words_.empty() && go(segment_stall_) && go(stall_)) {
            dut_->segment_data_i = segment_words_.front();
            dut_->segment_valid_i = 1;
        }
        if (!dut_->profile_valid_i && !profile_words_.empty() && go(profile_stall_)) {
            dut_->profile_data_i = profile_words_.front();
            dut_->profile_valid_i = 1;
        }
        if (requesting_ && go(stall_)) dut_->sample_request_valid_i = 1;
        dut_->sample_ready_i = taking_ && go(stall_) ? 1 : 0;
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
        if (request && rates_ == Rates::kOfKernel) {
            targets_.push_back(dut_->hold_i ? 0 : static_cast<int32_t>(dut_->override_i));
        }
    }

    void check_move() {
        const auto rate = static_cast<int32_t>(dut_->path_rate_o);
        if (share_.needs_tick()) {
            // The RTL chooses the tick in which a program begins; the rest follows.
            const bool waits = !dut_->path_active_o;
            const auto next_piece = [this](hls::ProfileWords& piece) {
                if (next_piece_ == pieces_.size()) return false;
                const Stop& stop = stops_[next_piece_];
                piece = pieces_[next_piece_++];
                if (stop.wait > 0) schedule_.load_wait(stop.wait);
                for (const hls::StopStep& step : stop.steps) schedule_.load_step(step);
                schedule_.begin_piece(!path_kernel_.active());
                return true;
            };
            if (rates_ == Rates::kOfKernel) follow_rate(rate);
            const bool moves = path_kernel_.active();
            share_.tick(path_kernel_.tick(rate, next_piece, waits));
            if (rates_ == Rates::kBounded) check_rate(rate, moves);
        }
        const int64_t ds = share_.sample();
        path_ += ds;
        ASSERT_EQ(static_cast<int64_t>(dut_->path_ds_o), ds) << "move " << moves_.size();
        ASSERT_EQ(static_cast<int64_t>(dut_->path_o), path_);
        moves_.push_back(ds);
    }

    /// Compares the rate of branches with the kernel's, while no stream starves.
    void follow_rate(int32_t rate) {
        ASSERT_FALSE(targets_.empty());
        const int32_t target = targets_.front();
        targets_.pop_front();
        const auto next_step = [this] {
            ++steps_;
            return schedule_.next_step();
        };
        ASSERT_EQ(rate, scaler_.tick(target, path_kernel_.idle(), schedule_.due(), next_step))
            << "move " << moves_.size();
        schedule_.count(scaler_.steady(), scaler_.passed());
        rate_ = rate;
    }

    /// Checks the bounds of first and second differences while a program is under way; the port has
    /// 16 of the 32 fraction bits.
    void check_rate(int32_t rate, bool moves) {
        if (!moves) rate_ = rate_before_ = rate;
        ASSERT_LE(std::abs(rate - rate_), (kSlope >> 16) + 1) << "move " << moves_.size();
        ASSERT_LE(std::abs(rate - 2 * rate_ + rate_before_), (kAcceleration >> 16) + 2)
            << "move " << moves_.size();
        rate_before_ = rate_;
        rate_ = rate;
    }

    void check_sample() {
        ASSERT_LT(samples_, static_cast<int64_t>(moves_.size())) << "a sample before its move";
        int64_t fine[kMostAxes];
        kernel_.sample(
            moves_[static_cast<std::size_t>(samples_)],
            [this] { return segments_.at(next_segment_++); }, fine);
        for (int axis = 0; axis < core_.axes(); ++axis) {
            ASSERT_EQ(dut_->sample_fine_o[axis], fine[axis])
                << "sample " << samples_ << " axis " << axis;
            ASSERT_EQ(dut_->sample_position_o[axis], hls::to_position(fine[axis], format_))
                << "sample " << samples_ << " axis " << axis;
        }
        ++samples_;
    }

    /// Fills the queues.
    void fill() { wait(6000); }

    /// Passes clocks, of a slower core more.
    void wait(int clocks) {
        for (int n = 0; n < clocks * pace_ && !HasFatalFailure(); ++n) clock();
    }

    /// Requests samples until the machine stands.
    void stand() {
        wait(3);  // standing is reported three clocks late
        for (int n = 0; n < 100000 * pace_ && !dut_->standing_o && !HasFatalFailure(); ++n) clock();
        EXPECT_TRUE(dut_->standing_o);
        EXPECT_TRUE(rate_ == 0 || !dut_->active_o);
    }

    /// Requests samples until the program is over; `each` runs before every clock.
    void run(const std::function<void()>& each = [] {}) {
        requesting_ = true;
        while (!HasFatalFailure() && (path_ < length_ || path_kernel_.active())) {
            each();
            clock();
            ASSERT_EQ(dut_->fault_o, 0);
        }
        if (HasFatalFailure()) return;
        requesting_ = false;
        const int rest = 20000 * pace_;
        for (int n = 0; n < rest && (samples_ < requested_ || n < 200 * pace_); ++n) clock();
        EXPECT_EQ(samples_, requested_);
        EXPECT_EQ(path_, length_);
        EXPECT_FALSE(dut_->active_o);
    }

    /// Resets the core, and forgets all programs.
    void start_afresh() {
        dut_->segment_valid_i = false;
        dut_->profile_valid_i = false;
        dut_->sample_request_valid_i = false;
        dut_->hold_i = false;
        dut_->kill_i = false;
        requesting_ = false;
        taking_ = true;
        dut_.reset(1);
        pieces_.clear();
        stops_.clear();
        branches_ = {};
        schedule_ = {};
        scaler_ = {kAcceleration, kSlope};
        targets_.clear();
        segments_.clear();
        profile_words_.clear();
        segment_words_.clear();
        next_piece_ = 0;
        next_segment_ = 0;
        piece_sequence_ = 0;
        segment_sequence_ = 0;
        make_for(static_cast<uint16_t>(dut_->digest_i + 0x2f31));
        length_ = 0;
        path_kernel_ = {};
        share_ = hls::SampleShare(0);
        kernel_ = RunTimeKernel(format_);
        rate_ = 0;
        path_ = 0;
        moves_.clear();
        requested_ = 0;
        samples_ = 0;
    }

    bool go(int stall_percent) { return static_cast<int>(random_() % 100) >= stall_percent; }

    /// Clocks in which the core does what the quickest do in one.
    const int pace_ = core_.build == Build::kEngine ? 100 : 1;
    MotionCore dut_;
    std::mt19937 random_{1};
    int stall_ = 0;  // percent of clocks, every handshake
    int segment_stall_ = 0;
    int profile_stall_ = 0;
    bool requesting_ = false;
    bool taking_ = true;

    /// Check of time's rates: without stop branches; with them, while no stream starves.
    enum class Rates { kBounded, kOfKernel, kAny } rates_ = Rates::kBounded;
    int branch_percent_ = 0;           // percentage of pieces that have a branch
    int most_wait_ = 300;              // greatest number of ticks from it to the next one
    std::vector<Stop> planned_stops_;  // stops of the first pieces
    std::vector<Stop> stops_;
    RandomStops random_stops_{random_};
    BranchWords branches_;
    hls::StopSchedule schedule_;
    hls::TimeScaler scaler_{kAcceleration, kSlope};
    std::deque<int32_t> targets_;
    int64_t steps_ = 0;

    std::vector<hls::ProfileWords> pieces_;
    std::vector<RunSegment> segments_;
    std::deque<uint64_t> profile_words_;
    std::deque<uint64_t> segment_words_;
    std::size_t next_piece_ = 0;
    std::size_t next_segment_ = 0;
    unsigned piece_sequence_ = 0;
    unsigned segment_sequence_ = 0;
    hls::WordCheck piece_check_;
    hls::WordCheck segment_check_;
    int64_t length_ = 0;

    hls::PathKernel path_kernel_;
    hls::SampleShare share_{0};
    RunTimeKernel kernel_{format_};
    int32_t rate_ = 0;
    int32_t rate_before_ = 0;
    int64_t path_ = 0;
    std::deque<int64_t> moves_;
    int64_t requested_ = 0;
    int64_t samples_ = 0;
};

}  // namespace curvecore::tb
