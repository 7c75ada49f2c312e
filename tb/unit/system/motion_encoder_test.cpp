// SPDX-License-Identifier: Apache-2.0
// rtl/motion_system.sv with encoders: counts, following errors, and stops.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tb/support/bench/register_host.hpp"

namespace curvecore::tb {
namespace {

constexpr uint32_t kFollowing = CURVECORE_STATE_FOLLOWING_MASK;
constexpr uint32_t kEncoder = CURVECORE_STATE_ENCODER_MASK;
/// Clocks of a round, when the bus is quiet and at most.
constexpr int kRound = 8 * kSystemAxes;
constexpr int kLongestRound = 3 * kRound;
/// Clocks from a pin until it counts: the synchroniser, three samples, a round.
constexpr int kSeen = 2 + 3 * CFG_Encoders + kRound;

class MotionEncoder : public testing::Test {
  protected:
    /// An axis behind its drive, and its encoder.
    struct Axis {
        int counts = 1;  // this number of edges ..
        int steps = 1;   // .. in this number of steps; < 0: backwards
        int64_t slipped = 0;
        int64_t edges = 0;

        int64_t wanted(int64_t place) const {
            return static_cast<int64_t>(
                std::floor(static_cast<double>((place - slipped) * counts) / steps));
        }
    };

    MotionEncoder() {
        host_.each_clock = [this] { turn(); };
    }
    /// Lets encoders follow their axes, an edge in at most `apart_` clocks.
    void turn() {
        for (int a = 0; a < kSystemAxes; ++a) {
            Axis& axis = axis_[a];
            const int64_t place = host_.drive(a).count();
            if (a == slips_ && place != place_[a]) axis.slipped += place - place_[a];
            place_[a] = place;
            const int64_t wanted = axis.wanted(place);
            if (wanted == axis.edges || host_.now() < next_[a]) continue;
            axis.edges += wanted > axis.edges ? 1 : -1;
            next_[a] = host_.now() + apart_;
        }
        set_pins();
    }
    void set_pins() {
        uint32_t pins_a = 0;
        uint32_t pins_b = 0;
        for (int a = 0; a < kSystemAxes; ++a) {
            const auto phase = static_cast<unsigned>(axis_[a].edges & 3);
            pins_a |= (phase == 1 || phase == 2 ? 1U : 0U) << a;
            pins_b |= (phase >> 1) << a;
        }
        host_->encoder_a_i = pins_a;
        host_->encoder_b_i = pins_b;
    }
    void set_axis(int axis, int counts, int steps, double limit_steps) {
        axis_[axis].counts = counts;
        axis_[axis].steps = steps;
        host_.write(CURVECORE_ENCODER_RATIO0 + 4 * axis,
                    static_cast<uint32_t>(counts) | static_cast<uint32_t>(steps) << 16);
        host_.write(CURVECORE_FOLLOWING_LIMIT0 + 4 * axis,
                    static_cast<uint32_t>(std::floor(limit_steps * counts)));
    }
    int32_t of_axis(uint32_t first, int axis) {
        return static_cast<int32_t>(host_.read(first + 4 * axis));
    }
    /// Following error, steps.
    double error(int axis) {
        return static_cast<double>(of_axis(CURVECORE_FOLLOWING0, axis)) / axis_[axis].counts;
    }
    double worst(int axis) {
        return static_cast<double>(of_axis(CURVECORE_FOLLOWING_WORST0, axis)) / axis_[axis].counts;
    }
    /// Turns the machine on and draws for so many tenths of a millisecond.
    void begin(int64_t tenths) {
        host_.write(CURVECORE_CONTROL, 0);
        host_.samples(2);
        host_.write(CURVECORE_STATE, kFaults);
        host_.prepare(part_);
        sent_ = {};
        host_.draw_for(tenths, part_, sent_);
    }
    uint32_t fault_axis() { return CURVECORE_FIELD(host_.state(), STATE_FAULT_AXIS); }
    uint32_t homed() {
        host_.clocks(100);
        return CURVECORE_FIELD(host_.read(CURVECORE_SWITCHES), SWITCHES_HOMED);
    }

    std::mt19937 random_{11};
    Part part_{"pulses.ngc", ref::Holds::kBranches};
    RegisterHost host_;
    RegisterHost::Sent sent_;
    std::array<Axis, kSystemAxes> axis_;
    std::array<int64_t, kSystemAxes> place_{};
    std::array<int64_t, kSystemAxes> next_{};
    int64_t apart_ = kLongestRound;
    int slips_ = -1;
};

TEST_F(MotionEncoder, TellsThatItHasEncoders) {
    EXPECT_NE(host_.read(CURVECORE_CAPABILITY) & CURVECORE_CAPABILITY_ENCODERS_MASK, 0U);
}

TEST_F(MotionEncoder, AnAxisThatFollowsIsWithinACountAllTheWay) {
    // Ratios: more edges than steps, fewer, backwards.
    set_axis(0, 5, 2, 4);
    set_axis(1, 3, 7, 4);
    set_axis(2, 2, -3, 4);
    for (int repeat = 0; repeat < 2; ++repeat) {
        begin(1);
        while (!sent_.all(part_) && !HasFailure()) host_.feed(part_, sent_, [] {});
        host_.finish(part_);
        host_.clocks(kSeen + kRound);
        EXPECT_EQ(host_.state() & kFaults, 0U);
        for (int a = 0; a < kSystemAxes; ++a) {
            SCOPED_TRACE(a);
            EXPECT_EQ(of_axis(CURVECORE_ENCODER0, a), axis_[a].edges);
            EXPECT_EQ(axis_[a].edges, axis_[a].wanted(host_.drive(a).count()));
            const double edge = std::abs(static_cast<double>(axis_[a].steps) / axis_[a].counts);
            EXPECT_LT(std::abs(error(a)), edge);
            // A step is counted before its edges are.
            EXPECT_LT(std::abs(worst(a)), 1 + edge);
            EXPECT_GE(std::abs(worst(a)), std::abs(error(a)));
            EXPECT_NE(host_.drive(a).steps(), 0);
        }
    }
}

TEST_F(MotionEncoder, AnAxisThatSlipsStopsTheMachineBeyondItsLimitAndIsNamed) {
    for (int a = 0; a < kSystemAxes; ++a) set_axis(a, 5, 2, 20);
    int cut = 0;
    for (int slips = 0; slips < kSystemAxes; ++slips) {
        slips_ = -1;
        begin(100 + random_() % 400);
        const int64_t begins = host_.drive(slips).count();
        while (host_.drive(slips).count() == begins && !HasFailure()) {
            host_.feed(part_, sent_, [] {});
        }
        host_.write(CURVECORE_HOMED, kEveryAxis);
        const uint32_t all = homed();
        slips_ = slips;
        const int64_t slipped = axis_[slips].slipped;
        int64_t lost = 0;
        int64_t since = 0;  // clocks since it slipped beyond the limit
        while (host_->enable_o && !HasFailure()) {
            host_.clock();
            lost = std::abs(axis_[slips].slipped - slipped);
            since += lost > 21 ? 1 : 0;
            ASSERT_LT(since, kLongestRound + 10);
            ASSERT_LT(host_.now(), 40'000'000) << "axis " << slips << " lost " << lost;
        }
        EXPECT_GE(lost, 20) << "not before";
        host_.clocks(5);
        EXPECT_EQ(host_->step_o, 0U);
        EXPECT_EQ(host_.state() & kFaults, kFollowing);
        EXPECT_EQ(fault_axis(), static_cast<uint32_t>(slips));
        EXPECT_EQ(host_.read(CURVECORE_AXES) & CURVECORE_AXES_REFERENCED_MASK, 0U);
        // The place is also uncertain if a pulse was cut.
        EXPECT_EQ(homed() & ~all, 0U);
        EXPECT_EQ(homed() >> slips & 1, 0U);
        cut += homed() != (all & ~(1U << slips)) ? 1 : 0;
        // Its error can be read until the axis is referenced.
        EXPECT_NEAR(std::abs(error(slips)), 20, 2);
        EXPECT_EQ(worst(slips), error(slips));
        EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kEnable));
        slips_ = -1;
        begin(300);
        EXPECT_TRUE(host_.is(CURVECORE_STATE_ENABLED_MASK));
        EXPECT_LT(std::abs(worst(slips)), 3);
    }
    EXPECT_LT(cut, kSystemAxes);
}

TEST_F(MotionEncoder, WithoutALimitNothingStops) {
    for (int a = 0; a < kSystemAxes; ++a) set_axis(a, 1, 1, 0);
    slips_ = 1;
    begin(600);
    axis_[0].edges += 2;  // illegal
    host_.samples(2);
    EXPECT_EQ(host_.state() & kFaults, 0U);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_ENABLED_MASK));
    host_.clocks(kSeen);
    EXPECT_GT(std::abs(error(1)), 5);
}

TEST_F(MotionEncoder, PinsThatChangeTogetherStopTheMachineAndAreNamed) {
    for (const int which : {2, 0, 1}) {
        for (int a = 0; a < kSystemAxes; ++a) set_axis(a, 1, 1, 100);
        begin(200 + random_() % 400);
        EXPECT_EQ(host_.state() & kFaults, 0U);
        next_[which] = INT64_MAX;  // no edge beside it: three would be one backwards
        host_.clocks(kSeen + kLongestRound);
        axis_[which].edges += 2;
        axis_[which].slipped -= 2;
        host_.clocks(kSeen + kLongestRound);
        next_[which] = 0;
        EXPECT_EQ(host_.state() & kFaults, kEncoder);
        EXPECT_EQ(fault_axis(), static_cast<uint32_t>(which));
        EXPECT_FALSE(host_.is(CURVECORE_STATE_ENABLED_MASK));
    }
}

TEST_F(MotionEncoder, EveryEdgeCountsAtTheStatedRateWhateverTheBusDoes) {
    host_.state();
    host_.each_clock = [] {};
    std::array<int64_t, kSystemAxes> start{};
    for (int a = 0; a < kSystemAxes; ++a) {
        start[a] = of_axis(CURVECORE_ENCODER0, a) - axis_[a].edges;
    }
    std::array<int64_t, kSystemAxes> next{};
    int64_t edges = 0;
    for (const bool busy : {false, true}) {
        const int round = busy ? kLongestRound : kRound;
        for (int64_t clocks = 0; clocks < 200'000; ++clocks) {
            for (int a = 0; a < kSystemAxes; ++a) {
                if (--next[a] > 0) continue;
                axis_[a].edges += random_() % 4 == 0 ? -1 : 1;
                next[a] = round + 2 * CFG_Encoders + (random_() % 8 == 0 ? random_() % round : 0);
                ++edges;
            }
            set_pins();
            host_->valid_i = busy;
            host_->write_i = 0;
            host_->word_i = CURVECORE_STATE / 4;
            host_.clock();
        }
        host_->valid_i = 0;
        host_.clocks(kSeen + kLongestRound);
        for (int a = 0; a < kSystemAxes; ++a) {
            EXPECT_EQ(of_axis(CURVECORE_ENCODER0, a) - start[a], axis_[a].edges) << a;
        }
    }
    EXPECT_GT(edges, 20000);
}

TEST_F(MotionEncoder, GlitchesDoNotCount) {
    host_.state();
    host_.each_clock = [] {};
    host_.clocks(200);
    const int32_t before = of_axis(CURVECORE_ENCODER0, 0);
    for (int n = 0; n < 2000; ++n) {
        host_->encoder_a_i = random_() % 2;
        host_->encoder_b_i = 1 - host_->encoder_a_i;
        host_.clocks(1 + static_cast<int64_t>(random_() % (2 * CFG_Encoders - 1)));
        host_->encoder_a_i = 0;
        host_->encoder_b_i = 0;
        host_.clocks(3 * CFG_Encoders + random_() % 50);
        ASSERT_EQ(of_axis(CURVECORE_ENCODER0, 0), before) << n;
    }
    host_->encoder_a_i = 1;
    host_.clocks(kSeen + 10);
    EXPECT_EQ(of_axis(CURVECORE_ENCODER0, 0), before + 1);
}

}  // namespace
}  // namespace curvecore::tb
