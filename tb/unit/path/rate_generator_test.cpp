// SPDX-License-Identifier: Apache-2.0
// rtl/time/rate_generator.sv against TimeScaler: rates of ticks under any settings, and its
// reports. The bench is the path side: it takes rates, sends samples, lets them leave.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vrate_generator.h"
#include "hls/path_kernel.hpp"
#include "hls/time_scaler.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

struct Settings {
    int64_t acceleration = 1 << 20;
    int64_t slope = 1 << 26;
    int64_t stop_ticks = 100;
    int samples_log2 = 0;
};

bool fits(const Settings& settings) {
    return hls::TimeScaler::fits(settings.acceleration, settings.slope) &&
           settings.stop_ticks >= 1 && settings.stop_ticks < int64_t{1} << 29;
}

class RateGenerator : public testing::Test {
  protected:
    RateGenerator() {
        dut_->active_i = 0;
        dut_->queued_i = 0;
        dut_->request_valid_i = 0;
        dut_->kill_i = 0;
        dut_->hold_i = 0;
        dut_->underrun_i = 0;
        dut_->override_i = 65536;
        dut_->rate_ready_i = 0;
        dut_->tick_taken_i = 0;
        dut_->sent_i = 0;
        dut_->leaves_i = 0;
        dut_->due_i = 0;
        dut_->step_valid_i = 0;
        ask(settings_);
        dut_.reset();
        stop_ticks_ = dut_->stop_ticks_o;
    }

    void ask(const Settings& settings) {
        settings_ = settings;
        dut_->hold_acceleration_i = to_port(settings.acceleration, 32);
        dut_->hold_slope_i = to_port(settings.slope, 33);
        dut_->stop_ticks_i = to_port(settings.stop_ticks, 32);
        dut_->samples_per_tick_log2_i = to_port(settings.samples_log2, 4);
    }

    /// Advances by one clock, with a request or without.
    void clock(bool request) {
        if (took_) idle_ticks_ = dut_->active_i ? 0 : std::min(idle_ticks_ + 1, hls::kIdleTicks);
        dut_->request_valid_i = request;
        dut_->rate_ready_i = go();
        dut_->tick_taken_i = !taken_.empty() && go();
        // A sample of the present tick is sent, and a sent one leaves.
        dut_->sent_i = dut_->wanted_o && ticks_taken_ > 0 && sent_ - left_ < 300 && go();
        dut_->leaves_i = sent_ > left_ && go();
        dut_.settle();
        if (dut_->stop_ticks_o != stop_ticks_) begin_anew();
        // A tick is reported two clocks after its request.
        if (dut_->standing_o) stands_until_ = asked_before_[1];
        asked_before_ = {asked_, asked_before_[0]};
        if (request && dut_->request_ready_o) admit();
        took_ = dut_->tick_taken_i != 0;
        const bool active = took_ ? take() : dut_->active_i != 0;
        if (dut_->rate_valid_o && dut_->rate_ready_i) compare();
        if (dut_->sent_i) send();
        if (dut_->leaves_i) ++left_;
        dut_.tick();
        dut_->active_i = active;
    }

    /// The path takes a tick. Returns true if a program is under way.
    bool take() {
        const Tick tick = taken_.front();
        taken_.pop_front();
        ++ticks_taken_;
        const bool before = dut_->active_i != 0;
        const bool landed = kernel_.lands(tick.target, idle_ticks_ == hls::kIdleTicks);
        EXPECT_EQ(tick.rate, kernel_.tick(tick.target, idle_ticks_ == hls::kIdleTicks))
            << "tick " << compared_;
        EXPECT_FALSE(landed && before && begins_) << "it lands in motion";
        const bool ends = before && chance(end_percent_);
        const bool active =
            !ends && (before || (begins_ && tick.target != 0 && chance(begin_percent_)));
        if (active && !before && idle_ticks_ == hls::kIdleTicks) {
            EXPECT_EQ(tick.rate, tick.target) << "a program begins at another rate";
            begun_ += tick.target != tick.asked_before ? 1 : 0;
        }
        if (active && tick.rate != 0) {
            EXPECT_GE(tick.sample, stands_until_) << "it moves on its way, and is said to stand";
            moves_until_ = tick.sample + (1 << taken_settings_.samples_log2);
        }
        return active;
    }

    /// Notes that the settings were taken: stop_ticks_i shows it, as it differs each time.
    void begin_anew() {
        stop_ticks_ = dut_->stop_ticks_o;
        EXPECT_EQ(asked_, sent_) << "they were taken while samples were under way";
        EXPECT_EQ(index_, 0);
        taken_settings_ = settings_;
        idle_ticks_ = hls::kIdleTicks;  // nothing is under way
        kernel_ = hls::TimeScaler(settings_.acceleration, settings_.slope);
    }

    void admit() {
        if (index_ == 0) {
            const bool stops = dut_->kill_i || dut_->killed_o || dut_->hold_i || dut_->underrun_i ||
                               !fits(taken_settings_);
            const int32_t target =
                stops ? 0 : std::min(static_cast<int32_t>(dut_->override_i), 65536);
            if (target != 0) ++free_ticks_;
            expected_.push_back({0, target, last_target_, asked_});
            last_target_ = target;
        }
        index_ = (index_ + 1) & ((1 << taken_settings_.samples_log2) - 1);
        ++asked_;
    }

    void compare() {
        ASSERT_FALSE(expected_.empty()) << "a rate that nobody asked for";
        Tick tick = expected_.front();
        expected_.pop_front();
        tick.rate = static_cast<int32_t>(dut_->rate_o);
        ASSERT_EQ(dut_->held_o != 0, tick.target == 0) << "tick " << compared_;
        taken_.push_back(tick);
        ++compared_;
    }

    void send() {
        ++sent_;
        if (++sent_of_tick_ == 1 << taken_settings_.samples_log2) {
            sent_of_tick_ = 0;
            --ticks_taken_;
        }
    }

    void run(int clocks, int request_percent = 100) {
        for (int n = 0; n < clocks && !HasFatalFailure(); ++n) {
            clock(static_cast<int>(random_() % 100) < request_percent);
        }
    }

    /// Requests the rest of a tick, until nothing is under way.
    void drain() {
        while (!HasFatalFailure() && (index_ != 0 || left_ < asked_)) clock(index_ != 0);
        run(8, 0);
    }

    int32_t any_override() {
        const uint64_t kind = random_() % 4;
        return kind == 0 ? 0 : kind == 1 ? 65536 : static_cast<int32_t>(random_() % 70000);
    }

    int64_t word(int bits) {
        return static_cast<int64_t>(random_() >> (64 - bits) >> (random_() % bits));
    }

    Settings any_settings() {
        Settings any{word(32), word(33), word(32), static_cast<int>(random_() % 4)};
        if (random_() % 3 == 0) any.slope = any.acceleration + word(4);
        if (random_() % 3 == 0) any.stop_ticks = 1 + word(28);
        // Each setting differs from those before.
        if (any.stop_ticks == settings_.stop_ticks) ++any.stop_ticks;
        any.slope &= (int64_t{1} << 33) - 1;
        any.stop_ticks &= (int64_t{1} << 32) - 1;
        return any;
    }

    bool go() { return !stalls_ || random_() % 4 != 0; }
    bool chance(unsigned percent) { return percent == 100 || random_() % 100 < percent; }

    struct Tick {
        int32_t rate;
        int32_t target;
        int32_t asked_before;  // target of the tick before
        int64_t sample;        // its first sample
    };

    ClockedDut<Vrate_generator> dut_;
    Settings settings_;
    Settings taken_settings_;
    uint32_t stop_ticks_ = 0;
    hls::TimeScaler kernel_{settings_.acceleration, settings_.slope};
    bool stalls_ = false;
    bool begins_ = false;           // programs begin in ticks that are not held
    unsigned begin_percent_ = 100;  // percentage of these
    unsigned end_percent_ = 0;      // percentage of a program's ticks that are its last
    int idle_ticks_ = hls::kIdleTicks;
    bool took_ = false;  // a tick was taken in the clock before
    int64_t begun_ = 0;  // programs at another rate than the tick before was due to have
    int32_t last_target_ = 0;
    std::mt19937_64 random_{1};
    int index_ = 0;  // index of the next sample in its tick
    std::deque<Tick> expected_;
    std::deque<Tick> taken_;
    int64_t ticks_taken_ = 0;
    int64_t compared_ = 0;
    int64_t free_ticks_ = 0;
    int sent_of_tick_ = 0;
    int64_t asked_ = 0;
    int64_t sent_ = 0;
    int64_t left_ = 0;
    std::array<int64_t, 2> asked_before_{};
    int64_t stands_until_ = 0;
    int64_t moves_until_ = 0;
};

TEST_F(RateGenerator, EqualsKernelUnderAnySettings) {
    int obeyed = 0;
    while (compared_ < 1'000'000) {
        stalls_ = random_() % 2 == 0;
        begins_ = random_() % 8 != 0;
        const auto every = static_cast<unsigned>(1 + random_() % 300);
        const int requests = random_() % 2 == 0 ? 100 : 30;
        for (int n = 0; n < 1500; ++n) {
            if (random_() % every == 0) dut_->override_i = to_port(any_override(), 17);
            if (random_() % every == 0) dut_->hold_i = random_() % 2;
            run(1, requests);
        }
        ASSERT_FALSE(HasFatalFailure())
            << "acceleration " << taken_settings_.acceleration << " slope " << taken_settings_.slope
            << " stop ticks " << taken_settings_.stop_ticks;
        obeyed += fits(taken_settings_) ? 1 : 0;
        begins_ = false;
        dut_->active_i = 0;
        // New settings come in a pause or while requests continue.
        if (random_() % 2 == 0) drain();
        const int64_t taken = stop_ticks_;
        ask(any_settings());
        for (int n = 0; n < 4000 && stop_ticks_ == taken; ++n) run(1, 100);
        ASSERT_EQ(stop_ticks_, settings_.stop_ticks) << "they are not taken";
    }
    EXPECT_GT(obeyed, 100);
    EXPECT_GT(free_ticks_, 100'000);
    EXPECT_FALSE(dut_->settings_fault_o) << "no program ever waited";
}

/// Programs begin and end at any time; overrides and holds come within and between them.
TEST_F(RateGenerator, WhileNothingIsUnderWayTheRateIsTheTargetAtOnce) {
    begins_ = true;
    for (int round = 0; round < 400 && !HasFailure(); ++round) {
        stalls_ = random_() % 2 == 0;
        end_percent_ = round % 3 == 0 ? 20 : 1;
        const auto every = static_cast<unsigned>(1 + random_() % 300);
        const int requests = round % 4 == 0 ? 100 : round % 4 == 1 ? 30 : 3;
        for (int n = 0; n < 2000 && !HasFailure(); ++n) {
            // Programs with and without pauses between them.
            if (n % 500 == 0) begin_percent_ = random_() % 2 == 0 ? 100 : random_() % 8;
            if (random_() % every == 0) dut_->override_i = to_port(any_override(), 17);
            if (random_() % every == 0) dut_->hold_i = random_() % 2;
            run(1, requests);
        }
    }
    EXPECT_GT(begun_, 50);
}

TEST_F(RateGenerator, ReportsSettingsThatCannotBeWhenAProgramWaits) {
    const int64_t most = int64_t{1} << 31;
    const std::vector<std::pair<Settings, bool>> cases = {
        {{8, 8, 1, 0}, true},
        {{most, 2 * most, (1 << 29) - 1, 3}, true},
        {{200000, 2000001, 500, 0}, true},
        {{7, 8, 1, 0}, false},
        {{0, 1, 1, 0}, false},
        {{0, 0, 1, 0}, false},
        {{most + 1, 2 * most, 1, 0}, false},
        {{2 * most - 1, 2 * most, 1, 0}, false},
        {{9, 8, 1, 0}, false},
        {{9, 0, 1, 0}, false},
        {{9, 2 * most + 1, 1, 0}, false},
        {{9, 4 * most - 1, 1, 0}, false},
        {{9, 9, 0, 0}, false},
        {{9, 9, 1 << 29, 0}, false},
        {{9, 9, 2 * most - 1, 0}, false},
    };
    for (const auto& [settings, good] : cases) {
        ask(settings);
        dut_.reset();
        const std::string name = "acceleration " + std::to_string(settings.acceleration) +
                                 " slope " + std::to_string(settings.slope) + " stop ticks " +
                                 std::to_string(settings.stop_ticks);
        dut_->queued_i = 0;
        for (int n = 0; n < 20; ++n) dut_.tick();
        EXPECT_FALSE(dut_->settings_fault_o) << name << ": nothing waits yet";
        dut_->queued_i = 1;
        for (int n = 0; n < 4; ++n) dut_.tick();
        EXPECT_EQ(dut_->settings_fault_o != 0, !good) << name;
        ask({1 << 20, 1 << 26, 100, 0});
        for (int n = 0; n < 20; ++n) dut_.tick();
        EXPECT_EQ(dut_->settings_fault_o != 0, !good) << name << ": it is sticky";
    }
}

TEST_F(RateGenerator, AChangeWhileAProgramIsUnderWayIsReportedAndNotObeyed) {
    const Settings before = settings_;
    for (int which = 0; which < 4; ++which) {
        ask(before);
        run(20, 100);
        dut_->active_i = 1;
        run(100, 100);
        EXPECT_FALSE(dut_->settings_fault_o);
        Settings after = before;
        if (which == 0) after.acceleration += 1;
        if (which == 1) after.slope += 1;
        if (which == 2) after.stop_ticks += 1;
        if (which == 3) after.samples_log2 += 1;
        ask(after);
        for (int n = 0; n < 500; ++n) {
            dut_->hold_i = n / 100 % 2;
            run(1, 100);  // equals the kernel of those before
        }
        EXPECT_TRUE(dut_->settings_fault_o) << which;
        EXPECT_EQ(dut_->stop_ticks_o, before.stop_ticks) << which;
        EXPECT_EQ(dut_->samples_per_tick_log2_o, before.samples_log2) << which;
        dut_->active_i = 0;
        dut_->hold_i = 0;
        drain();
        EXPECT_EQ(dut_->samples_per_tick_log2_o, after.samples_log2) << which;
        EXPECT_TRUE(dut_->settings_fault_o) << which;
        // A fresh start.
        ask(before);
        dut_.reset();
        taken_settings_ = before;
        kernel_ = hls::TimeScaler(before.acceleration, before.slope);
        ASSERT_FALSE(HasFatalFailure()) << which;
    }
}

TEST_F(RateGenerator, TellsWhenTheMachineStands) {
    ask({1 << 22, 40 << 22, 99, 2});
    run(10, 0);
    EXPECT_TRUE(dut_->standing_o);
    int most_idle = 0;
    for (int round = 0; round < 200 && !HasFatalFailure(); ++round) {
        stalls_ = round % 2 == 1;
        begins_ = round % 7 != 0;
        dut_->active_i = 0;
        dut_->hold_i = 0;
        dut_->override_i = 65536;
        // Runs as short as a tick, or up to full rate.
        run(round % 3 == 0 ? static_cast<int>(random_() % 20) : 4000, 100);
        if (round % 4 == 0) dut_->override_i = 0;
        if (round % 4 != 0) dut_->hold_i = 1;
        run(3, 100);
        int clocks = 0;
        for (; clocks < 20000 && !dut_->standing_o; ++clocks) run(1, 100);
        ASSERT_TRUE(dut_->standing_o) << "round " << round;
        if (!begins_) most_idle = std::max(most_idle, clocks);
        EXPECT_GE(left_, moves_until_) << "round " << round;
        run(round % 5 * 100, 100);
        EXPECT_TRUE(dut_->standing_o);
    }
    EXPECT_LT(most_idle, 1000) << "with no program under way time need not come to rest";
}

}  // namespace
}  // namespace curvecore::tb
