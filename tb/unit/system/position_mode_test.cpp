// SPDX-License-Identifier: Apache-2.0
// rtl/motion_system.sv in position mode: samples of the host move the axes, as the kernel of the
// step generator does clock by clock; hosts that are late, gone, too fast or wrong.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "hls/step_generator.hpp"
#include "hls/xy2_frame.hpp"
#include "tb/support/bench/register_host.hpp"

namespace curvecore::tb {
namespace {

constexpr uint32_t kPosition = kEnable | CURVECORE_CONTROL_POSITION_MASK;
constexpr int kMostSamples = CFG_SampleBufferWords / kSystemAxes;
/// Units of a step: a position is in 2^-8 step; 2^32 of them are 2^40 of 2^-16 step.
constexpr int kUnitsPerStep = 256;
constexpr int64_t kScale = int64_t{1} << 40;
constexpr int kGuardBits = 10;
/// Number of samples from a taken one to its last step.
constexpr int kWay = 4;

using Sample = std::array<int32_t, kSystemAxes>;

class PositionMode : public testing::Test {
  protected:
    /// Turns the drives on; every axis is where the first sample says.
    void begin(uint32_t control = kPosition, int64_t scale = kScale) {
        for (uint32_t a = 0; a < kSystemAxes; ++a) {
            const uint32_t axis = a * CURVECORE_AXIS_STRIDE;
            EXPECT_TRUE(host_.write(CURVECORE_AXIS_SCALE_LO + axis, 0));
            EXPECT_TRUE(
                host_.write(CURVECORE_AXIS_SCALE_HI + axis, static_cast<uint32_t>(scale >> 32)));
        }
        host_.write(CURVECORE_PULSE, 2 | 2 << 16);
        host_.write(CURVECORE_DIRECTION, 4 | 4 << 16);
        EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
        EXPECT_TRUE(host_.write(CURVECORE_CONTROL, control));
    }

    /// Pushes a sample. Returns true if all of its positions were taken.
    bool push(const Sample& sample) {
        int taken = 0;
        for (const int32_t position : sample) {
            taken += host_.write(CURVECORE_SAMPLE, static_cast<uint32_t>(position)) ? 1 : 0;
        }
        EXPECT_TRUE(taken == 0 || taken == kSystemAxes);
        return taken > 0;
    }
    bool push(int32_t steps) {
        Sample sample;
        sample.fill(steps * kUnitsPerStep);
        return push(sample);
    }
    uint32_t room() { return host_.read(CURVECORE_SAMPLES) & CURVECORE_SAMPLES_ROOM_MASK; }
    uint32_t queued() { return host_.read(CURVECORE_SAMPLES) >> CURVECORE_SAMPLES_QUEUED_LOW; }
    void run_out() {
        while (queued() > 0 && !HasFailure()) host_.samples(1);
        host_.samples(kWay);
    }
    void expect_counts(int64_t steps) {
        for (int a = 0; a < kSystemAxes; ++a) {
            EXPECT_EQ(host_.drive(a).count(), steps) << "axis " << a;
            EXPECT_EQ(host_.drive(a).complaint(), "") << "axis " << a;
        }
    }
    uint32_t faults() { return host_.state() & kFaults; }
    void clear_faults() { host_.write(CURVECORE_STATE, kFaults); }

    std::mt19937 random_{1};
    RegisterHost host_;
};

TEST_F(PositionMode, SaysHowManySamplesItHolds) {
    const uint32_t capability = host_.read(CURVECORE_CAPABILITY);
    EXPECT_EQ(1U << ((capability & CURVECORE_CAPABILITY_SAMPLE_BUFFER_LOG2_MASK) >>
                     CURVECORE_CAPABILITY_SAMPLE_BUFFER_LOG2_LOW),
              uint32_t{CFG_SampleBufferWords});
    EXPECT_EQ(room(), uint32_t{kMostSamples});
    EXPECT_EQ(queued(), 0U);
}

/// Random walks, pushed at random times but never late.
TEST_F(PositionMode, GivesTheStepsOfItsSamplesClockByClock) {
    hls::StepGenerator kernel(kSystemAxes, kFineBits, CFG_PeriodLog2);
    kernel.set_times({2, 2, 4, 4});
    for (int a = 0; a < kSystemAxes; ++a) {
        kernel.set_scale(a, kScale);
        kernel.stop(a, false);
        kernel.reference(a);
    }
    std::deque<Sample> samples;  // samples that the kernel has not taken yet
    int64_t begins = std::numeric_limits<int64_t>::max();  // clock from which on they are taken
    int64_t differ = 0;
    host_.each_clock = [&] {
        kernel.clock();
        // Once in each period, far from its tick.
        if (host_.now() >= begins && host_.now() % kSystemPeriod == kSystemPeriod - 8) {
            ASSERT_FALSE(samples.empty());
            int64_t fine[kSystemAxes];
            for (int a = 0; a < kSystemAxes; ++a) {
                fine[a] = int64_t{samples.front()[a]} * (1 << kGuardBits);
            }
            kernel.sample(fine);
            samples.pop_front();
        }
        for (int a = 0; a < kSystemAxes; ++a) {
            const hls::StepPulse& pulse = kernel.axis(a).pulse();
            differ += (host_->step_o >> a & 1) != pulse.step() ? 1 : 0;
            differ += (host_->direction_o >> a & 1) != pulse.direction() ? 1 : 0;
        }
    };
    begin();
    Sample place{0, 5 * kUnitsPerStep, -7 * kUnitsPerStep};
    Sample speed{};
    // The first sample is taken in the period in which it comes.
    while (host_.now() % kSystemPeriod != 0) host_.clock();
    for (int n = 0; n < 4000 && !HasFailure(); ++n) {
        while (room() == 0) host_.clocks(50);
        samples.push_back(place);
        ASSERT_TRUE(push(place));
        if (n == 0) begins = host_.now();
        if (samples.size() > 20) host_.clocks(random_() % 800);
        for (int a = 0; a < kSystemAxes; ++a) {
            speed[a] += static_cast<int32_t>(random_() % 1001) - 500;
            speed[a] = std::min(std::max(speed[a], -8000), 8000);
            place[a] += speed[a];
        }
    }
    EXPECT_EQ(differ, 0);
    EXPECT_EQ(faults(), 0U);
    host_.each_clock = nullptr;
    int64_t steps = 0;
    for (int a = 0; a < kSystemAxes; ++a) steps += host_.drive(a).steps();
    EXPECT_GT(steps, 50'000);
}

/// Scan heads follow whole samples, in order, with nothing between them.
TEST_F(PositionMode, ScanHeadsFollowItsSamples) {
    if (CFG_Galvo != 1) GTEST_SKIP() << "no scan heads";
    using Frame = std::array<uint32_t, 3>;
    std::vector<Frame> seen;
    std::vector<Frame> wanted;
    const auto add = [](const Frame& frame, std::vector<Frame>& frames) {
        if (frames.empty() || frames.back() != frame) frames.push_back(frame);
    };
    begin(kPosition, kScale >> 6);  // a sample may change all bits of a frame
    host_.samples(3);
    host_.each_clock = [&] {
        add({host_.galvo_frame(0), host_.galvo_frame(1), host_.galvo_frame(2)}, seen);
    };
    Sample place{};
    for (int n = 0; n < 1000 && !HasFailure(); ++n) {
        while (room() == 0) host_.clocks(50);
        ASSERT_TRUE(push(place));
        Frame frame;
        for (int a = 0; a < 3; ++a) {
            frame[a] = hls::xy2_frame(int64_t{place[a]} * (1 << kGuardBits), kFineBits);
            place[a] += static_cast<int32_t>(random_() % (1 << 21)) - (1 << 20);
        }
        add(frame, wanted);
        host_.clocks(random_() % 400);
    }
    run_out();
    EXPECT_GT(wanted.size(), 990U);
    EXPECT_EQ(seen, wanted);
    EXPECT_EQ(faults() & ~uint32_t{CURVECORE_STATE_LATE_MASK}, 0U);
}

TEST_F(PositionMode, AxesWaitForALateHostAndLoseNothing) {
    begin();
    for (int n = 0; n <= 10; ++n) push(3 * n);
    run_out();
    EXPECT_EQ(faults(), uint32_t{CURVECORE_STATE_LATE_MASK});
    EXPECT_TRUE(host_.is(CURVECORE_STATE_ENABLED_MASK));
    expect_counts(30);
    clear_faults();
    host_.samples(50);
    EXPECT_EQ(faults(), 0U) << "it stands";
    expect_counts(30);
    for (int n = 11; n <= 20; ++n) push(3 * n);
    run_out();
    EXPECT_EQ(faults(), uint32_t{CURVECORE_STATE_LATE_MASK}) << "every time";
    clear_faults();
    for (int n = 0; n < 3; ++n) push(60);
    run_out();
    EXPECT_EQ(faults(), 0U) << "it stood";
    expect_counts(60);
}

TEST_F(PositionMode, WhereThereIsNoRoomAWholeSampleIsRefused) {
    begin();
    int taken = 0;
    int refused = 0;
    for (int n = 0; n < 3000 && !HasFailure(); ++n) {
        // Interchanged axes would be too fast.
        Sample next;
        for (int a = 0; a < kSystemAxes; ++a) {
            next[a] = kUnitsPerStep * (taken + 100'000 * a);
        }
        const bool good = push(next);
        taken += good ? 1 : 0;
        refused += good ? 0 : 1;
        EXPECT_LE(queued(), uint32_t{kMostSamples});
    }
    EXPECT_GT(refused, 1000);
    EXPECT_EQ(faults(), uint32_t{CURVECORE_STATE_BUS_MASK});
    run_out();
    expect_counts(taken - 1);
}

TEST_F(PositionMode, ProgramsAndSamplesExcludeEachOther) {
    EXPECT_FALSE(push(0)) << "it is off";
    begin(kEnable);
    EXPECT_FALSE(push(0)) << "not in position mode";
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kPosition));
    EXPECT_FALSE(host_.push(CURVECORE_SEGMENT_LO, 0));
    EXPECT_FALSE(host_.push(CURVECORE_PROFILE_LO, 0));
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kEnable)) << "nothing came";
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kPosition));
    EXPECT_TRUE(push(0));
    EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kEnable));
    EXPECT_FALSE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
    host_.samples(kWay);
    EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kEnable)) << "a flush is needed";
    EXPECT_TRUE(push(0));
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, 0)) << "off is never refused";
}

TEST_F(PositionMode, AFlushLetsSamplesRunOutAndAProgramMayFollow) {
    begin();
    for (int n = 0; n < 30; ++n) push(n);
    push(29);
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kPosition | kFlush));
    EXPECT_FALSE(push(30));
    while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
    host_.samples(kWay);
    expect_counts(29);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_READY_MASK)) << "positions are kept";
    EXPECT_EQ(room(), uint32_t{kMostSamples});
    EXPECT_TRUE(push(31)) << "and it goes on";
    host_.samples(kWay);
    expect_counts(31);
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kPosition | kFlush));
    host_.clocks(8);
    host_.write(CURVECORE_CONTROL, 0);
    clear_faults();
    const Part part("pulses.ngc", ref::Holds::kBranches);
    host_.prepare(part);
    host_.draw(part);
    EXPECT_EQ(faults(), 0U);
    for (int a = 0; a < kSystemAxes; ++a) {
        EXPECT_EQ(host_.drive(a).count(), 31 + part.end(a)) << "axis " << a;
    }
}

TEST_F(PositionMode, AHostThatIsGoneTurnsItOff) {
    begin();
    host_.write(CURVECORE_WATCHDOG, 100);
    for (int n = 0; n < 40; ++n) push(n);
    for (int n = 0; n < 95; ++n) {
        host_.samples(1);
        host_.state();  // any program may read it
    }
    EXPECT_TRUE(host_->enable_o);
    host_.samples(10);
    EXPECT_FALSE(host_->enable_o);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_WATCHDOG_MASK));
    expect_counts(39);
    EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kPosition)) << "the fault stands";
    clear_faults();
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kPosition));
    EXPECT_FALSE(push(40)) << "references are lost";
    EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
    push(1000);
    push(1001);
    run_out();
    expect_counts(40);
}

TEST_F(PositionMode, StopsForgetWhatWaits) {
    begin();
    for (int n = 0; n < 40; ++n) push(n);
    host_.write(CURVECORE_SAMPLE, 0);  // a part of a sample
    host_->estop_i = 1;
    host_.clocks(4);
    EXPECT_FALSE(host_->enable_o);
    host_->estop_i = 0;
    host_.samples(2);
    const int64_t stands = host_.drive(0).count();
    EXPECT_LT(stands, 39);
    EXPECT_EQ(queued(), 0U);
    EXPECT_EQ(room(), uint32_t{kMostSamples});
    clear_faults();
    begin();
    push(500);
    push(503);
    run_out();
    EXPECT_EQ(host_.drive(0).count(), stands + 3);
    EXPECT_EQ(host_.drive(2).count(), stands + 3);
}

TEST_F(PositionMode, AStepTooFarIsAFault) {
    begin();
    push(0);
    push(kSystemPeriod / 2 + 1);
    host_.samples(kWay);
    EXPECT_EQ(faults(), uint32_t{CURVECORE_STATE_REFUSED_MASK});
    EXPECT_FALSE(host_->enable_o);
    expect_counts(0);
}

}  // namespace
}  // namespace curvecore::tb
