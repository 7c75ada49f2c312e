// SPDX-License-Identifier: Apache-2.0
// rtl/arithmetic/horner.sv against the kernel's products, every pass a rounding.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vhorner.h"
#include "hls/fixed_word.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kPasses = CFG_Passes;
constexpr int kLanes = CFG_Lanes;
constexpr int kInterval = CFG_Interval;
constexpr int kBits = CFG_Bits;
constexpr int kShift = CFG_Shift;
constexpr int kLastShift = CFG_LastShift;
constexpr int kBanks = 4;
constexpr int kLoop = kInterval == 1 ? 6 : kInterval == 2 ? 7 : 9;
constexpr int kLatency = kPasses * kLoop + (kInterval == 1 ? 1 : 0);

class Horner : public testing::Test {
  protected:
    Horner() {
        dut_->en_i = 1;
        dut_->valid_i = 0;
        dut_->write_i = 0;
        dut_->phase_i = 0;
        dut_.reset();
    }

    /// Random coefficients whose sums stay below 2.
    void fill(int bank) {
        for (int pass = 0; pass < kPasses; ++pass) {
            for (int lane = 0; lane < kLanes; ++lane) {
                coef_[bank][pass][lane] = from_port(random_(), kBits) >> (3 + random_() % 8);
                set_field(dut_->write_coef_i, lane * kBits, kBits, coef_[bank][pass][lane]);
            }
            dut_->write_i = 1;
            dut_->write_lanes_i = (1 << CFG_Lanes) - 1;
            dut_->write_bank_i = bank;
            dut_->write_pass_i = pass;
            clock(false);
            dut_->write_i = 0;
        }
    }

    int64_t expected(int bank, int lane, int64_t x) const {
        int64_t d = 0;
        for (int pass = 0; pass < kPasses; ++pass) {
            const int64_t sum = d + coef_[bank][pass][lane];
            const int shift = pass < kPasses - 1 ? kShift : kLastShift;
            d = hls::rounded_product<hls::Word<2 * kBits>>(sum, x, shift);
        }
        return d;
    }

    /// Advances by one clock; an evaluation enters in phase 0 if wanted.
    void clock(bool wanted, bool enabled = true) {
        const bool enters = wanted && phase_ == 0;
        const int bank = static_cast<int>(random_() % kBanks);
        const auto x = static_cast<int64_t>(random_() & low_mask(kBits - 1));
        dut_->en_i = enabled;
        dut_->phase_i = phase_;
        dut_->valid_i = enters;
        dut_->x_i = to_port(x, kBits);
        dut_->tag_i = bank;
        dut_.settle();
        if (enabled) {
            check();
            if (enters) {
                Case now{clock_ + kLatency, bank, {}};
                for (int lane = 0; lane < kLanes; ++lane) now.d[lane] = expected(bank, lane, x);
                cases_.push_back(now);
            }
            ++clock_;
            phase_ = (phase_ + 1) % kInterval;
        }
        dut_.tick();
    }

    void check() {
        const bool due = !cases_.empty() && cases_.front().due == clock_;
        ASSERT_EQ(dut_->valid_o, due) << "clock " << clock_;
        if (!due) return;
        EXPECT_EQ(dut_->tag_o, cases_.front().bank);
        for (int lane = 0; lane < kLanes; ++lane) {
            ASSERT_EQ(signed_field(dut_->d_o, lane * kBits, kBits), cases_.front().d[lane]);
        }
        cases_.pop_front();
        ++checked_;
    }

    struct Case {
        int64_t due;
        int bank;
        int64_t d[kLanes];
    };
    ClockedDut<Vhorner> dut_;
    std::mt19937_64 random_{1};
    int64_t coef_[kBanks][kPasses][kLanes] = {};
    std::deque<Case> cases_;
    int phase_ = 0;
    int64_t clock_ = 0;
    int checked_ = 0;
};

TEST_F(Horner, EvaluatesOnePerIntervalWithTheStatedLatency) {
    for (int bank = 0; bank < kBanks; ++bank) fill(bank);
    for (int n = 0; n < 20'000 && !HasFatalFailure(); ++n) clock(true);
    EXPECT_GT(checked_, 20'000 / kInterval - 200);
}

TEST_F(Horner, EvaluatesWithGapsStallsAndNewBanks) {
    for (int round = 0; round < 50 && !HasFatalFailure(); ++round) {
        for (int bank = 0; bank < kBanks; ++bank) fill(bank);
        for (int n = 0; n < 500; ++n) clock(random_() % 3 != 0, random_() % 4 != 0);
        for (int n = 0; n < kLatency; ++n) clock(false);
    }
    EXPECT_TRUE(cases_.empty());
}

}  // namespace
}  // namespace curvecore::tb
