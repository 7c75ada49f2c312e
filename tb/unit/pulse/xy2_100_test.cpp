// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/xy2_100.sv as a scan head reads it: a receiver that samples the pins alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "Vxy2_100.h"
#include "hls/xy2_frame.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/pins/xy2_receiver.hpp"

namespace curvecore::tb {
namespace {

constexpr int64_t kPeriod = int64_t{1} << CFG_PeriodLog2;

class Xy2 : public testing::Test {
  protected:
    Xy2() {
        dut_->tick_i = 0;
        dut_->sample_taken_i = 0;
        dut_.reset();
        period({}, false);  // bits before the first tick belong to no frame
        frames_.clear();
        receiver_ = {};
    }

    /// Ticks after the samples, if there are any; frames come a clock later than their periods.
    void period(const std::vector<int64_t>& samples, bool checked = true) {
        const auto taken = static_cast<int64_t>(random_() % (kPeriod - 1));
        for (int64_t n = 0; n < kPeriod; ++n) {
            dut_->sample_taken_i = !samples.empty() && n == taken ? 1 : 0;
            for (int a = 0; a < CFG_Axes; ++a) {
                const int64_t other = static_cast<int64_t>(random_());
                sysc::set_field(dut_->sample_i, a * CFG_FineBits, CFG_FineBits,
                                dut_->sample_taken_i ? samples[a] : other);
            }
            dut_->tick_i = n == kPeriod - 1 ? 1 : 0;
            dut_.tick();
            if (!checked) continue;
            const auto frame = receiver_.look(dut_->clock_o, dut_->sync_o, dut_->data_o, ++now_);
            if (frame) frames_.push_back(*frame);
        }
    }

    std::vector<int64_t> any_samples() {
        std::vector<int64_t> samples;
        for (int a = 0; a < CFG_Axes; ++a) {
            // Values over all of the field, its ends, and the halves between two of its words.
            const int64_t field = static_cast<int64_t>(random_()) >> (64 - CFG_FineBits);
            const int64_t most = (int64_t{1} << (CFG_FineBits - 1)) - 1;
            const int64_t half = int64_t{1} << (CFG_FineBits - 17);
            const int64_t edge =
                (field | (2 * half - 1)) - half + static_cast<int64_t>(random_() % 2);
            const int64_t choices[] = {field, most, -most - 1, edge, 0};
            samples.push_back(choices[random_() % 5]);
        }
        return samples;
    }

    std::mt19937_64 random_{1};
    sysc::ClockedDut<Vxy2_100> dut_;
    Xy2Receiver receiver_;
    int64_t now_ = 0;
    std::vector<Xy2Receiver::Frame> frames_;
};

TEST_F(Xy2, EachPeriodHasTheFrameOfItsSample) {
    period({});
    std::vector<std::vector<int64_t>> samples;
    for (int n = 0; n < 300; ++n) {
        samples.push_back(any_samples());
        period(samples.back());
    }
    period({});
    frames_.erase(frames_.begin(), frames_.begin() + 2);
    ASSERT_GE(frames_.size(), samples.size() - 1);
    for (std::size_t n = 0; n + 1 < samples.size(); ++n) {
        for (int a = 0; a < 3; ++a) {
            const uint32_t word = frames_[n].words[a];
            EXPECT_EQ(word, hls::xy2_frame(samples[n][a], CFG_FineBits));
            EXPECT_EQ(word >> 17, 1U);
            EXPECT_EQ(__builtin_popcount(word) % 2, 0);
            // Place as a scan head counts, to half a word.
            const double place = std::ldexp(static_cast<double>(samples[n][a]), 16 - CFG_FineBits);
            const double seen = static_cast<double>(word >> 1 & 0xffff) - 0x8000;
            EXPECT_LE(std::abs(seen - std::min(place, 32767.0)), 0.5);
        }
    }
}

TEST_F(Xy2, BitsAreEvenAndPeriodsAlike) {
    for (int n = 0; n < 20; ++n) period(any_samples());
    ASSERT_GT(frames_.size(), 15U);
    for (std::size_t n = 1; n < frames_.size(); ++n) {
        const std::vector<int64_t>& falls = frames_[n].falls;
        ASSERT_EQ(falls.size(), 20U);
        EXPECT_EQ(falls[0] - frames_[n - 1].falls[0], kPeriod);
        for (int bit = 0; bit < 20; ++bit) {
            const double even = static_cast<double>(kPeriod) * bit / 20;
            EXPECT_LE(std::abs(static_cast<double>(falls[bit] - falls[0]) - even), 1);
        }
    }
}

TEST_F(Xy2, RepeatsWhatItHas) {
    for (int n = 0; n < 4; ++n) period({});
    for (const Xy2Receiver::Frame& frame : frames_) {
        EXPECT_EQ(frame.words[0], hls::xy2_frame(0, CFG_FineBits));
    }
    const std::vector<int64_t> samples = any_samples();
    period(samples);
    frames_.clear();
    for (int n = 0; n < 4; ++n) period({});
    ASSERT_GE(frames_.size(), 3U);
    for (std::size_t n = 1; n < frames_.size(); ++n) {
        EXPECT_EQ(frames_[n].words[0], hls::xy2_frame(samples[0], CFG_FineBits));
    }
}

}  // namespace
}  // namespace curvecore::tb
