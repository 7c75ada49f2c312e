// SPDX-License-Identifier: Apache-2.0
// The engine's whole motion on the twin, at a board that takes a sample each period: the ports of
// rtl/engine/engine_motion.sv with the requests of rtl/motion_system.sv.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "hls/clocks.hpp"
#include "hls/engine.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "sysc/core/core_clocks.hpp"
#include "tb/model/engine/entry_comparison.hpp"

namespace curvecore::tb {

/// Settings of the motion, and what asks for a rate.
struct MotionInputs {
    std::int64_t samples_per_tick_log2 = 0;
    std::int64_t hold_acceleration = 1 << 28;
    std::int64_t hold_slope = 1 << 30;
    std::int64_t stop_ticks = 30;
    std::int64_t override_rate = 65536;
    bool hold = false;
};

/// Returns a program of a store that is no power of two, with instructions behind it that it never
/// comes to.
inline std::vector<std::uint32_t> filled(std::vector<std::uint32_t> program) {
    std::size_t size = 1;
    while (size < program.size()) size *= 2;
    program.resize(size);
    return program;
}

class TimedMotion {
  public:
    static constexpr std::uint16_t kDigest = 0x5a17;

    TimedMotion(const sysc::CoreParameters& core, const assembler::Assembly& program, int period)
        : period_(static_cast<std::uint64_t>(period)),
          ahead_(1 + hls::samples_ahead(sysc::timed_core(core))),
          streams_(ports_, kDigest),
          engine_(filled(program.program()), program.memory()) {
        ports_.memory.resize(std::size_t{1} << 15);
        board_.motion = this;
    }
    TimedMotion(const TimedMotion&) = delete;

    /// Words that the host offers: as many of them wait as there are.
    std::deque<std::uint64_t>& offered(Stream stream) { return offered_[stream]; }
    MotionInputs& inputs() { return inputs_; }

    /// Works for a sample's period. Samples are taken once as many are there as are asked for.
    void work() {
        const std::uint64_t until = next_take_ + period_;
        while (engine_.clock() < until) engine_.step(board_);
    }

    std::int64_t samples() const { return taken_; }
    /// Samples that were not there when they were due.
    std::int64_t late() const { return late_; }
    bool active() const { return active_; }
    /// Faults as in rtl/motion_interpolator.sv, and 256: it stopped for want of words.
    unsigned reported() const { return streams_.reported; }

  private:
    struct Board : engine::QuietBoard {
        TimedMotion* motion = nullptr;
        bool condition(int code, std::uint64_t clock) const {
            return motion->condition(code, clock);
        }
        std::int16_t in(int port, int limb, std::uint64_t) const { return motion->in(port, limb); }
        void out(int port, int limb, std::int16_t value, std::uint64_t clock) const {
            motion->out(port, limb, value, clock);
        }
    };

    /// Takes the samples that are due until a clock.
    void take_until(std::uint64_t clock) {
        if (!takes_ && made_ == ahead_) {
            takes_ = true;
            next_take_ = clock;
        }
        if (!takes_) next_take_ = clock;
        for (; takes_ && next_take_ <= clock; next_take_ += period_) {
            if (made_ > taken_) {
                ++taken_;
            } else {
                ++late_;
            }
        }
    }

    bool condition(int code, std::uint64_t clock) {
        constexpr int kRequest = 3;
        constexpr int kKilled = 7;
        constexpr int kHeld = 8;
        take_until(clock);
        if (code == kRequest) return begun_ < taken_ + ahead_;
        if (code == kRequest + 1 || code == kRequest + 2) {
            return !offered_[static_cast<std::size_t>(code - kRequest - 1)].empty();
        }
        if (code == kKilled) return false;
        return code == kHeld ? held_ : ports_.condition(code);
    }

    std::int16_t in(int port, int limb) {
        const std::int64_t setting = port == 9    ? override_rate_
                                     : port == 11 ? inputs_.samples_per_tick_log2
                                     : port == 12 ? inputs_.hold_acceleration
                                     : port == 13 ? inputs_.hold_slope
                                     : port == 14 ? inputs_.stop_ticks
                                                  : 0;
        if (port >= 8 && port <= 14) {
            return static_cast<std::int16_t>(setting >> (engine::kLimbBits * limb) & 0x7fff);
        }
        return ports_.in(port, limb);
    }

    void out(int port, int limb, std::int16_t value, std::uint64_t clock) {
        constexpr int kTake = 5;
        constexpr int kSelect = 7;
        constexpr int kTakeRequest = 8;
        constexpr int kActive = 13;
        constexpr int kWhole = 25;
        take_until(clock);
        ports_.out(port, limb, value);
        if (port == kSelect) selected_ = static_cast<std::size_t>(value & 1);
        if (port == kTake) offered_[selected_].pop_front();
        if (port == kTake || port == kSelect) show_words();
        if (port == kTakeRequest) {
            ++begun_;
            held_ = inputs_.hold;
            override_rate_ = inputs_.override_rate;
        }
        if (port == kActive) active_ = value != 0;
        if (port == kWhole) ++made_;
    }

    void show_words() {
        for (const Stream stream : {kSegments, kPieces}) {
            streams_.words[stream] = offered_[stream].empty() ? 0 : offered_[stream].front();
        }
    }

    std::uint64_t period_;
    std::int64_t ahead_;  // samples that are asked for and not taken
    MicrocodePorts ports_;
    StreamPorts streams_;
    engine::Engine engine_;
    Board board_;
    std::deque<std::uint64_t> offered_[2];
    MotionInputs inputs_;
    std::size_t selected_ = 0;
    bool held_ = false;  // as of the request taken
    std::int64_t override_rate_ = 0;
    bool active_ = false;
    bool takes_ = false;
    std::uint64_t next_take_ = 0;
    std::int64_t begun_ = 0;
    std::int64_t made_ = 0;
    std::int64_t taken_ = 0;
    std::int64_t late_ = 0;
};

}  // namespace curvecore::tb
