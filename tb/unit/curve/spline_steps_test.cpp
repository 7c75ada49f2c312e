// SPDX-License-Identifier: Apache-2.0
// rtl/network/spline_steps.sv equals hls::SplineCurve on every word of every integration step, for
// the pieces of splines that the planner makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "Vspline_steps.h"
#include "hls/clocks.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/judge/open_spline.hpp"
#include "tb/support/segments/spline_segments.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kOrder = CFG_Order;
constexpr int kBits = CFG_CoefBits;
constexpr int kFine = CFG_FineBits;
constexpr int kGuard = CFG_GuardBits;
constexpr bool kSeries = CFG_Mode == 0;
constexpr bool kAnchor = CFG_Anchor != 0;
constexpr int kAxes = 3 + CFG_AuxAxes;

CoreParameters core() {
    CoreParameters core;
    core.order = kOrder;
    core.coef_bits = kBits;
    core.position_bits = kFine - kGuard;
    core.guard_bits = kGuard;
    core.aux_axes = CFG_AuxAxes;
    core.mode = CFG_Mode;
    core.anchor = CFG_Anchor;
    core.parameter_guard = CFG_ParameterGuard;
    return core;
}

using Kernel = OpenSpline<RunTimeFormat>;

constexpr hls::TimedCore kCore{
    ref::Build::kParallel, kOrder, kBits, CFG_AuxAxes, kSeries, false, true, 1, kAnchor};

class SplineSteps : public testing::Test {
  protected:
    SplineSteps() {
        dut_->start_i = 0;
        dut_.reset();
        make_segments();
    }

    void make_segments() {
        std::mt19937_64 random(6);
        segments_ = spline_pieces(core(), 5);
        for (RunSegment& words : segments_) {
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

    /// Starts a step; theta, k and lambda follow a clock later.
    void start(bool fresh) {
        dut_->start_i = 1;
        dut_->fresh_i = fresh;
        dut_.tick();
        dut_->start_i = 0;
    }

    /// Answers with the segment's words when the RTL requests them: once a clock, points a clock
    /// later.
    void answer(const RunSegment& segment) {
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

    /// Checks the words that go into the bank: terms one order after the other, words of the cubic.
    void check_write() {
        const std::uint32_t write = dut_->write_o;
        const int place = static_cast<int>(write >> 2 & 15);
        const auto word = [&](int lane) {
            return signed_field(dut_->words_o, lane * kBits, kBits);
        };
        if ((write >> 10) != 0) {
            ASSERT_EQ(write & 3, bank_ & 3);
        }
        for (int k = 0; k < 3; ++k) {
            if ((write >> (10 + k) & 1) == 0) continue;
            if (kSeries) {
                ASSERT_EQ(place, ++x_[k]);
                ASSERT_EQ(word(k), kernel_.x_[k][place]) << "order " << place;
            } else {
                const std::int64_t cubic[] = {kernel_.V_[k][0], kernel_.half_W_[k],
                                              kernel_.step_a_[k]};
                ASSERT_TRUE(place >= 1 && place <= 3) << place;
                ASSERT_EQ(word(k), cubic[place - 1]) << "power " << place;
                ++cubic_[place - 1];
            }
        }
        if ((write >> 13 & 1) != 0) {
            const int order = static_cast<int>(write >> 6 & 15);
            ASSERT_EQ(order, ++own_);
            ASSERT_EQ(word(3), kernel_.q_[order]) << "order " << order;
        }
        ASSERT_EQ(write >> 14, 0U);
    }

    /// Follows all words between two done_o.
    void follow(const RunSegment& segment, int clocks) {
        int points = 0, rates = 0;
        own_ = 0;
        for (int k = 0; k < 3; ++k) x_[k] = cubic_[k] = 0;
        dut_->bank_i = bank_ & 3;
        for (int cycle = 1;; ++cycle) {
            answer(segment);
            check_write();
            if (field(dut_->rate_o, kBits + 4, 1) != 0) {
                const auto axis = field(dut_->rate_o, kBits, 4);
                ASSERT_EQ(signed_field(dut_->rate_o, 0, kBits), segment.advance[axis]);
                ++rates;
            }
            if (field(dut_->point_o, 2 * kFine + 4, 1) != 0) {
                const auto axis = field(dut_->point_o, 2 * kFine, 4);
                ASSERT_EQ(signed_field(dut_->point_o, 0, kFine), kernel_.origin_[axis]) << axis;
                ASSERT_EQ(signed_field(dut_->point_o, kFine, kFine), segment.end[axis]) << axis;
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
        // The last term comes now, into the same bank; the next step uses another.
        dut_->bank_i = (bank_ + 1) & 3;
        dut_.settle();
        check_write();
        ++bank_;
        ASSERT_EQ(own_, kSeries ? 0 : kOrder);
        for (int order : x_) ASSERT_EQ(order, kSeries ? kOrder : 0);
        for (int count : cubic_) ASSERT_EQ(count, kSeries ? 0 : 3);
        ASSERT_EQ(points, kAxes);
        ASSERT_EQ(rates, kAxes - 3);
    }

    ClockedDut<Vspline_steps> dut_;
    int point_ = 0;  // point requested in the clock before
    unsigned bank_ = 0;
    // Words written in this step: orders of the own series, of X Y Z; words of V, B', a'.
    int own_ = 0;
    int x_[3] = {};
    int cubic_[3] = {};
    Kernel kernel_{RunTimeFormat(core(), kAxes)};
    std::vector<RunSegment> segments_;
};

TEST_F(SplineSteps, EqualsKernelOnEveryWordInTheClocksStated) {
    ASSERT_GT(segments_.size(), 20U);
    int steps = 0;
    for (std::size_t n = 0; n < segments_.size(); ++n) {
        const RunSegment& segment = segments_[n];
        const std::int64_t full = std::int64_t{1} << (segment.step_exponent + 16);
        std::int64_t rest = segment.length;
        for (bool first = true; rest > 0; first = false, rest -= full) {
            first ? kernel_.load(segment) : kernel_.step();
            start(first);
            follow(segment, hls::spline_step_clocks(kCore, first));
            ASSERT_FALSE(HasFatalFailure()) << "segment " << n << " rest " << rest;
            ++steps;
        }
    }
    EXPECT_GT(steps, 100);
}

}  // namespace
}  // namespace curvecore::tb
