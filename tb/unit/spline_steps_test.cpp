// SPDX-License-Identifier: Apache-2.0
// rtl/network/spline_steps.sv equals hls::SplineKernel on every word of every integration step, for
// the pieces of splines that the planner makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "Vspline_steps.h"
#include "hls/spline_kernel.hpp"
#include "tb/support/clocked_dut.hpp"
#include "tb/support/port_word.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {
namespace {

constexpr int kOrder = CFG_Order;
constexpr int kBits = CFG_CoefBits;
constexpr int kFine = CFG_FineBits;
constexpr int kGuard = CFG_GuardBits;
constexpr bool kSeries = CFG_Mode == 0;
constexpr bool kAnchor = CFG_Anchor != 0;
using Config =
    hls::Configuration<kOrder, kBits, kFine - kGuard, kGuard, CFG_AuxAxes,
                       kSeries ? hls::SamplerMode::kSeries : hls::SamplerMode::kPolynomial, kAnchor,
                       0, CFG_ParameterGuard>;
constexpr int kAxes = Config::kAxes;
using Coef = hls::Word<kBits>;
using Segment = hls::SegmentWords<Config>;

/// The kernel with its words laid open.
struct Kernel : hls::SplineKernel<Config> {
    using Base = hls::SplineKernel<Config>;
    using Base::advance_;
    using Base::net_;
    using Base::position_;
    using Base::step_a_;
    using Base::step_b_;
};

// As stated in the headers of the RTL.
constexpr int kTop = kAnchor ? kOrder - 1 : kOrder;
constexpr int kDigits = (kBits + 1) / 2;
constexpr int kPause = kTop >= (kAnchor ? 2 : 3) ? std::max(0, 2 * kDigits - 31) : 0;
constexpr int kRestQ = kOrder + kDigits + 6;
constexpr int kRest = kSeries ? std::max(kRestQ, 4 * kOrder + 15) : kRestQ;
constexpr int kRestStates = 9 * kOrder + 32 + (kOrder == 2 ? 14 : 0);
constexpr int kNetwork =
    9 * kTop * (kTop + 1) / 2 + 27 * kTop + kPause + (kAnchor ? kRest : kRestStates) + 1;

class SplineSteps : public testing::Test {
  protected:
    SplineSteps() {
        dut_->start_i = 0;
        dut_.reset();
        make_segments();
    }

    void make_segments() {
        std::mt19937_64 random(6);
        segments_ = spline_pieces<Config>(5);
        for (Segment& words : segments_) {
            // Steps beyond the first dozen show nothing new.
            words.length = std::min<std::int64_t>(words.length,
                                                  std::int64_t{12} << (words.step_exponent + 16));
            for (int axis = 3; axis < kAxes; ++axis) {
                words.start[axis] = from_port(random(), kFine) / 4;
                words.end[axis] = from_port(random(), kFine) / 4;
                words.advance[axis] = from_port(random(), kBits) / 2;
            }
        }
    }

    /// Starts a step; theta, k and lambda come a clock later.
    void start(bool fresh) {
        dut_->start_i = 1;
        dut_->fresh_i = fresh;
        dut_.tick();
        dut_->start_i = 0;
    }

    /// The segment's words, as the RTL asks for them: once a clock, for points come a clock later.
    void answer(const Segment& segment) {
        const auto mask = [](std::int64_t word, int bits) { return to_port(word, bits); };
        dut_->theta_i = mask(segment.theta, kBits);
        dut_->k_i = static_cast<unsigned char>(segment.step_exponent);
        dut_->lambda_i = static_cast<unsigned char>(segment.lambda);
        dut_.settle();
        const int axis = dut_->segment_axis_o;
        const int point = std::exchange(point_, dut_->segment_point_o);
        dut_->a_i = axis < 3 ? mask(segment.tangent[axis], kBits) : 0;
        dut_->b_i = axis < 3 ? mask(segment.normal[axis], kBits) : 0;
        dut_->c_i = axis < kAxes ? mask(segment.advance[axis], kBits) : 0;
        dut_->start_point_i = point < kAxes ? mask(segment.start[point], kFine) : 0;
        dut_->end_point_i = point < kAxes ? mask(segment.end[point], kFine) : 0;
        dut_.settle();
    }

    void check_term(std::uint64_t term, const Coef* series, int& last) {
        if (term >> (kBits + 4) == 0) return;
        ASSERT_EQ(static_cast<int>(term >> kBits & 15), last + 1);
        ++last;
        ASSERT_EQ(from_port(term, kBits), series[last]) << "order " << last;
    }

    /// All words between two done_o.
    void follow(const Segment& segment, int clocks) {
        int q = 0, x[3] = {}, a = 0, v = 0, b = 0, points = 0, rates = 0;
        for (int cycle = 1;; ++cycle) {
            answer(segment);
            check_term(dut_->q_o, kernel_.net_.q, q);
            check_term(dut_->x_o, kernel_.net_.x[0], x[0]);
            check_term(dut_->y_o, kernel_.net_.x[1], x[1]);
            check_term(dut_->z_o, kernel_.net_.x[2], x[2]);
            for (int k = 0; k < 3; ++k) {
                if (dut_->a_write_o >> k & 1) {
                    ASSERT_EQ(from_port(dut_->a_o, kBits), kernel_.step_a_[k]);
                    ++a;
                }
                if (dut_->v_write_o >> k & 1) {
                    ASSERT_EQ(signed_field(dut_->v_o, k * kBits, kBits), kernel_.net_.V[k][0]);
                    ++v;
                }
                if (dut_->b_write_o >> k & 1) {
                    ASSERT_EQ(signed_field(dut_->b_o, k * kBits, kBits), kernel_.step_b_[k]);
                    ++b;
                }
            }
            if (dut_->rate_valid_o) {
                ASSERT_EQ(from_port(dut_->advance_o, kBits), kernel_.advance_[dut_->rate_axis_o]);
                ++rates;
            }
            if (dut_->point_write_o) {
                const int axis = dut_->point_axis_o;
                ASSERT_EQ(from_port(dut_->origin_o, kFine), kernel_.position_[axis]) << axis;
                ASSERT_EQ(from_port(dut_->end_o, kFine), segment.end[axis]) << axis;
                ++points;
            }
            if (HasFatalFailure()) FAIL() << "cycle " << cycle;
            ASSERT_LT(cycle, 3000);
            const bool done = dut_->done_o;
            dut_.tick();
            if (!done) continue;
            ASSERT_EQ(cycle, clocks);
            break;
        }
        ASSERT_TRUE(dut_->ready_o);
        ASSERT_EQ(q, kOrder);
        for (int order : x) ASSERT_EQ(order, kSeries ? kOrder : 0);
        ASSERT_TRUE(a == 3 && v == 3 && b == 3) << a << v << b;
        ASSERT_EQ(points, kAxes);
        ASSERT_EQ(rates, kAxes - 3);
    }

    ClockedDut<Vspline_steps> dut_;
    int point_ = 0;  // asked for in the clock before
    Kernel kernel_;
    std::vector<Segment> segments_;
};

TEST_F(SplineSteps, EqualsKernelOnEveryWordInTheClocksStated) {
    ASSERT_GT(segments_.size(), 20U);
    int steps = 0;
    for (std::size_t n = 0; n < segments_.size(); ++n) {
        const Segment& segment = segments_[n];
        const std::int64_t full = std::int64_t{1} << (segment.step_exponent + 16);
        std::int64_t rest = segment.length;
        for (bool first = true; rest > 0; first = false, rest -= full) {
            first ? kernel_.load(segment) : kernel_.step();
            start(first);
            follow(segment, (kAnchor || first ? 92 : 3) + kNetwork);
            ASSERT_FALSE(HasFatalFailure()) << "segment " << n << " rest " << rest;
            ++steps;
        }
    }
    EXPECT_GT(steps, 100);
}

}  // namespace
}  // namespace curvecore::tb
