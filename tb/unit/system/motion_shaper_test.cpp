// SPDX-License-Identifier: Apache-2.0
// The shaper of rtl/motion_system.sv: a tool on springs is nearer to the path, all steps are given,
// and who is told that the axes stand finds that they do.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tb/support/bench/motion_system_bench.hpp"
#include "tb/support/pins/sprung_tool.hpp"

namespace curvecore::tb {
namespace {

constexpr double kRadius = 5;  // of tb/data/circles.ngc, mm
constexpr double kSample = static_cast<double>(kSystemPeriod) / CFG_ClockHertz;  // s

class MotionShaper : public MotionSystem {
  protected:
    void SetUp() override {
        part_ = Part("circles.ngc", ref::Holds::kBranches, [](sysc::Options& options) {
            options.segment_queue_words = CFG_SegmentQueueWords;
            options.profile_queue_words = CFG_ProfileQueueWords;
        });
        host_.each_clock = [this] { watch(); };
    }

    void shape(ref::ShaperKind kind) { tb::shape(host_, kind, kSample, kSystemAxes, CFG_Shaper); }

    void watch() {
        double off[2];
        for (int axis = 0; axis < 2; ++axis) {
            const double drive = static_cast<double>(host_.drive(axis).count()) / kStepsPerMm;
            tool_[axis].follow(drive, 1.0 / CFG_ClockHertz);
            off[axis] = tool_[axis].place() - (axis == 0 ? kRadius : 0);
        }
        worst_ = std::max(worst_, std::abs(std::hypot(off[0], off[1]) - kRadius));
        swing_ = std::max(swing_, std::hypot(tool_[0].place(), tool_[1].place()));
    }

    /// Draws the part; returns how far the tool is off the circle at most, um.
    double draw(ref::ShaperKind kind) {
        shape(kind);
        host_.prepare(part_);
        host_.draw(part_);
        host_.samples(CFG_Shaper);
        expect_drawn();
        const double off = 1e3 * worst_;
        worst_ = swing_ = 0;
        host_.clocks(CFG_ClockHertz / 50);
        return off;
    }

    SprungTool tool_[2];
    double worst_ = 0;
    double swing_ = 0;  // mm from where the part ends
};

TEST_F(MotionShaper, HasTheToolBesideThePathWithoutIt) {
    const double off = draw(ref::ShaperKind::kNone);
    std::printf("without: %.2f um, %.2f at rest\n", off, 1e3 * swing_);
    EXPECT_GT(off, 15);
    EXPECT_GT(swing_, 0.8e-3);
}

TEST_F(MotionShaper, FeedForwardHasTheToolOnThePath) {
    const double off = draw(ref::ShaperKind::kFeedForward);
    std::printf("feed-forward: %.2f um, %.2f at rest\n", off, 1e3 * swing_);
    EXPECT_LT(off, 3);
}

TEST_F(MotionShaper, ImpulsesLeaveTheToolAtRest) {
    const double off = draw(ref::ShaperKind::kZv);
    std::printf("zv: %.2f um, %.2f at rest\n", off, 1e3 * swing_);
    EXPECT_LT(off, 10);
    EXPECT_LT(swing_, 0.5e-3);
}

TEST_F(MotionShaper, StandsWhenItSaysSo) {
    shape(ref::ShaperKind::kEi);
    host_.prepare(part_);
    RegisterHost::Sent sent;
    host_.draw_for(3000, part_, sent);
    host_.write(CURVECORE_CONTROL, kEnable | kHold);
    while (!host_.is(CURVECORE_STATE_STANDING_MASK) && !HasFailure())
        host_.feed(part_, sent, [] {});
    const std::vector<int64_t> there = counts();
    host_.samples(2 * CFG_Shaper);
    EXPECT_EQ(counts(), there);
    host_.live();
    host_.write(CURVECORE_CONTROL, kEnable);
    host_.draw_rest(part_, sent, [] {});
    host_.samples(CFG_Shaper);
    expect_drawn();
}

TEST_F(MotionShaper, IsNotChangedWhileTheDrivesAreOn) {
    host_.prepare(part_);
    EXPECT_FALSE(host_.write(CURVECORE_SHAPER, 1));
}

}  // namespace
}  // namespace curvecore::tb
