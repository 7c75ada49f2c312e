// SPDX-License-Identifier: Apache-2.0
// rtl/node/stieltjes_integrator.sv equals the functions of a kernel's lines, word for word and
// in its cycles.
#include <gtest/gtest.h>

#include <random>

#include "Vstieltjes_integrator.h"
#include "hls/curves/curve_steps.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kBits = CFG_Bits;
constexpr int kShift = CFG_Shift;
constexpr int kDrop = CFG_Drop;
constexpr int kFirst = CFG_First;
constexpr int kOrder = 12;
// Bits as in rtl/node/series_pkg.sv.
constexpr int kAgain = 1 << 0;
constexpr int kLoad = 1 << 1;
constexpr int kOrderBit = 2;
constexpr int kStart = 1 << 6;
using Word = hls::Word<kBits>;

/// D_i = sum of u_j Ds_{i-j}, and x_i = D_i / i with Drop fraction bits less, [Chikurov] (15).
struct Node
    : hls::CurveSteps<hls::Configuration<kOrder, kBits, 32, 10, 0, hls::SamplerMode::kSeries>> {
    static Word D(const Word* u, const Word* ds, int i) {
        return rounded(stieltjes(u, ds, i), kShift);
    }
    Word x(const Word& d, int i) const { return rounded(over(d, i), kBits - 1 + kDrop); }
};

class StieltjesIntegrator : public testing::Test {
  protected:
    StieltjesIntegrator() {
        dut_->control_i = 0;
        dut_->u_i = 0;
        dut_->s_i = 0;
        dut_.reset();
        dut_.tick();  // the nodes' reset is a clock late
    }

    void tick() {
        dut_.tick();
        dut_->control_i = 0;
        dut_->u_i = 0;
        dut_->s_i = 0;
        dut_.settle();
    }

    /// A term of a series: {there, order, coefficient}.
    static uint64_t term(int order, Word word) {
        return uint64_t{1} << (kBits + 4) | static_cast<uint64_t>(order) << kBits |
               to_port(word, kBits);
    }
    static bool there(uint64_t term) { return (term >> (kBits + 4)) != 0; }
    static int order(uint64_t term) { return static_cast<int>(term >> kBits & 15); }

    /// A word whose sums stay in range.
    Word word() {
        const int bits = (kBits + kShift - 5) / 2;
        return from_port(random_(), bits < kBits ? bits : kBits);
    }

    /// Opens a step with a new initial word, or with the state that the step before has reached.
    void open(bool again) {
        if (!again) state_ = word();
        dut_->control_i = again ? kAgain : kLoad;
        dut_->initial_i = to_port(again ? word() : state_, kBits);
        tick();
        ASSERT_EQ(there(dut_->x_o), true);
        ASSERT_EQ(order(dut_->x_o), 0);
        ASSERT_EQ(from_port(dut_->x_o, kBits), state_);
    }

    /// Runs one order; its newest Ds is written in the last allowed cycle.
    void run(int i) {
        u_[i - 1] = word();
        s_[i] = word();
        dut_->u_i = term(i - 1, u_[i - 1]);
        tick();
        const Word d = Node::D(u_, s_, i);
        const Word x = Node().x(d, i);
        dut_->control_i = static_cast<uint8_t>(kStart | i << kOrderBit);
        for (int cycle = 0; cycle <= 4 * i + 17; ++cycle) {
            if (cycle == i) dut_->s_i = term(i - 1 + kFirst, s_[i]);
            tick();
            const int now = cycle + 1;
            ASSERT_EQ(there(dut_->d_o), now == 4 * i + 6) << now;
            ASSERT_EQ(there(dut_->x_o), now == 4 * i + 15) << now;
            if (now >= 4 * i + 6 && now < 4 * i + 11) {
                ASSERT_EQ(from_port(dut_->d_o, kBits), d) << "D " << i;
                ASSERT_EQ(order(dut_->d_o), i);
            }
            if (now == 4 * i + 15) {
                ASSERT_EQ(from_port(dut_->x_o, kBits), x) << "x " << i;
                ASSERT_EQ(order(dut_->x_o), i);
            }
        }
        state_ = from_port(static_cast<uint64_t>(state_ + x), kBits);
        ASSERT_EQ(from_port(dut_->state_o, kBits), state_);
    }

    ClockedDut<Vstieltjes_integrator> dut_;
    std::mt19937_64 random_{5};
    Word u_[kOrder + 1] = {};
    Word s_[kOrder + 1] = {};
    Word state_ = 0;
};

TEST_F(StieltjesIntegrator, EqualsKernelOnEveryOrderInItsCycle) {
    for (int step = 0; step < 200; ++step) {
        open(step % 3 == 1);
        for (int i = 1; i <= kOrder && !HasFatalFailure(); ++i) run(i);
        ASSERT_FALSE(HasFatalFailure()) << "step " << step;
    }
}

}  // namespace
}  // namespace curvecore::tb
