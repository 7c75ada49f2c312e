// SPDX-License-Identifier: Apache-2.0
// rtl/path/time_scaler.sv against TimeScaler, tick by tick.
#include "hls/time_scaler.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vtime_scaler.h"
#include "tb/support/clocked_dut.hpp"
#include "tb/support/port_word.hpp"

namespace curvecore::tb {
namespace {

struct Bounds {
    int64_t acceleration;
    int64_t slope;
};

class TimeScaler : public testing::TestWithParam<Bounds> {
  protected:
    TimeScaler() : kernel_(GetParam().acceleration, GetParam().slope) {
        dut_->acceleration_i = to_port(GetParam().acceleration, 32);
        dut_->slope_i = to_port(GetParam().slope, 33);
        dut_->valid_i = 0;
        dut_.reset();
    }

    /// One clock; a tick towards `target` is offered unless it is negative. True: it was taken.
    bool clock(int32_t target) {
        dut_->valid_i = target >= 0 ? 1 : 0;
        dut_->target_i = to_port(target, 17);
        dut_.settle();
        const bool taken = dut_->valid_i && dut_->ready_o;
        if (taken) expected_.push_back(kernel_.tick(target));
        if (dut_->valid_o) compare();
        dut_.tick();
        return taken;
    }

    void compare() {
        ASSERT_FALSE(expected_.empty());
        ASSERT_EQ(static_cast<int32_t>(dut_->rate_o), expected_.front()) << "tick " << ticks_;
        rate_ = expected_.front();
        expected_.pop_front();
        ++ticks_;
    }

    void take(int32_t target) {
        while (!clock(target)) {
        }
    }

    int32_t any_target() {
        const uint32_t kind = random_() % 3;
        return kind == 0 ? 0 : kind == 1 ? 65536 : static_cast<int32_t>(random_() % 65537);
    }

    ClockedDut<Vtime_scaler> dut_;
    hls::TimeScaler kernel_;
    std::deque<int32_t> expected_;
    int32_t rate_ = 65536;
    int64_t ticks_ = 0;
    std::mt19937 random_{1};
};

TEST_P(TimeScaler, EqualsKernelForTargetsThatChangeAtRandom) {
    for (const unsigned every : {1U, 2U, 7U, 50U, 400U, 4000U}) {
        int32_t target = 65536;
        for (int n = 0; n < 40000; ++n) {
            if (random_() % every == 0) target = any_target();
            while (random_() % 8 == 0) clock(-1);
            take(target);
            if (HasFatalFailure()) FAIL() << "a new target every " << every << " ticks";
        }
    }
}

TEST_P(TimeScaler, EqualsKernelForNeighbouringTargets) {
    int32_t target = 65536;
    for (int n = 0; n < 100000; ++n) {
        if (random_() % 20 == 0) {
            target += static_cast<int32_t>(random_() % 5) - 2;
            target = std::min(std::max(target, 0), 65536);
        }
        take(target);
        ASSERT_FALSE(HasFatalFailure());
    }
}

TEST_P(TimeScaler, TakesATickPerClockTowardsOneTarget) {
    take(65536);
    const uint64_t first = dut_.cycle();
    for (int n = 0; n < 1000; ++n) take(65536);
    EXPECT_EQ(dut_.cycle() - first, 1000U);
    take(0);
    const uint64_t begin = dut_.cycle();
    for (int n = 0; n < 100000; ++n) take(0);
    // The change, the turn, the arrival.
    EXPECT_LE(dut_.cycle() - begin, 100000U + 12);
}

TEST_P(TimeScaler, LatencyIsThree) {
    for (int n = 0; n < 20; ++n) clock(-1);
    take(65536);
    for (int n = 1; n <= 3; ++n) {
        ASSERT_EQ(ticks_, 0) << n;
        clock(-1);
    }
    EXPECT_EQ(ticks_, 1);
}

INSTANTIATE_TEST_SUITE_P(Machines, TimeScaler,
                         testing::Values(Bounds{1 << 16, 1 << 24}, Bounds{1000, 1000 * 4000},
                                         Bounds{1 << 22, 1 << 26}, Bounds{77777, 77777},
                                         Bounds{int64_t{1} << 31, int64_t{1} << 32},
                                         Bounds{(1 << 20) + 12345, 16LL * ((1 << 20) + 12345)},
                                         Bounds{1, int64_t{1} << 32}));

}  // namespace
}  // namespace curvecore::tb
