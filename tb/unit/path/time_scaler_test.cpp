// SPDX-License-Identifier: Apache-2.0
// rtl/time/time_scaler.sv against TimeScaler, tick by tick.
#include "hls/time_scaler.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vtime_scaler.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

const int kFewer = cases(4, 1);  // divides the number of ticks

struct Bounds {
    int64_t acceleration;
    int64_t slope;
};

class TimeScalerBench : public testing::Test {
  protected:
    void start(const Bounds& bounds) {
        kernel_ = hls::TimeScaler(bounds.acceleration, bounds.slope);
        dut_->acceleration_i = to_port(bounds.acceleration, 32);
        dut_->slope_i = to_port(bounds.slope, 33);
        dut_->valid_i = 0;
        dut_->step_valid_i = 0;
        dut_->next_wait_i = 0;
        dut_->begins_i = 0;
        dut_.reset();
        expected_.clear();
        steps_ = 0;
        stands_ = false;
        stops_on_ = false;
    }

    /// Advances by one clock; a tick towards `target` is offered unless it is negative. Returns
    /// true if it was taken.
    bool clock(int32_t target, const hls::StopDue& due = {}) {
        dut_->valid_i = target >= 0 ? 1 : 0;
        dut_->target_i = to_port(target, 17);
        dut_->next_wait_i = to_port(due.wait, 20);
        dut_->begins_i = due.begins ? 1 : 0;
        // A tick that lands is offered when the rates of all before it are out.
        const bool idle = idle_percent_ > 0 && expected_.empty() && random_() % 100 < idle_percent_;
        dut_->land_i = target >= 0 && kernel_.lands(target, idle) ? 1 : 0;
        const hls::StopStep offered = step(steps_);
        dut_->step_valid_i = random_() % 4 != 0 ? 1 : 0;
        dut_->step_ticks_i = to_port(offered.ticks, 11);
        dut_->step_change_i = to_port(offered.change, 32);
        dut_->step_last_i = offered.last ? 1 : 0;
        dut_.settle();
        const bool taken = dut_->valid_i && dut_->ready_o;
        const bool stepped = dut_->step_ready_o && dut_->step_valid_i;
        const uint64_t before = steps_;
        if (taken) {
            const int32_t rate = kernel_.tick(target, idle, due, [this] { return step(steps_++); });
            EXPECT_EQ(dut_->steady_o != 0, kernel_.steady());
            EXPECT_EQ(dut_->passed_o != 0, kernel_.passed());
            landed_ += dut_->land_i;
            expected_.push_back({target, rate});
        }
        EXPECT_EQ(stepped, steps_ != before);
        EXPECT_EQ(dut_->stopping_o != 0, stops_on_);
        if (taken) stops_on_ = kernel_.stopping();
        if (dut_->valid_o) compare();
        dut_.tick();
        return taken;
    }

    void compare() {
        ASSERT_FALSE(expected_.empty());
        const Tick tick = expected_.front();
        ASSERT_EQ(static_cast<int32_t>(dut_->rate_o), tick.rate) << "tick " << ticks_;
        ASSERT_EQ(dut_->held_o != 0, tick.target == 0) << "tick " << ticks_;
        // Time stands still until a target is not 0.
        if (tick.target != 0) stands_ = false;
        if (dut_->still_o) stands_ = true;
        ASSERT_TRUE(tick.target == 0 || !dut_->still_o) << "tick " << ticks_;
        ASSERT_TRUE(tick.rate == 0 || !stands_) << "tick " << ticks_;
        expected_.pop_front();
        ++ticks_;
    }

    void take(int32_t target, const hls::StopDue& due = {}) {
        while (!clock(target, due)) {
        }
    }

    /// Branch steps that need not match each other.
    static hls::StopStep step(uint64_t index) {
        std::mt19937 random(static_cast<unsigned>(index));
        hls::StopStep step;
        step.ticks = static_cast<int32_t>(1 + random() % (random() % 2 ? 3 : 40));
        step.change = static_cast<int32_t>(random() >> (random() % 30));
        step.last = random() % 6 == 0;
        return step;
    }

    int32_t any_target() {
        const uint32_t kind = random_() % 3;
        if (random_() % 8 == 0) return ref::kFineRate - 2 + static_cast<int32_t>(random_() % 5);
        return kind == 0 ? 0 : kind == 1 ? 65536 : static_cast<int32_t>(random_() % 65537);
    }

    /// A rate at which a stop takes a branch, or about the least of these.
    int32_t any_running() {
        if (random_() % 3 == 0) return 65536;
        return ref::kBranchRate - 2 + static_cast<int32_t>(random_() % (random_() % 4 ? 28675 : 5));
    }

    struct Tick {
        int32_t target;
        int32_t rate;
    };

    ClockedDut<Vtime_scaler> dut_;
    hls::TimeScaler kernel_{1, 1};
    std::deque<Tick> expected_;
    uint64_t steps_ = 0;         // steps taken
    unsigned idle_percent_ = 0;  // percentage of ticks before which all rates are out
    int64_t landed_ = 0;
    bool stops_on_ = false;
    bool stands_ = false;
    int64_t ticks_ = 0;
    std::mt19937_64 random_{1};
};

class TimeScaler : public TimeScalerBench, public testing::WithParamInterface<Bounds> {
  protected:
    TimeScaler() { start(GetParam()); }
};

TEST_P(TimeScaler, EqualsKernelForTargetsThatChangeAtRandom) {
    for (const unsigned every : {1U, 2U, 7U, 50U, 400U, 4000U}) {
        int32_t target = 65536;
        for (int n = 0; n < 40000 / kFewer; ++n) {
            if (random_() % every == 0) target = any_target();
            while (random_() % 8 == 0) clock(-1);
            take(target);
            if (HasFatalFailure()) FAIL() << "a new target every " << every << " ticks";
        }
    }
}

TEST_P(TimeScaler, EqualsKernelForStopsByBranches) {
    uint64_t steps = 0;
    for (const unsigned every : {20U, 400U, 4000U}) {
        int32_t running = 65536;
        int32_t target = running;
        start(GetParam());
        for (int n = 0; n < 100000 / kFewer; ++n) {
            if (random_() % (4 * every) == 0) running = any_running();
            if (random_() % every == 0) {
                target = random_() % 4 == 0 ? any_target() : target == 0 ? running : 0;
            }
            const bool due = random_() % (every / 4) == 0;
            const auto wait = static_cast<int32_t>(random_() % every);
            while (random_() % 8 == 0) clock(-1);
            take(target, due && wait > 0 ? hls::StopDue(wait, random_() % 2) : hls::StopDue());
            if (HasFatalFailure()) FAIL() << "a new target every " << every << " ticks";
        }
        steps += steps_;
    }
    EXPECT_GT(steps, 0U);
}

/// Rates of any kind, at rest or changing, up or down, above or below 7/8.
TEST_P(TimeScaler, EqualsKernelWhereNothingIsUnderWay) {
    for (const unsigned every : {3U, 20U, 400U}) {
        int32_t target = 65536;
        start(GetParam());
        for (int n = 0; n < 40000 / kFewer; ++n) {
            idle_percent_ = n / 100 % 2 * 50;
            if (random_() % every == 0) target = any_target();
            const bool due = random_() % 50 == 0;
            if (idle_percent_ > 0) {
                while (!expected_.empty() && !HasFatalFailure()) clock(-1);
            }
            take(target, due ? hls::StopDue(40, random_() % 2) : hls::StopDue());
            if (HasFatalFailure()) FAIL() << "a new target every " << every << " ticks";
        }
    }
    EXPECT_GT(landed_, 1000 / kFewer);
}

TEST_P(TimeScaler, FirstTickThatIsNotHeldLandsOnItsTarget) {
    int held = 0;
    for (const int32_t target : {0, 1, 23456, 65535, 65536}) {
        for (int n = 0; n < 100; ++n) take(any_target());
        start(GetParam());
        for (int n = 0; n < held; ++n) take(0);
        held = 3 * held + 1;
        take(target);
        ASSERT_EQ(expected_.back().rate, target);
        for (int n = 0; n < 10; ++n) take(target);
        ASSERT_FALSE(HasFatalFailure()) << "target " << target;
    }
}

TEST_P(TimeScaler, TellsThatTimeStandsStill) {
    take(65536);
    for (int n = 0; n < 300000 && !stands_; ++n) take(0);
    EXPECT_TRUE(stands_);
}

TEST_P(TimeScaler, EqualsKernelForNeighbouringTargets) {
    int32_t target = 65536;
    for (int n = 0; n < 100000 / kFewer; ++n) {
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
    EXPECT_EQ(dut_.cycle() - first, 1003U);  // it landed
    take(0);
    const uint64_t begin = dut_.cycle();
    for (int n = 0; n < 100000; ++n) take(0);
    // Twice: the change, the turn, the arrival. Once: the passage of 7/8.
    EXPECT_LE(dut_.cycle() - begin, 100000U + 2 * 12 + 3);
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

// Random words, also invalid ones, which are never obeyed: every target is then 0.
TEST_F(TimeScalerBench, EqualsKernelForRandomWords) {
    const auto word = [&](int bits) {
        return static_cast<int64_t>(random_() >> (64 - bits) >> (random_() % bits));
    };
    int possible = 0;
    for (int set = 0; set < 2000; ++set) {
        Bounds bounds{word(32), word(33)};
        if (set % 3 == 1) bounds.slope = (1 + word(8)) * bounds.acceleration;
        if (set % 3 == 2) bounds.slope = bounds.acceleration + word(4);
        bounds.slope &= (int64_t{1} << 33) - 1;
        const bool obeyed = hls::TimeScaler::fits(bounds.acceleration, bounds.slope);
        possible += obeyed ? 1 : 0;
        start(bounds);
        int32_t target = 0;
        const auto every = static_cast<unsigned>(1 + random_() % 200);
        for (int n = 0; n < 700 / kFewer; ++n) {
            if (n == 0 || random_() % every == 0) target = obeyed ? any_target() : 0;
            take(target);
        }
        ASSERT_FALSE(HasFatalFailure())
            << "acceleration " << bounds.acceleration << " slope " << bounds.slope;
    }
    EXPECT_GT(possible, 800);
    EXPECT_LT(possible, 1800);
}

INSTANTIATE_TEST_SUITE_P(Machines, TimeScaler,
                         testing::Values(Bounds{1 << 16, 1 << 24}, Bounds{1000, 1000 * 4000},
                                         Bounds{1 << 22, 1 << 26}, Bounds{77777, 77777},
                                         Bounds{int64_t{1} << 31, int64_t{1} << 32},
                                         Bounds{(1 << 20) + 12345, 16LL * ((1 << 20) + 12345)},
                                         Bounds{200000, 2000001}, Bounds{200000, 2199999},
                                         Bounds{8, int64_t{1} << 32}),
                         [](const auto& bounds) {
                             return "accel_" + std::to_string(bounds.param.acceleration) +
                                    "_slope_" + std::to_string(bounds.param.slope);
                         });

}  // namespace
}  // namespace curvecore::tb
