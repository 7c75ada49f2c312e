// SPDX-License-Identifier: Apache-2.0
// The Verilated motion_interpolator as a board: each turn of work is a clock.
#pragma once

#include <deque>

#include "sysc/board/staller.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "sysc/cores/rtl_setup.hpp"

namespace curvecore::sysc {

template <class Model, int Build, int Axes, int PositionBits, int GuardBits>
class RtlBoard : public Board {
    static constexpr bool kEngine = Build == 2;

  public:
    explicit RtlBoard(const RtlSetup& setup)
        : trace_clocks_(setup.trace_clocks),
          segments_(setup.stall_seed, 1),
          profile_(setup.stall_seed, 2),
          request_stall_(setup.stall_seed, 3),
          sample_stall_(setup.stall_seed, 4) {
        dut_.limit_cycles(~std::uint64_t(0));
        drive_idle();
        drive(setup.settings);
        if (!setup.waveform.empty()) dut_.trace_to(setup.waveform, setup.clock_hz);
        dut_.reset();
        dut_.tick();  // a reset lasts a clock longer: a queue that refuses a word now is not full
        first_clock_ = dut_.cycle();
    }

    std::size_t write(Stream stream, const std::uint64_t* words, std::size_t count) override {
        Inlet& inlet = stream == Stream::kSegments ? segments_ : profile_;
        if (inlet.waiting || count == 0) return 0;
        inlet.word = *words;
        inlet.waiting = true;
        return 1;
    }

    bool arrived(Stream stream) const override {
        const Inlet& inlet = stream == Stream::kSegments ? segments_ : profile_;
        return !inlet.waiting && inlet.entering == 0;
    }

    /// Clocks during which an entry counts a frame and takes no word, or the engine makes a sample.
    static constexpr int kCounts = kEngine ? 30'000 : 4;
    bool full(Stream stream) const override {
        return (stream == Stream::kSegments ? segments_ : profile_).refused > kCounts;
    }

    void request(std::uint64_t samples) override { requested_ += samples; }

    void work(std::vector<Sample>& samples) override {
        drive_clock();
        dut_.fall();
        observe(samples);
        dut_.rise();
        if (dut_.cycle() == trace_clocks_) dut_.stop_trace();
    }

    BoardStatus status() const override {
        return {dut_.cycle() - first_clock_, dut_->underrun_o != 0, dut_->fault_o,
                dut_->empty_segments_o, 0};
    }

  private:
    static constexpr int kFineBits = PositionBits + GuardBits;

    /// A word on its way into a queue; once valid it stays valid until it is taken.
    struct Inlet {
        Inlet(std::optional<std::uint64_t> seed, std::uint64_t stream) : stall(seed, stream) {}

        Staller stall;
        std::uint64_t word = 0;
        bool waiting = false;
        bool valid = false;
        int entering = 0;  // words on their way into an engine's queue
        int refused = 0;   // number of clocks, up to the last one, in which the word was refused

        void offer() { valid = valid || (waiting && stall.go()); }
        /// Takes the core's answer; `leaves`: a word went from the engine's entry into its queue.
        void answer(bool ready, bool leaves) {
            const bool refuses = kEngine ? entering > 0 && !leaves : valid && !ready;
            refused = refuses ? refused + 1 : 0;
            if (kEngine && leaves) --entering;
            if (!valid || !ready) return;
            valid = false;
            waiting = false;
            if (kEngine) ++entering;
        }
    };

    struct Move {
        std::int64_t ds;
        std::int32_t rate;
    };

    // The model's ports are named from here to take_sample(), and in status().

    void drive_idle() {
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        dut_->sample_request_valid_i = 0;
        dut_->sample_ready_i = 0;
        dut_->hold_i = 0;
        dut_->kill_i = 0;
    }

    void drive(const BoardSettings& settings) {
        dut_->override_i = to_port(settings.override_word, 17);
        dut_->samples_per_tick_log2_i = to_port(settings.samples_per_tick_log2, 4);
        dut_->hold_acceleration_i = settings.hold_acceleration;
        dut_->hold_slope_i = settings.hold_slope;
        dut_->digest_i = settings.digest;
        dut_->stop_ticks_i = settings.stop_ticks;
    }

    void drive_clock() {
        segments_.offer();
        profile_.offer();
        // A valid request stays until it is taken.
        requesting_ = requesting_ || (requested_ > 0 && request_stall_.go());
        dut_->segment_data_i = segments_.word;
        dut_->segment_valid_i = segments_.valid;
        dut_->profile_data_i = profile_.word;
        dut_->profile_valid_i = profile_.valid;
        dut_->sample_request_valid_i = requesting_;
        dut_->sample_ready_i = sample_stall_.go();
    }

    void observe(std::vector<Sample>& samples) {
        segments_.answer(dut_->segment_ready_o, dut_->segment_leaves_o);
        profile_.answer(dut_->profile_ready_o, dut_->profile_leaves_o);
        if (requesting_ && dut_->sample_request_ready_o) {
            requesting_ = false;
            --requested_;
        }
        if (dut_->path_valid_o) {
            moves_.push_back({static_cast<std::int64_t>(dut_->path_ds_o),
                              static_cast<std::int32_t>(dut_->path_rate_o)});
        }
        if (dut_->sample_valid_o && dut_->sample_ready_i) take_sample(samples.emplace_back());
    }

    void take_sample(Sample& sample) {
        if (moves_.empty()) throw BoardError("the core gave a sample before its path_valid_o");
        sample.ds = moves_.front().ds;
        sample.rate = moves_.front().rate;
        sample.clock = dut_.cycle() - first_clock_;
        moves_.pop_front();
        for (int axis = 0; axis < Axes; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            sample.position[a] =
                signed_field(dut_->sample_position_o, axis * PositionBits, PositionBits);
            sample.fine[a] = signed_field(dut_->sample_fine_o, axis * kFineBits, kFineBits);
        }
    }

    ClockedDut<Model> dut_;
    std::uint64_t first_clock_ = 0;
    std::uint64_t trace_clocks_;
    Inlet segments_;
    Inlet profile_;
    Staller request_stall_;
    Staller sample_stall_;
    std::uint64_t requested_ = 0;
    bool requesting_ = false;
    std::deque<Move> moves_;
};

}  // namespace curvecore::sysc
