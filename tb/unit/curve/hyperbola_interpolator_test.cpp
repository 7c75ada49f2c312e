// SPDX-License-Identifier: Apache-2.0
// rtl/hyperbola_interpolator.sv equals hls::HyperbolaNetwork, bit for bit, and in its cycles.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "Vhyperbola_interpolator.h"
#include "hls/clocks.hpp"
#include "hls/curves/hyperbola.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kOrder = CFG_Order;
constexpr int kBits = CFG_CoefBits;
constexpr bool kAnchor = CFG_Anchor != 0;
using Config =
    hls::Configuration<kOrder, kBits, 32, 10, 0, hls::SamplerMode::kSeries, CFG_Anchor != 0>;

// Clocks as stated in the header of the RTL.
constexpr int kDigits = (kBits + 1) / 2;
constexpr int kLastZ = kAnchor ? kOrder - 1 : kOrder;

int y_cycle(int i, bool carried) {
    if (i == 0) return 1;
    return 16 + (i - 1) * (kDigits + 16) + 2 * i * (i + 1) - (carried ? 13 : 0);
}
int z_cycle(int i, bool carried) {
    return y_cycle(i, carried) + (carried && i == 0 ? 0 : 4 * (i + 1) + 9);
}
int step_clocks(bool carried) {
    hls::TimedCore core{ref::Build::kParallel, kOrder, kBits};
    core.anchor = kAnchor;
    return hls::hyperbola_step_clocks(core, !carried);
}

class HyperbolaInterpolator : public testing::Test {
  protected:
    HyperbolaInterpolator() {
        dut_->load_i = 0;
        start_afresh();
    }

    /// Makes a clock of reset; the RTL is ready two clocks later.
    void start_afresh() {
        dut_->step_i = 0;
        dut_.reset(1);
        for (int clock = 0; clock < 2; ++clock) {
            EXPECT_EQ(dut_->ready_o, 0);
            dut_.tick();
        }
    }

    /// A start word of any size.
    int64_t start() {
        return static_cast<int64_t>(random_() & low_mask(kBits - 1)) >> random_() % 9;
    }

    void load(int64_t word) {
        kernel_.load(word);
        run(true);
    }
    void step() {
        kernel_.step();
        run(false);
    }

    /// Runs a step of the RTL: every pulse in its cycle, every word as the kernel's.
    void run(bool load) {
        const bool carried = !kAnchor && !load;
        dut_->step_i = 1;
        dut_->load_i = load;
        dut_->y_i = to_port(load ? kernel_.y_[0] : 12345, kBits);
        dut_.settle();
        ASSERT_EQ(dut_->ready_o, 1);
        int y = 0;
        int z = 0;
        for (int cycle = 1; cycle <= step_clocks(carried); ++cycle) {
            dut_.tick();
            dut_->step_i = 0;
            dut_.settle();
            ASSERT_EQ(dut_->ready_o, cycle == step_clocks(carried)) << cycle;
            ASSERT_EQ(dut_->y_valid_o, y <= kOrder && cycle == y_cycle(y, carried)) << cycle;
            ASSERT_EQ(dut_->z_valid_o, z <= kLastZ && cycle == z_cycle(z, carried)) << cycle;
            if (dut_->y_valid_o) {
                ASSERT_EQ(dut_->order_o, y);
                ASSERT_EQ(from_port(dut_->y_o, kBits), kernel_.y_[y++]);
            }
            if (dut_->z_valid_o) {
                ASSERT_EQ(dut_->order_o, z);
                ASSERT_EQ(from_port(dut_->z_o, kBits), kernel_.z_[z++]);
            }
        }
        ASSERT_EQ(y, kOrder + 1);
        ASSERT_EQ(z, kLastZ + 1);
    }

    ClockedDut<Vhyperbola_interpolator> dut_;
    hls::HyperbolaNetwork<Config> kernel_;
    std::mt19937_64 random_{3};
};

TEST_F(HyperbolaInterpolator, EqualsKernelOnEveryOrderOfEveryStepInItsCycle) {
    for (int n = 0; n < 100; ++n) {
        const int64_t word = start();
        load(word);
        for (int i = 0; i < 10 && !HasFatalFailure(); ++i) step();
        ASSERT_FALSE(HasFatalFailure()) << "hyperbola " << n << " from " << word;
    }
}

TEST_F(HyperbolaInterpolator, EqualsKernelAtTheEndsOfItsRange) {
    for (const int64_t word : {int64_t{0}, int64_t{1}, int64_t{2}, (int64_t{1} << (kBits - 2)),
                               (int64_t{1} << (kBits - 1)) - 1}) {
        load(word);
        for (int i = 0; i < 3 && !HasFatalFailure(); ++i) step();
        ASSERT_FALSE(HasFatalFailure()) << word;
    }
}

TEST_F(HyperbolaInterpolator, StartsAfreshAfterAReset) {
    for (int round = 0; round < 100; ++round) {
        load(start());
        dut_->step_i = 1;
        dut_.tick(random_() % step_clocks(!kAnchor));
        start_afresh();
        load(start());
        step();
        ASSERT_FALSE(HasFatalFailure()) << "round " << round;
    }
}

}  // namespace
}  // namespace curvecore::tb
