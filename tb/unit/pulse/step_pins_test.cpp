// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/step_generator.sv as a drive sees it: monitors of the pins against exact crossings.
// CURVECORE_STEPS sets the number of steps (scripts/campaign.sh).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "tb/support/pins/step_bench.hpp"
#include "tb/support/pins/step_motion.hpp"
#include "tb/support/pins/watched_axis.hpp"

namespace curvecore::tb {
namespace {

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

    /// Draws one machine's motion from its reference to its last step.
    void draw(int samples) {
        const hls::PulseTimes times = any_times();
        // Speed: the fastest that the pulses allow, or slower.
        const double most = 0.49 * 2 / (times.steplen + times.stepspace) *
                            std::exp2(-static_cast<int>(random_() % 3)) * kPeriod;
        axes_.clear();
        motions_.clear();
        bench_.reset();
        bench_.set_times(times);
        for (int a = 0; a < kStepAxes; ++a) {
            motions_.emplace_back(random_, kFineBits, kMotionScaleBits, most);
            axes_.emplace_back(motions_[a].scale(), kFineBits, kPeriod, times);
            bench_.set_scale(a, motions_[a].scale());
        }
        bench_.reference();
        std::vector<int64_t> position(kStepAxes);
        for (int a = 0; a < kStepAxes; ++a) {
            position[a] = motions_[a].position();
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
                for (int a = 0; a < kStepAxes; ++a) position[a] = motions_[a].next(random_);
            }
            // At the end the motion stands until all steps are out, and slightly longer.
            if (n > samples + 4 && (idle() || n > samples + 60000 / static_cast<int>(kPeriod)))
                break;
            bench_.offer(position);
        }
        for (int a = 0; a < kStepAxes; ++a) finish(a);
        ASSERT_EQ(bench_.late(), 0);
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
    std::vector<StepMotion> motions_;
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
    const int64_t enough = asked != nullptr ? std::atoll(asked) : 500'000;
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
