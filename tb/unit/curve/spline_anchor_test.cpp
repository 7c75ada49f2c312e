// SPDX-License-Identifier: Apache-2.0
// rtl/anchor/spline_anchor.sv equals the start of a step in hls/curves/spline.hpp, word for word.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Vspline_anchor.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/judge/open_spline.hpp"
#include "tb/support/segments/spline_load.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kBits = CFG_CoefBits;
constexpr bool kAnchor = CFG_Anchor != 0;
using Config = hls::Configuration<6, kBits, 32, 10, 0, hls::SamplerMode::kPolynomial,
                                  CFG_Anchor != 0, CFG_ParameterGuard>;
using Coef = hls::Word<kBits>;

using Kernel = OpenSpline<Config>;

// Clocks as stated in the header of the RTL.
constexpr int kStart = 92;
constexpr int kLast = 135;

class SplineAnchor : public testing::Test {
  protected:
    SplineAnchor() {
        dut_->begin_i = 0;
        dut_.reset();
    }

    void draw() {
        const auto uniform = [&](double low, double high, int frac) {
            const double unit = std::generate_canonical<double, 53>(random_);
            return std::llround(std::ldexp(low + (high - low) * unit, frac));
        };
        double norm = 0;
        for (int axis = 0; axis < 3; ++axis) {
            segment_.tangent[axis] = uniform(-0.1, 0.1, kBits - 2);
            segment_.normal[axis] = uniform(-0.3, 0.3, kBits - 2);
            segment_.advance[axis] = uniform(-0.5, 0.5, kBits - 2) + (axis == 0 ? 1 : 0);
            norm += std::pow(std::ldexp(segment_.advance[axis], 2 - kBits), 2);
        }
        const double speed = std::uniform_real_distribution<double>(0.75, 0.85)(random_);
        for (int axis = 0; axis < 3; ++axis) {
            segment_.advance[axis] = std::llround(segment_.advance[axis] * speed / std::sqrt(norm));
        }
        segment_.theta = std::llround(std::ldexp(1 / speed, kBits - 2));
        const int s = 4 + static_cast<int>(random_() % 24);
        segment_.lambda = s + static_cast<int>(random_() % static_cast<unsigned>(28 - s));
        segment_.step_exponent = segment_.lambda - s;
    }

    void step(bool fresh) {
        const Coef moved = Kernel::sum(kernel_.q_, 1, Config::kOrder);
        const Coef phi_end = Kernel::sum(kernel_.phi_, 0, Config::kTop);
        if (fresh) {
            draw();
            kernel_.load(segment_);
        } else {
            kernel_.step();
        }
        dut_->begin_i = 1;
        dut_->fresh_i = fresh;
        dut_->s_i = static_cast<std::uint8_t>(segment_.lambda - segment_.step_exponent);
        dut_->theta_i = to_port(segment_.theta, kBits);
        dut_->phi_end_i = to_port(phi_end, kBits);
        dut_->moved_i = to_port(moved, kBits);
        const bool quiet = !kAnchor && !fresh;
        int seen = 0;
        const auto expect = [&](bool there, Coef word, const char* name) {
            if (!there) return;
            ++seen;
            ASSERT_EQ(from_port(dut_->word_o, kBits), word) << name;
        };
        for (int cycle = 1; cycle <= kLast + 1; ++cycle) {
            dut_.tick();
            dut_->begin_i = 0;
            dut_.settle();
            const int axis = dut_->axis_o < 3 ? dut_->axis_o : 0;
            dut_->a_i = to_port(segment_.tangent[axis], kBits);
            dut_->b_i = to_port(segment_.normal[axis], kBits);
            dut_->c_i = to_port(segment_.advance[axis], kBits);
            if (cycle > 11) dut_->phi_end_i = dut_->moved_i = 0;
            dut_.settle();
            ASSERT_EQ(dut_->start_o, cycle == (quiet ? 3 : kStart)) << cycle;
            const int loads = dut_->load_o;
            ASSERT_EQ(loads >> load::kAgain & 1, quiet && cycle == 3) << cycle;
            for (int k = 0; k < 3; ++k) {
                expect(loads >> (load::kSixA + k) & 1, kernel_.six_a_[k], "6a'");
                expect(dut_->step_a_there_o >> k & 1, kernel_.step_a_[k], "a'");
                expect(loads >> (load::kV + k) & 1, kernel_.V_[k][0], "V");
                expect(loads >> (load::kW + k) & 1, kernel_.W_[k][0], "W");
            }
            expect(loads >> load::kPhi & 1, kernel_.phi_[0], "phi");
            expect(loads >> load::kQ & 1, kernel_.Q_[0], "Q");
            expect(loads >> load::kR & 1, kernel_.R_[0], "R");
            ASSERT_FALSE((loads >> load::kPhi & 1) != 0 && cycle >= kStart);
            const bool d_there = cycle == kLast - 8 || cycle == kLast - 4 || cycle == kLast;
            ASSERT_EQ(dut_->d_there_o, d_there) << cycle;
            if (d_there) {
                const int k = (cycle - kLast + 8) / 4;
                ASSERT_EQ(dut_->d_axis_o, k);
                ASSERT_EQ(from_port(dut_->d_o, kBits), kernel_.displacement(k));
            }
            if (HasFatalFailure()) FAIL() << "cycle " << cycle;
        }
        ASSERT_EQ(seen, quiet ? 6 : 15);
    }

    ClockedDut<Vspline_anchor> dut_;
    Kernel kernel_;
    hls::SegmentWords<Config> segment_;
    std::mt19937_64 random_{11};
};

TEST_F(SplineAnchor, EqualsKernelOnEveryWordOfEveryStep) {
    for (int n = 0; n < 1000; ++n) {
        step(n % 4 == 0);
        ASSERT_FALSE(HasFatalFailure())
            << "step " << n << " lambda " << segment_.lambda << " k " << segment_.step_exponent;
    }
}

}  // namespace
}  // namespace curvecore::tb
