// SPDX-License-Identifier: Apache-2.0
// A pipeline from an HLS compiler against the native kernel: random calls with random gaps, every
// word of every result. It knows no kernel: a Call has
//
//     void draw(Random&)               another call, and `expected`, the kernel's words
//     void drive(Vhls&) const          its inputs, to the ports
//     std::vector<int64_t> expected    the words of out_o, lowest first, each of `bits`
//     static constexpr int bits
//     static constexpr int rtl_clocks  clocks of the RTL for a call
#pragma once

#include <verilated.h>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <vector>

#include "Vhls.h"
#include "hls/clocks.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/segments/plain_segments.hpp"

namespace curvecore::tb {

/// Timing of the RTL of the same kernel and configuration.
constexpr hls::TimedCore rtl_core() {
    hls::TimedCore core{ref::Build::kParallel, CFG_Order, CFG_CoefBits, CFG_AuxAxes, CFG_Mode == 0};
    core.anchor = CFG_Anchor != 0;
    return core;
}

template <class Call>
class PipelineBench {
  public:
    /// Runs the comparison. Returns the exit status: 0, or 1 if a word differs.
    int run(int64_t samples) {
        reset();
        int64_t sent = 0;
        while (compared_ < samples) {
            call_.draw(random_);  // inputs during a gap must not count
            call_.drive(dut_);
            dut_.valid_i = sent < samples && random_.uniform(0, 1) < 0.9;
            if (dut_.valid_i) {
                due_.push_back({cycle_, call_.expected});
                ++sent;
            }
            tick();
            if (dut_.valid_o) compare();
            if (cycle_ > 2 * samples + 1000) {
                std::fprintf(stderr, "%lld samples never came\n",
                             static_cast<long long>(samples - compared_));
                return 1;
            }
        }
        std::printf(
            "{\"samples\": %lld, \"words\": %lld, \"differ\": %lld, \"latency\": %lld,"
            " \"rtl_clocks\": %d}\n",
            static_cast<long long>(compared_), static_cast<long long>(words_),
            static_cast<long long>(differ_), static_cast<long long>(latency_), Call::rtl_clocks);
        return differ_ == 0 ? 0 : 1;
    }

  private:
    struct Due {
        int64_t cycle;
        std::vector<int64_t> words;
    };

    void reset() {
        dut_.valid_i = 0;
        dut_.rst_ni = 0;
        for (int n = 0; n < 300; ++n) tick();
        dut_.rst_ni = 1;
    }

    void tick() {
        dut_.clk_i = 0;
        dut_.eval();
        dut_.clk_i = 1;
        dut_.eval();
        ++cycle_;
    }

    void compare() {
        if (due_.empty()) {
            ++differ_;
            return;
        }
        const Due due = due_.front();
        due_.pop_front();
        if (latency_ < 0) latency_ = cycle_ - due.cycle;
        bool equal = latency_ == cycle_ - due.cycle;
        for (size_t n = 0; n < due.words.size(); ++n) {
            const auto low = static_cast<int>(n) * Call::bits;
            const int64_t word = sysc::signed_field(dut_.out_o, low, Call::bits);
            if (word == due.words[n]) continue;
            equal = false;
            if (differ_ < 5) {
                std::fprintf(stderr, "sample %lld: word %zu is %lld, the kernel's %lld\n",
                             static_cast<long long>(compared_), n, static_cast<long long>(word),
                             static_cast<long long>(due.words[n]));
            }
        }
        differ_ += equal ? 0 : 1;
        words_ += static_cast<int64_t>(due.words.size());
        ++compared_;
    }

    Vhls dut_;
    Random random_;
    Call call_;
    std::deque<Due> due_;
    int64_t cycle_ = 0;
    int64_t compared_ = 0;
    int64_t words_ = 0;
    int64_t differ_ = 0;
    int64_t latency_ = -1;
};

/// Runs as BENCH SAMPLES.
template <class Call>
int bench_main(int argc, char** argv) {
    const int64_t samples = argc == 2 ? std::atoll(argv[1]) : 0;
    if (samples < 1) {
        std::fprintf(stderr, "usage: %s SAMPLES\n", argv[0]);
        return 2;
    }
    return std::make_unique<PipelineBench<Call>>()->run(samples);
}

}  // namespace curvecore::tb
