// SPDX-License-Identifier: Apache-2.0
// rtl/sine_cosine_interpolator.sv equals hls::SineCosineNetwork, bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Vsine_cosine_interpolator.h"
#include "hls/clocks.hpp"
#include "hls/curves/sine_cosine.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

using Config = hls::Configuration<CFG_Order, CFG_CoefBits, 32, 10, 0, hls::SamplerMode::kSeries>;
constexpr int kOrder = CFG_Order;
constexpr int kBits = CFG_CoefBits;

// Clocks as stated in the header of the RTL.
constexpr int kDigits = (kBits + 1) / 2;
constexpr int kStepClocks = hls::sine_cosine_step_clocks({ref::Build::kParallel, kOrder, kBits});

class SineCosineInterpolator : public testing::Test {
  protected:
    SineCosineInterpolator() {
        dut_->step_i = 0;
        dut_->load_i = 0;
        start_afresh();
    }

    /// Makes a clock of reset; the RTL is ready a clock later.
    void start_afresh() {
        dut_->step_i = 0;
        dut_.reset(1);
        EXPECT_EQ(dut_->ready_o, 0);
        dut_.tick();
    }

    void load(int64_t theta, double angle) {
        theta_ = theta;
        kernel_.load(theta, std::llround(std::ldexp(std::sin(angle), Config::kCoefFrac)),
                     std::llround(std::ldexp(std::cos(angle), Config::kCoefFrac)));
        run(true);
    }

    void step() {
        kernel_.step();
        run(false);
    }

    /// Runs a step of the RTL: every pulse in its cycle, every word as the kernel's.
    void run(bool load) {
        dut_->step_i = 1;
        dut_->load_i = load;
        dut_->theta_i = to_port(load ? theta_ : 12345, kBits);
        dut_->sine_i = to_port(kernel_.y_[0], kBits);
        dut_->cosine_i = to_port(kernel_.z_[0], kBits);
        dut_.settle();
        ASSERT_EQ(dut_->ready_o, 1);
        int order = 0;
        for (int cycle = 1; cycle <= kStepClocks; ++cycle) {
            dut_.tick();
            dut_->step_i = 0;
            dut_.settle();
            ASSERT_EQ(dut_->ready_o, cycle == kStepClocks);
            const int due = kDigits + (order == 0 ? 6 : 8 + (order - 1) * (kDigits + 3));
            ASSERT_EQ(dut_->coef_valid_o, cycle == due && order <= kOrder) << cycle;
            if (!dut_->coef_valid_o) continue;
            ASSERT_EQ(dut_->order_o, order);
            ASSERT_EQ(from_port(dut_->sine_o, kBits), kernel_.y_[order]);
            ASSERT_EQ(from_port(dut_->cosine_o, kBits), kernel_.z_[order]);
            ++order;
        }
        ASSERT_EQ(order, kOrder + 1);
    }

    ClockedDut<Vsine_cosine_interpolator> dut_;
    hls::SineCosineNetwork<Config> kernel_;
    int64_t theta_ = 0;
};

TEST_F(SineCosineInterpolator, EqualsKernelOnEveryOrderOfEveryStep) {
    std::mt19937_64 random(3);
    for (int arc = 0; arc < 100; ++arc) {
        const auto theta = static_cast<int64_t>(random() & low_mask(kBits - 2)) >> (arc % 10);
        load(theta, std::uniform_real_distribution<double>(-4, 4)(random));
        for (int n = 0; n < 10 && !HasFatalFailure(); ++n) step();
        ASSERT_FALSE(HasFatalFailure()) << "arc " << arc << " theta " << theta;
    }
}

TEST_F(SineCosineInterpolator, StartsAfreshAfterAReset) {
    std::mt19937_64 random(5);
    const auto theta = [&] { return static_cast<int64_t>(random() & low_mask(kBits - 2)); };
    for (int round = 0; round < 100; ++round) {
        load(theta(), 1.0);
        dut_->step_i = 1;
        dut_.tick(random() % kStepClocks);
        start_afresh();
        load(theta(), 2.0);
        step();
        ASSERT_FALSE(HasFatalFailure()) << "round " << round;
    }
}

TEST_F(SineCosineInterpolator, StandsStillWithThetaZero) {
    load(0, 1.0);
    const auto sine = kernel_.y_[0];
    for (int n = 0; n < 5; ++n) step();
    EXPECT_EQ(kernel_.y_[0], sine);
}

}  // namespace
}  // namespace curvecore::tb
