// SPDX-License-Identifier: Apache-2.0
// A host of motion_system: it knows the registers alone (hls/registers/registers.h). A drive at
// every axis' pins watches, on every clock. With FLAT_TWIN the flat file runs beside the sources.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "Vmotion_system.h"
#include "hls/registers/registers.h"
#include "sysc/board/feeder.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/job/job.hpp"
#include "sysc/words/bus_words.hpp"
#include "tb/support/pins/pulse_monitor.hpp"
#include "tb/support/pins/xy2_receiver.hpp"
#ifdef FLAT_TWIN
#include "tb/support/bench/flat_twin.hpp"
#endif

namespace curvecore::tb {

constexpr int kSystemAxes = 3;
constexpr int64_t kStepsPerMm = 400;
constexpr int64_t kSystemPeriod = int64_t{1} << CFG_PeriodLog2;
/// Clocks of 0.1 ms: of what takes the machine's time, whatever a sample period is.
constexpr int64_t kTenth = CFG_ClockHertz / 10'000;
constexpr int kFineBits = 42;
constexpr hls::PulseTimes kDrive{2, 2, 4, 4};
constexpr uint32_t kEveryAxis = (1U << kSystemAxes) - 1;
constexpr uint32_t kEnable = CURVECORE_CONTROL_ENABLE_MASK;
constexpr uint32_t kHold = CURVECORE_CONTROL_HOLD_MASK;
constexpr uint32_t kFlush = CURVECORE_CONTROL_FLUSH_MASK;
constexpr uint32_t kFaults = CURVECORE_FAULTS;
constexpr uint32_t kMotionFaults = CURVECORE_STATE_MOTION_MASK;

/// A plan for the board under test, and its words.
struct Part {
    /// @param change modifies the options, for another board or host
    Part(
        const std::string& file, ref::Holds holds,
        const std::function<void(sysc::Options&)>& change = [](sysc::Options&) {}) {
        sysc::Options options;
        options.holds = holds;
        options.file = std::string(DATA_DIR) + "/" + file;
        options.core.build = static_cast<sysc::Build>(CFG_Build);
        options.core.splines = 1;
        options.core.mode = 1;
        options.splines_set = true;
        options.clock_hz = CFG_ClockHertz;
        options.sample_period_s = static_cast<double>(kSystemPeriod) / options.clock_hz;
        change(options);
        job = sysc::plan_job(options);
        settings = sysc::board_settings(job);
        sysc::SegmentWriter writer(job.options.core, job.digest());
        for (std::size_t n = 0; n < job.plan.segments.size(); ++n) {
            add(segments, writer.write(job.plan.segments[n]));
        }
        for (std::size_t n = 0; n < job.plan.pieces.size(); ++n) {
            const auto [words, count] = job.plan.words_of(n);
            add(pieces, {words, words + count});
        }
    }
    /// Scale in 2^-16 steps for 2^42 units of 2^-10 nm.
    int64_t scale() const {
        return std::llround(static_cast<double>(kStepsPerMm) * job.options.unit_mm *
                            std::exp2(kFineBits + 16 - 10));
    }
    int64_t end(int axis) const {
        return std::llround(job.plan.moves.back().end[axis] * kStepsPerMm);
    }

    sysc::Job job;
    sysc::BoardSettings settings;
    std::vector<uint64_t> segments;
    std::vector<uint64_t> pieces;

  private:
    static void add(std::vector<uint64_t>& all, const std::vector<uint64_t>& words) {
        all.insert(all.end(), words.begin(), words.end());
    }
};

class RegisterHost {
  public:
    RegisterHost() {
        dut_.limit_cycles(UINT64_MAX);
        dut_->valid_i = 0;
        dut_->estop_i = 0;
        dut_->limit_i = 0;
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        dut_->probe_i = 0;
        dut_->home_i = 0;
        dut_->encoder_a_i = 0;
        dut_->encoder_b_i = 0;
        for (int a = 0; a < kSystemAxes; ++a) drives_.emplace_back(kDrive);
        dut_.reset();
    }

    void clock() {
        if (before_clock_) before_clock_();
        dut_.tick();
        ++clock_;
#ifdef FLAT_TWIN
        twin_.follow(*dut_, clock_);
#endif
        for (int a = 0; a < kSystemAxes; ++a) {
            drives_[a].watch(clock_, dut_->step_o >> a & 1, dut_->direction_o >> a & 1);
        }
        const auto frame =
            scan_head_.look(dut_->galvo_clock_o, dut_->galvo_sync_o, dut_->galvo_data_o, clock_);
        if (frame) galvo_frame_ = frame->words;
        if (each_clock) each_clock();
    }
    void clocks(int64_t n) {
        while (n-- > 0) clock();
    }
    void samples(int64_t n) { clocks(n * kSystemPeriod); }
    void tenths(int64_t n) { clocks(n * kTenth); }

    /// Writes a register. Returns false if the request was an error.
    bool write(uint32_t address, uint32_t data) { return ask(true, address, data); }
    uint32_t read(uint32_t address) {
        EXPECT_TRUE(ask(false, address, 0)) << "reading " << address;
        return dut_->data_o;
    }
    bool push(uint32_t low_address, uint64_t word) {
        return write(low_address, static_cast<uint32_t>(word)) &&
               write(low_address + 4, static_cast<uint32_t>(word >> 32));
    }
    uint32_t state() { return read(CURVECORE_STATE); }
    /// Feeds the watchdog by a write without other effect: reads do not feed it.
    void live() { EXPECT_TRUE(write(CURVECORE_SEQUENCE, 1)); }
    bool is(uint32_t mask) { return (state() & mask) != 0; }

    /// Writes the settings that are constant while a part is drawn; turns the machine on,
    /// referenced.
    void prepare(const Part& part, uint32_t control = kEnable) {
        for (int a = 0; a < kSystemAxes; ++a) {
            const uint32_t axis = static_cast<uint32_t>(a) * CURVECORE_AXIS_STRIDE;
            EXPECT_TRUE(write(CURVECORE_AXIS_SCALE_LO + axis, static_cast<uint32_t>(part.scale())));
            EXPECT_TRUE(
                write(CURVECORE_AXIS_SCALE_HI + axis, static_cast<uint32_t>(part.scale() >> 32)));
        }
        write(CURVECORE_PULSE, pair(kDrive.steplen, kDrive.stepspace));
        write(CURVECORE_DIRECTION, pair(kDrive.dirsetup, kDrive.dirhold));
        write(CURVECORE_OVERRIDE, static_cast<uint32_t>(part.settings.override_word));
        write(CURVECORE_TIMING, static_cast<uint32_t>(part.settings.samples_per_tick_log2));
        write(CURVECORE_HOLD_ACCELERATION, part.settings.hold_acceleration);
        write(CURVECORE_HOLD_SLOPE, static_cast<uint32_t>(part.settings.hold_slope));
        write(CURVECORE_STOP_TICKS, part.settings.stop_ticks);
        write(CURVECORE_DIGEST, part.settings.host_digest);
        EXPECT_TRUE(write(CURVECORE_REFERENCE, kEveryAxis));
        EXPECT_TRUE(write(CURVECORE_CONTROL, control));
    }

    /// Number of words of a part that are sent.
    struct Sent {
        std::size_t segments = 0;
        std::size_t pieces = 0;
        bool all(const Part& part) const {
            return segments == part.segments.size() && pieces == part.pieces.size();
        }
    };
    /// Writes the words for which ROOM has space; `between` is called before each.
    void feed(const Part& part, Sent& sent, const std::function<void()>& between) {
        const uint32_t room = read(CURVECORE_ROOM);
        feed(CURVECORE_SEGMENT_LO, part.segments, sent.segments, room & 0xffff, between);
        feed(CURVECORE_PROFILE_LO, part.pieces, sent.pieces, room >> 16, between);
        live();
        clocks(200);
        EXPECT_EQ(state() & kMotionFaults, 0U);
    }
    /// Writes words until the program has been under way for so many tenths of a millisecond, or
    /// the machine is off.
    void draw_for(int64_t tenths, const Part& part, Sent& sent) {
        int64_t begun = -1;
        while (is(CURVECORE_STATE_ENABLED_MASK) && !testing::Test::HasFailure() &&
               (begun < 0 || now() < begun + tenths * kTenth)) {
            feed(part, sent, [] {});
            if (begun < 0 && is(CURVECORE_STATE_ACTIVE_MASK)) begun = now();
        }
    }
    /// Writes all words, until the machine stands at the end.
    void draw(
        const Part& part, const std::function<void()>& between = [] {}) {
        Sent sent;
        draw_rest(part, sent, between);
    }
    /// Writes the remaining words.
    void draw_rest(const Part& part, Sent& sent, const std::function<void()>& between) {
        while (!sent.all(part) && !testing::Test::HasFailure()) feed(part, sent, between);
        finish(part);
    }
    /// Writes all words by the streams, with pauses, until the machine stands at the end.
    void stream(const Part& part, std::mt19937& random) {
        Sent sent;
        before_clock_ = [&] {
            offer(part.segments, sent.segments, random() % 4 == 0, dut_->segment_valid_i,
                  dut_->segment_data_i);
            offer(part.pieces, sent.pieces, random() % 4 == 0, dut_->profile_valid_i,
                  dut_->profile_data_i);
            dut_.settle();
            sent.segments += dut_->segment_valid_i && dut_->segment_ready_o;
            sent.pieces += dut_->profile_valid_i && dut_->profile_ready_o;
        };
        while (!sent.all(part) && !testing::Test::HasFailure()) {
            clocks(1000);
            EXPECT_EQ(state() & kMotionFaults, 0U);
        }
        before_clock_ = nullptr;
        dut_->segment_valid_i = 0;
        dut_->profile_valid_i = 0;
        finish(part);
    }
    /// Runs until the part's path is drawn since `from`, and its last sample is out.
    void finish(const Part& part, uint64_t from = 0) {
        while (path() != from + part.job.plan.path_length() && !testing::Test::HasFailure()) {
            samples(1);
            live();
            EXPECT_EQ(state() & kMotionFaults, 0U);
        }
        samples(CFG_SamplesAhead + 4);
    }
    uint64_t path() {
        const uint64_t low = read(CURVECORE_PATH_LO);
        return uint64_t{read(CURVECORE_PATH_HI)} << 32 | low;
    }

    const PulseMonitor& drive(int axis) const { return drives_[axis]; }
    /// Returns the last frame of an axis to a scan head.
    uint32_t galvo_frame(int axis) const { return galvo_frame_[axis]; }
    int64_t now() const { return clock_; }
    Vmotion_system* operator->() { return dut_.operator->(); }

    std::function<void()> each_clock;  // called after each

  private:
    static uint32_t pair(int low, int high) { return static_cast<uint32_t>(low | high << 16); }

    /// Drives the next word from the time when it is due until it is taken.
    template <class Valid, class Data>
    static void offer(const std::vector<uint64_t>& words, std::size_t next, bool due, Valid& valid,
                      Data& data) {
        const bool more = next < words.size();
        const bool waits = more && valid && data == words[next];
        valid = waits || (more && due);
        if (valid) data = words[next];
    }

    bool ask(bool write, uint32_t address, uint32_t data) {
        dut_->valid_i = 1;
        dut_->write_i = write;
        dut_->word_i = address / 4;
        dut_->data_i = data;
        int waited = 0;
        do {
            clock();
            ++waited;
        } while (!dut_->done_o && waited < 1000);
        constexpr int kMost = CFG_Build == 2 ? 6 : 2;  // clocks: rtl/bus/register_file.sv
        EXPECT_LE(waited, first_ ? kMost + 128 : kMost) << "address " << address;
        first_ = false;
        const bool good = !dut_->error_o;
        clock();
        dut_->valid_i = 0;
        return good;
    }

    void feed(uint32_t address, const std::vector<uint64_t>& words, std::size_t& next,
              uint32_t room, const std::function<void()>& between) {
        for (; room > 0 && next < words.size() && !testing::Test::HasFailure(); --room) {
            between();
            ASSERT_TRUE(push(address, words[next])) << "word " << next << " at " << address;
            ++next;
        }
    }

    sysc::ClockedDut<Vmotion_system> dut_;
#ifdef FLAT_TWIN
    FlatTwin twin_;
#endif
    std::vector<PulseMonitor> drives_;
    Xy2Receiver scan_head_;
    std::array<uint32_t, 3> galvo_frame_{};
    std::function<void()> before_clock_;
    int64_t clock_ = 0;
    bool first_ = true;
};

}  // namespace curvecore::tb
