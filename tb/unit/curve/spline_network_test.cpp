// SPDX-License-Identifier: Apache-2.0
// rtl/network/spline_network.sv equals the orders of hls/curves/spline.hpp: every word of each, in
// the clocks that rtl/control/spline_sequencer.sv states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "Vspline_network.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/judge/open_spline.hpp"
#include "tb/support/segments/spline_load.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kOrder = CFG_Order;
constexpr int kBits = CFG_CoefBits;
constexpr bool kSeries = CFG_Mode == 0;
constexpr bool kAnchor = CFG_Anchor != 0;
using Config =
    hls::Configuration<kOrder, kBits, 32, 10, 0,
                       kSeries ? hls::SamplerMode::kSeries : hls::SamplerMode::kPolynomial,
                       kAnchor>;
using Network = OpenSpline<Config>;
using Coef = hls::Word<kBits>;
constexpr int kTermBits = kBits + 5;  // {there, order, coefficient}

// Clocks as stated in the header of the sequencer.
constexpr int kTop = Config::kTop;
constexpr int kDigits = (kBits + 1) / 2;
constexpr int kPause = kTop > 2 || (kAnchor && kTop == 2) ? std::max(0, 2 * kDigits - 31) : 0;
constexpr int kRestQ = kOrder + kDigits + 6;
constexpr int kRest = !kAnchor  ? 12 * kOrder + 46 + (kOrder == 2 ? 14 : 0)
                      : kSeries ? std::max(kRestQ, 4 * kOrder + 15)
                                : kRestQ;
constexpr int kStepClocks =
    9 * kTop * (kTop + 1) / 2 + 27 * kTop + kPause + kRest + 1 - (kAnchor ? 0 : 3 * kOrder + 14);

class SplineNetwork : public testing::Test {
  protected:
    SplineNetwork() {
        clear();
        dut_->start_i = 0;
        dut_.reset();
    }

    void clear() {
        dut_->load_i = 0;
        dut_->start_i = 0;
    }

    /// Draws random words of a step within the ranges that the planner keeps.
    void draw() {
        const auto uniform = [&](double low, double high) {
            return low + (high - low) * std::generate_canonical<double, 53>(random_);
        };
        const auto word = [](double value, int frac) {
            return static_cast<std::int64_t>(std::floor(std::ldexp(value, frac)));
        };
        double direction[3];
        double norm = 0;
        for (double& d : direction) {
            d = uniform(-1, 1);
            norm += d * d;
        }
        const double speed = uniform(0.7, 0.9);
        for (int k = 0; k < 3; ++k) {
            kernel_.V_[k][0] = word(direction[k] / std::sqrt(norm) * speed, kBits - 1);
            kernel_.W_[k][0] = word(uniform(-0.02, 0.02), kBits + 1);
            kernel_.six_a_[k] = word(uniform(-0.01, 0.01), kBits + 1);
        }
        kernel_.phi_[0] = word(1 / speed, kBits - 2);
        kernel_.derivatives_of_phi();
    }

    void give(int place, Coef word, bool start = false) {
        dut_->load_i = static_cast<std::uint16_t>(1 << place);
        dut_->initial_i = to_port(word, kBits);
        dut_->start_i = start;
        dut_.tick();
        clear();
    }

    void load() {
        draw();
        for (int k = 0; k < 3; ++k) {
            give(load::kSixA + k, kernel_.six_a_[k]);
            give(load::kV + k, kernel_.V_[k][0]);
            give(load::kW + k, kernel_.W_[k][0]);
        }
        give(load::kR, kernel_.R_[0]);
        give(load::kQ, kernel_.Q_[0]);
        give(load::kPhi, kernel_.phi_[0], true);
    }

    /// Continues with the next step from the words that this one has reached (Anchor = 0).
    void go_on() {
        kernel_.phi_[0] = Network::sum(kernel_.phi_, 0, kTop);
        kernel_.Q_[0] = Network::sum(kernel_.Q_, 0, kOrder);
        kernel_.R_[0] = Network::sum(kernel_.R_, 0, kOrder);
        for (int k = 0; k < 3; ++k) {
            kernel_.V_[k][0] = Network::sum(kernel_.V_[k], 0, kOrder);
            kernel_.W_[k][0] = Network::sum(kernel_.W_[k], 0, kOrder);
        }
        dut_->load_i = 1 << load::kAgain;
        dut_->start_i = 1;
        dut_.tick();
        clear();
    }

    /// Checks that a present term is the series' word; `last` is the order of the last one.
    static void check(std::uint64_t term, const Coef* series, int top, int& last) {
        if (term >> (kBits + 4) == 0) return;
        const int order = static_cast<int>(term >> kBits & 15);
        ASSERT_EQ(order, last + 1);
        last = order;
        if (order > top) return;
        ASSERT_EQ(from_port(term, kBits), series[order]) << "order " << order;
    }

    /// Follows the network from the clock after its start to its end.
    void run() {
        kernel_.orders();
        int q = 0, x[3] = {}, v[3] = {}, w[3] = {};
        for (int k = 0; k < 3; ++k) v[k] = w[k] = kAnchor ? 0 : again_ ? -1 : 0;
        for (int cycle = 1; cycle <= kStepClocks; ++cycle) {
            dut_.settle();
            ASSERT_EQ(dut_->done_o, cycle == kStepClocks) << cycle;
            check(dut_->q_o, kernel_.q_, kOrder, q);
            const int top_w = kAnchor ? kTop - 1 : kOrder;
            const int top_v = kAnchor && !kSeries ? kTop - 1 : kTop;
            for (int k = 0; k < 3; ++k) {
                check(field(dut_->x_o, k * kTermBits, kTermBits), kernel_.x_[k], kOrder, x[k]);
                check(field(dut_->v_o, k * kTermBits, kTermBits), kernel_.V_[k], top_v, v[k]);
                check(field(dut_->w_o, k * kTermBits, kTermBits), kernel_.W_[k], top_w, w[k]);
            }
            if (HasFatalFailure()) FAIL() << "cycle " << cycle;
            dut_.tick();
        }
        ASSERT_EQ(q, kOrder);
        ASSERT_EQ(v[2], kTop);
        for (int axis : x) ASSERT_EQ(axis, kSeries ? kOrder : 0);
        dut_.tick();
        ASSERT_EQ(from_port(dut_->moved_o, kBits), Network::sum(kernel_.q_, 1, kOrder));
        ASSERT_EQ(from_port(dut_->phi_end_o, kBits), Network::sum(kernel_.phi_, 0, kTop));
    }

    ClockedDut<Vspline_network> dut_;
    Network kernel_;
    std::mt19937_64 random_{7};
    bool again_ = false;
};

TEST_F(SplineNetwork, EqualsKernelOnEveryOrderInItsClocks) {
    for (int step = 0; step < 300; ++step) {
        again_ = !kAnchor && step % 2 != 0;
        again_ ? go_on() : load();
        run();
        ASSERT_FALSE(HasFatalFailure()) << "step " << step;
    }
}

}  // namespace
}  // namespace curvecore::tb
