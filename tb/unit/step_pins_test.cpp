// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/step_generator.sv as a drive sees it: monitors of the pins against exact crossings.
// CURVECORE_STEPS says how many steps (scripts/campaign.sh).
#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>
#include <memory>
#include <random>

#include "ref/pulse/step_crossings.hpp"
#include "tb/support/pulse_monitor.hpp"
#include "tb/support/step_bench.hpp"
#include "tb/support/step_motion.hpp"

namespace curvecore::tb {
namespace {

/// Places in 2^-16 step.
const ref::StepCrossings kPlaces(1, int64_t{1} << hls::kStepFraction);

struct DueStep {
    int64_t clock;
    bool back;
};

/// One axis: what is due by its places, and what its pins give.
class WatchedAxis {
  public:
    WatchedAxis(const StepMotion& steps, const hls::PulseTimes& times)
        : motion(steps), monitor_(times), times_(times) {}

    void stands_at(int64_t position) { place_ = place_of(position); }

    /// A period begins, whose first clock reaches the pins after `start`.
    void moves_to(int64_t position, int64_t start) {
        const int64_t place = place_of(position);
        kPlaces.between(place_, place, [&](const ref::StepCrossing& crossing) {
            due_.push_back({start + crossing.clock(kPeriod), crossing.back});
        });
        place_ = place;
    }

    void watch(int64_t clock, bool step, bool direction) {
        const int64_t before = monitor_.rise();
        const bool rises = monitor_.watch(clock, step, direction);
        ASSERT_EQ(monitor_.complaint(), "");
        if (!rises) return;
        ASSERT_FALSE(due_.empty()) << "a step that is not due";
        const DueStep due = due_.front();
        due_.pop_front();
        ASSERT_EQ(due.back, direction) << "a step in the wrong direction";
        // Each goes out in the first clock that the drive's times allow.
        const int64_t possible =
            std::max(before + std::max(times_.steplen, 1) + std::max(times_.stepspace, 1),
                     monitor_.turn() + std::max(times_.dirsetup, 1));
        ASSERT_EQ(clock, std::max(due.clock, possible));
        if (possible <= due.clock) ++free_;
    }

    /// Steps wait that one turn, and 7 each way, cannot hold: an overrun is what must be reported.
    /// It is decided two clocks before the step could go out, and seen one clock later.
    bool overruns(int64_t clock) const {
        bool pin = monitor_.direction();
        int waiting[2] = {0, 0};
        if (monitor_.rise() == clock) ++waiting[pin];
        if (monitor_.turn() == clock) pin = !pin;
        for (const DueStep& due : due_) {
            if (due.clock > clock + 1) break;
            const bool returns = due.back == pin && waiting[!pin] > 0;
            if (returns || ++waiting[due.back] > hls::StepPulse::kMostWaiting) return true;
        }
        return false;
    }

    bool idle() const { return due_.empty(); }
    int64_t free_steps() const { return free_; }
    const PulseMonitor& monitor() const { return monitor_; }

    StepMotion motion;

  private:
    int64_t place_of(int64_t position) const {
        return exact_place(position, motion.scale(), kFineBits);
    }

    PulseMonitor monitor_;
    hls::PulseTimes times_;
    int64_t place_ = 0;
    std::deque<DueStep> due_;
    int64_t free_ = 0;
};

class StepPins : public testing::Test {
  protected:
    hls::PulseTimes any_times() {
        const auto any = [this](int most) {
            return std::min(1 + static_cast<int>(random_() % most), kMostTime);
        };
        const int turn = random_() % 16 == 0 ? 2000 : random_() % 3 == 0 ? 40 : 6;
        if (random_() % 3 == 0) return {1, 1, any(turn), any(turn)};
        return {any(8), any(8), any(turn), any(turn)};
    }

    /// One machine from its reference to its last step.
    void draw(int samples) {
        const hls::PulseTimes times = any_times();
        // The fastest that the pulses allow, or slower.
        const double most = 0.49 * 2 / (times.steplen + times.stepspace) *
                            std::exp2(-static_cast<int>(random_() % 3)) * kPeriod;
        axes_.clear();
        bench_.reset();
        bench_.set_times(times);
        for (int a = 0; a < kStepAxes; ++a) {
            axes_.emplace_back(StepMotion(random_, kFineBits, kMotionScaleBits, most), times);
            bench_.set_scale(a, axes_[a].motion.scale());
        }
        bench_.reference();
        std::vector<int64_t> position(kStepAxes);
        for (int a = 0; a < kStepAxes; ++a) {
            position[a] = axes_[a].motion.position();
            axes_[a].stands_at(position[a]);
        }
        flagged_ = 0;
        bool moves = false;  // a sample waits for its tick
        std::vector<int64_t> taken;
        bench_.offer(position);
        for (int n = 0; !HasFatalFailure();) {
            const int64_t ticked = bench_.ticked();
            const bool takes = bench_.clock();
            if (bench_.ticked() != ticked && moves) {
                moves = false;
                for (int a = 0; a < kStepAxes; ++a) {
                    axes_[a].moves_to(taken[a], bench_.ticked() + kLatency + a);
                }
            }
            watch();
            if (!takes) continue;
            taken = position;
            moves = true;
            if (++n < samples) {
                for (int a = 0; a < kStepAxes; ++a) position[a] = axes_[a].motion.next(random_);
            }
            // At last it stands until all is out, and a bit longer.
            if (n > samples + 4 && (idle() || n > samples + 60000 / static_cast<int>(kPeriod)))
                break;
            bench_.offer(position);
        }
        for (int a = 0; a < kStepAxes; ++a) finish(a);
        ASSERT_EQ(bench_->late_o, 0);
        ASSERT_EQ(bench_->refused_o, 0);
        ASSERT_EQ(bench_->uncertain_o, 0);
    }

    void watch() {
        for (int a = 0; a < kStepAxes; ++a) {
            if (flagged_ >> a & 1) continue;
            axes_[a].watch(bench_.now(), bench_.step(a), bench_.direction(a));
            if (bench_->overrun_o >> a & 1) {
                EXPECT_TRUE(axes_[a].overruns(bench_.now())) << "axis " << a << ": it could wait";
                flagged_ |= 1 << a;
            }
            ASSERT_FALSE(HasFatalFailure()) << "axis " << a << " clock " << bench_.now();
        }
    }

    bool idle() const {
        bool all = true;
        for (int a = 0; a < kStepAxes; ++a) all &= (flagged_ >> a & 1) != 0 || axes_[a].idle();
        return all;
    }

    void finish(int a) {
        const PulseMonitor& monitor = axes_[a].monitor();
        steps_ += monitor.steps();
        turns_ += monitor.turns();
        free_ += axes_[a].free_steps();
        ++drawn_;
        if (flagged_ >> a & 1) {
            ++overruns_;
        } else {
            ASSERT_TRUE(axes_[a].idle()) << "axis " << a << ": steps are lost";
        }
    }

    StepBench bench_;
    std::mt19937_64 random_{1};
    std::vector<WatchedAxis> axes_;
    int flagged_ = 0;  // axes with an overrun
    int64_t steps_ = 0;
    int64_t turns_ = 0;
    int64_t free_ = 0;
    int64_t drawn_ = 0;
    int64_t overruns_ = 0;
};

TEST_F(StepPins, GiveEveryStepOnceInOrderInTheFirstClockThatTheDriveAllows) {
    const char* asked = std::getenv("CURVECORE_STEPS");
    const int64_t enough = asked != nullptr ? std::atoll(asked) : 1'000'000;
    while (steps_ < enough) {
        draw(static_cast<int>(std::max<int64_t>(20, 20000 / kPeriod)));
        ASSERT_FALSE(HasFatalFailure()) << "machine " << drawn_ / kStepAxes;
    }
    printf("%ld steps, %ld turns, %ld steps with nothing in their way; %ld of %ld axes overrun\n",
           steps_, turns_, free_, overruns_, drawn_);
    EXPECT_GT(turns_, steps_ / 2000);
    EXPECT_GT(free_, steps_ / 4);
    EXPECT_LT(overruns_, drawn_ / 3);
}

}  // namespace
}  // namespace curvecore::tb
