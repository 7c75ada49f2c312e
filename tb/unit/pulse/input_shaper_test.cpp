// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/input_shaper.sv equals hls/input_shaper.hpp for any rates, words and references.
#include "hls/input_shaper.hpp"

#include <gtest/gtest.h>

#include <random>

#include "Vinput_shaper.h"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::tb {
namespace {
using namespace sysc;
using hls::StepRate;

constexpr int kAxes = CFG_Axes;
constexpr int kRateBits = hls::kStepFraction + CFG_PeriodLog2;
constexpr std::int64_t kHalf = std::int64_t{1} << (kRateBits - 1);

class InputShaper : public testing::Test {
  protected:
    void SetUp() override {
        dut_.limit_cycles(UINT64_MAX);
        dut_->off_i = 0;
        dut_->write_i = 0;
        dut_->load_i = 0;
        dut_.reset();
    }

    unsigned any(unsigned end) { return static_cast<unsigned>(random_() % end); }
    std::int64_t any_signed(int bits) {
        return static_cast<std::int64_t>(random_()) >> (64 - bits);
    }

    void write(int axis, const hls::ShaperWords& words) {
        dut_->write_i = 1;
        dut_->axis_i = static_cast<unsigned char>(axis);
        for (int kind = 0; kind < 3; ++kind) {
            const int value = kind == 0 ? words.delay : kind == 1 ? words.near : words.far;
            dut_->kind_i = static_cast<unsigned char>(kind);
            dut_->value_i = static_cast<unsigned>(value) & ((1U << hls::kGainBits) - 1);
            clock();
        }
        dut_->write_i = 0;
        twins_[static_cast<std::size_t>(axis)].set(words);
    }

    /// Loads a rate for each axis, or none, as rtl/pulse/sample_period.sv does, and compares what
    /// comes of them.
    void period(const std::vector<StepRate>& rates, bool none) {
        dut_->referenced_i = referenced_;
        dut_->none_i = none;
        for (int axis = 0; axis < kAxes; ++axis) {
            const StepRate& rate = rates[static_cast<std::size_t>(axis)];
            dut_->load_i = static_cast<unsigned short>(1U << axis);
            dut_->fresh_i = rate.fresh;
            dut_->moves_i = rate.moves;
            dut_->refused_i = rate.refused;
            dut_->rate_i = static_cast<unsigned>(rate.rate & (2 * kHalf - 1));
            clock();
            dut_->load_i = 0;
        }
        int next = 0;
        for (int n = 0; n < 30 * kAxes && next < kAxes; ++n) {
            if (dut_->load_o != 0) {
                ASSERT_EQ(n, 25 * kAxes + 1 + next);  // as the module's header says
                compare(next++, none, rates);
            }
            clock();
        }
        ASSERT_EQ(next, kAxes);
        bool settled = true;
        for (int axis = 0; axis < kAxes; ++axis) {
            const bool referenced = (referenced_ >> axis & 1) != 0;
            settled = settled && (!referenced || twins_[static_cast<std::size_t>(axis)].settled());
        }
        ASSERT_EQ(dut_->settled_o, settled);
        settled_ += settled;
    }

    void compare(int axis, bool none, const std::vector<StepRate>& rates) {
        const auto a = static_cast<std::size_t>(axis);
        const bool referenced = (referenced_ >> axis & 1) != 0;
        const StepRate twin = twins_[a].next(none ? StepRate{} : rates[a], referenced);
        ASSERT_EQ(dut_->load_o, 1U << axis);
        ASSERT_EQ(dut_->fresh_o, twin.fresh);
        ASSERT_EQ(dut_->moves_o, twin.moves);
        ASSERT_EQ(dut_->refused_o, twin.refused);
        if (referenced || twin.fresh) {
            ASSERT_EQ(dut_->rate_o, static_cast<unsigned>(twin.rate & (2 * kHalf - 1)));
        }
        refused_ += twin.refused;
        moves_ += twin.moves;
    }

    void clock() { dut_.tick(); }

    ClockedDut<Vinput_shaper> dut_;
    std::mt19937_64 random_{5};
    std::vector<hls::InputShaper> twins_{kAxes, hls::InputShaper(CFG_Places, CFG_PeriodLog2)};
    unsigned referenced_ = 0;
    int refused_ = 0;
    int moves_ = 0;
    int settled_ = 0;
};

TEST_F(InputShaper, EqualsItsTwin) {
    for (int machine = 0; machine < 60; ++machine) {
        const int bits = 4 + static_cast<int>(any(kRateBits - 4));  // of the rates
        dut_->off_i = 1;  // what was written does not count any more
        clock();
        for (hls::InputShaper& twin : twins_) twin.set({});
        for (int axis = 0; axis < kAxes && machine % 8 != 7; ++axis) {
            const int gain_bits = any(4) == 0 ? hls::kGainBits : 14;
            write(axis, {static_cast<int>(any(CFG_Places / 2)),
                         static_cast<std::int32_t>(any_signed(gain_bits)),
                         static_cast<std::int32_t>(any_signed(gain_bits))});
        }
        dut_->off_i = 0;
        const unsigned begin = any(20);
        referenced_ = 0;
        for (unsigned n = 0; n < 300; ++n) {
            std::vector<StepRate> rates(kAxes);
            for (StepRate& rate : rates) {
                rate.rate = any_signed(bits);
                rate.fresh = n == begin || any(200) == 0;
                rate.moves = n % 200 < 120 && !rate.fresh && rate.rate != 0 && any(50) != 0;
                rate.refused = !rate.fresh && any(300) == 0;
            }
            period(rates, any(20) == 0);
            if (HasFatalFailure()) return;
            if (n >= begin) referenced_ = any(100) == 0 ? any(1U << kAxes) : (1U << kAxes) - 1;
        }
    }
    EXPECT_GT(moves_, 1000);
    EXPECT_GT(refused_, 100);
    EXPECT_GT(settled_, 100);
}

}  // namespace
}  // namespace curvecore::tb
