// SPDX-License-Identifier: Apache-2.0
// The Verilated motion_interpolator, fed with a plan's words and asked for samples as fast as it
// takes requests.
#pragma once

#include <chrono>
#include <deque>
#include <stdexcept>
#include <vector>

#include "tb/program/channel.hpp"
#include "tb/program/checker.hpp"
#include "tb/program/rtl_run.hpp"
#include "tb/program/staller.hpp"
#include "tb/support/clocked_dut.hpp"
#include "tb/support/port_word.hpp"

namespace curvecore::tb {

template <class C, class Model>
class RtlBench {
  public:
    using Batch = std::vector<RtlSample<C>>;
    static constexpr std::size_t kBatch = 4096;

    RtlBench(const RtlRun& setup, const std::vector<hls::SegmentWords<C>>& segments)
        : setup_(setup),
          plan_(setup.job.plan),
          segments_(segments),
          reserve_(2 * stop_ticks(plan_) + 64),
          segment_stall_(setup.job.options.stall_seed, 1),
          profile_stall_(setup.job.options.stall_seed, 2),
          request_stall_(setup.job.options.stall_seed, 3),
          sample_stall_(setup.job.options.stall_seed, 4) {
        dut_.limit_cycles(~std::uint64_t(0));
        configure();
        if (!setup.waveform.empty()) dut_.trace_to(setup.waveform);
        dut_.reset();
    }

    /// Runs to the last sample, or until the other end of the channel closes it.
    RtlResult run(Channel<Batch>& channel) {
        const auto begin = std::chrono::steady_clock::now();
        const std::uint64_t first = dut_.cycle();
        batch_.reserve(kBatch);
        bool open = true;
        while (received_ < setup_.samples && open) {
            clock();
            if (batch_.size() == kBatch) open = hand_over(channel);
            if (dut_.cycle() == setup_.job.options.trace_clocks) dut_.stop_trace();
        }
        if (open) hand_over(channel);
        RtlResult result;
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        result.seconds = time.count();
        result.clocks = dut_.cycle() - first;
        result.underrun = dut_->underrun_o != 0;
        result.empty_segments = dut_->empty_segments_o;
        return result;
    }

  private:
    static constexpr std::uint64_t kPatience = 1'000'000;  // clocks without a sample

    void configure() {
        const Options& options = setup_.job.options;
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        dut_->sample_request_valid_i = 0;
        dut_->sample_ready_i = 0;
        dut_->hold_i = 0;
        dut_->kill_i = 0;
        dut_->override_i = to_port(options.override_word(), 17);
        dut_->samples_per_tick_log2_i = to_port(options.samples_per_tick_log2(), 4);
        dut_->hold_acceleration_i = plan_.hold_acceleration;
        dut_->hold_slope_i =
            std::uint64_t(plan_.hold_acceleration) * std::uint64_t(plan_.hold_slope_steps);
        dut_->stop_ticks_i = to_port(stop_ticks(plan_), 32);
    }

    void clock() {
        drive_words();
        // A valid request stays until it is taken.
        requesting_ = requesting_ || (may_request() && request_stall_.go());
        dut_->sample_request_valid_i = requesting_;
        dut_->sample_ready_i = sample_stall_.go();
        dut_.fall();
        observe();
        dut_.rise();
    }

    void drive_words() {
        if (!segment_offered_ && next_segment_ < segments_.size() && segment_stall_.go()) {
            if (segment_word_ == 0) hls::pack<C>(segments_[next_segment_], segment_words_);
            dut_->segment_data_i = segment_words_[segment_word_];
            segment_offered_ = true;
        }
        dut_->segment_valid_i = segment_offered_;
        if (!profile_offered_ && next_piece_ < plan_.pieces.size() && profile_stall_.go()) {
            if (profile_word_ == 0) {
                hls::pack(hls::to_words(plan_.pieces[next_piece_]), profile_words_);
            }
            dut_->profile_data_i = profile_words_[profile_word_];
            profile_offered_ = true;
        }
        dut_->profile_valid_i = profile_offered_;
    }

    /// A host keeps the profile queue filled; so a request waits while the queue could run low.
    bool may_request() const {
        return requested_ < setup_.samples &&
               (next_piece_ == plan_.pieces.size() || profile_full_ ||
                queued_ticks_ - static_cast<std::int64_t>(
                                    requested_ >> setup_.job.options.samples_per_tick_log2()) >
                    reserve_);
    }

    void observe() {
        if (segment_offered_ && dut_->segment_ready_o) {
            segment_offered_ = false;
            if (++segment_word_ == hls::segment_bus_words<C>()) {
                segment_word_ = 0;
                ++next_segment_;
            }
        }
        profile_full_ = profile_offered_ && !dut_->profile_ready_o;
        if (profile_offered_ && dut_->profile_ready_o) {
            profile_offered_ = false;
            if (++profile_word_ == hls::kProfileBusWords) {
                profile_word_ = 0;
                queued_ticks_ += plan_.pieces[next_piece_++].ticks;
            }
        }
        if (requesting_ && dut_->sample_request_ready_o) {
            requesting_ = false;
            ++requested_;
        }
        if (dut_->path_valid_o) {
            moves_.push_back({static_cast<std::int64_t>(dut_->path_ds_o),
                              static_cast<std::int32_t>(dut_->path_rate_o)});
        }
        if (dut_->sample_valid_o && dut_->sample_ready_i) {
            take_sample();
        } else if (++waited_ > kPatience) {
            throw std::runtime_error("the core gave no sample for a million clocks");
        }
    }

    void take_sample() {
        if (moves_.empty()) throw std::runtime_error("the core gave a sample before its move");
        RtlSample<C>& sample = batch_.emplace_back();
        sample.ds = moves_.front().ds;
        sample.rate = moves_.front().rate;
        moves_.pop_front();
        for (int axis = 0; axis < C::kAxes; ++axis) {
            sample.position[axis] =
                signed_field(dut_->sample_position_o, axis * C::kPositionBits, C::kPositionBits);
            sample.fine[axis] =
                signed_field(dut_->sample_fine_o, axis * C::kFineBits, C::kFineBits);
        }
        ++received_;
        waited_ = 0;
    }

    bool hand_over(Channel<Batch>& channel) {
        const bool open = channel.push(std::move(batch_));
        batch_ = Batch();
        batch_.reserve(kBatch);
        setup_.progress(received_);
        return open;
    }

    struct Move {
        std::int64_t ds;
        std::int32_t rate;
    };

    const RtlRun& setup_;
    const ref::Plan& plan_;
    const std::vector<hls::SegmentWords<C>>& segments_;
    ClockedDut<Model> dut_;
    std::int64_t reserve_;  // ticks that stay queued, as long as there are pieces
    Staller segment_stall_;
    Staller profile_stall_;
    Staller request_stall_;
    Staller sample_stall_;

    std::uint64_t segment_words_[hls::segment_bus_words<C>()] = {};
    std::uint64_t profile_words_[hls::kProfileBusWords] = {};
    std::size_t next_segment_ = 0;
    std::size_t next_piece_ = 0;
    int segment_word_ = 0;
    int profile_word_ = 0;
    bool segment_offered_ = false;
    bool profile_offered_ = false;
    bool profile_full_ = false;
    bool requesting_ = false;
    std::int64_t queued_ticks_ = 0;
    std::uint64_t requested_ = 0;
    std::uint64_t received_ = 0;
    std::uint64_t waited_ = 0;
    std::deque<Move> moves_;
    Batch batch_;
};

}  // namespace curvecore::tb
