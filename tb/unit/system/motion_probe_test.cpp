// SPDX-License-Identifier: Apache-2.0
// rtl/motion_system.sv: switches that a motion waits for, and axes that are homed.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "tb/support/bench/register_host.hpp"

namespace curvecore::tb {
namespace {

constexpr uint32_t kCaught = CURVECORE_STATE_CAUGHT_MASK;
constexpr uint32_t kArmed = CURVECORE_PROBE_ARMED_MASK;
constexpr uint32_t kHigh = CURVECORE_PROBE_HIGH_MASK;
constexpr uint32_t kProbe = 15;
/// Clocks from a pin's edge to the count of an axis: hls/registers/registers.rdl.
constexpr int first_note(int axis) { return 3 + axis; }
constexpr int last_note(int axis) { return 5 + 3 * axis; }

class MotionProbe : public testing::Test {
  protected:
    void prepare() {
        host_.write(CURVECORE_CONTROL, 0);
        wait_for(CURVECORE_STATE_FLUSHING_MASK, false);
        host_.samples(2);
        host_.prepare(part_);
    }
    /// Turns the machine on and draws for so many tenths of a millisecond.
    void begin(int64_t tenths) {
        prepare();
        sent_ = {};
        host_.draw_for(tenths, part_, sent_);
        ASSERT_TRUE(host_.is(CURVECORE_STATE_ACTIVE_MASK));
    }
    void set_pin(uint32_t which, bool level) {
        if (which == kProbe) {
            host_->probe_i = level;
        } else {
            host_->home_i = static_cast<uint32_t>(host_->home_i) & ~(1U << which);
            host_->home_i = static_cast<uint32_t>(host_->home_i) | unsigned{level} << which;
        }
    }
    int64_t caught(int axis) {
        return static_cast<int32_t>(
            host_.read(CURVECORE_AXIS_CAUGHT + axis * CURVECORE_AXIS_STRIDE));
    }
    int64_t steps() const {
        int64_t sum = 0;
        for (int a = 0; a < kSystemAxes; ++a) sum += host_.drive(a).steps();
        return sum;
    }
    void wait_for(uint32_t mask, bool set = true) {
        for (int n = 0; host_.is(mask) != set; ++n) {
            ASSERT_LT(n, 20000);
            host_.samples(1);
        }
    }

    std::mt19937 random_{5};
    Part part_{"pulses.ngc", ref::Holds::kBranches};
    RegisterHost host_;
    RegisterHost::Sent sent_;
};

TEST_F(MotionProbe, NotesStepsAndPathWithinClocksOfTheEdgeAndHoldsOnThePath) {
    int apart = 0;  // axes that made a step during the notes
    for (int repeat = 0; repeat < 8 && !HasFailure(); ++repeat) {
        const uint32_t which = repeat % 4 == 3 ? kProbe : repeat % 4;
        const bool high = repeat / 4 != 1;
        set_pin(which, !high);
        begin(400 + random_() % 600);
        host_.write(CURVECORE_PROBE, which | (high ? kHigh : 0) | kArmed);
        host_.clocks(random_() % kSystemPeriod);
        EXPECT_FALSE(host_.is(kCaught | CURVECORE_STATE_HOLDING_MASK));
        const uint64_t path = host_.path();
        set_pin(which, high);
        std::vector<std::vector<int64_t>> counts(kSystemAxes);  // by clocks since the edge
        for (int n = 0; n <= last_note(kSystemAxes); ++n) {
            for (int a = 0; a < kSystemAxes; ++a) counts[a].push_back(host_.drive(a).count());
            // One edge of the clock suffices, and requests may fill the bus.
            if (n == 1) set_pin(which, !high);
            if (repeat % 2 == 0) host_->valid_i = n % 3 != 2;
            host_.clock();
        }
        host_->valid_i = 0;
        host_.clocks(3);
        EXPECT_TRUE(host_.is(kCaught));
        EXPECT_TRUE(host_.is(CURVECORE_STATE_HOLDING_MASK));
        for (int a = 0; a < kSystemAxes; ++a) {
            // The drive sees a step one clock after it was counted.
            const int64_t count = caught(a);
            const int64_t early = counts[a][first_note(a)];
            const int64_t late = counts[a][last_note(a) + 1];
            EXPECT_GE(count, std::min(early, late)) << "axis " << a;
            EXPECT_LE(count, std::max(early, late)) << "axis " << a;
            apart += early != late ? 1 : 0;
        }
        const auto noted = static_cast<uint32_t>(host_.read(CURVECORE_CAUGHT_PATH));
        const auto behind = noted - static_cast<uint32_t>(path >> 16);
        EXPECT_LT(behind, 2000000U) << "2 mm";
        wait_for(CURVECORE_STATE_STANDING_MASK);
        const int64_t stands = steps();
        host_.samples(10);
        EXPECT_EQ(steps(), stands);
        EXPECT_LT(static_cast<uint32_t>(host_.path() >> 16) - noted, 20000000U);
        EXPECT_EQ(host_.state() & kFaults, 0U);
        // The motion continues to the part's end on request.
        host_.write(CURVECORE_PROBE, 0);
        EXPECT_FALSE(host_.is(kCaught | CURVECORE_STATE_HOLDING_MASK));
        while (!sent_.all(part_) && !HasFailure()) host_.feed(part_, sent_, [] {});
        host_.finish(part_);
        for (int a = 0; a < kSystemAxes; ++a) {
            EXPECT_EQ(host_.drive(a).complaint(), "");
            EXPECT_EQ(host_.drive(a).count(), (repeat + 1) * part_.end(a)) << "axis " << a;
        }
    }
    EXPECT_LT(apart, 6) << "steps come too fast for this test";
}

TEST_F(MotionProbe, PositionsAreKeptWhenTheRestIsFlushed) {
    begin(600);
    host_.write(CURVECORE_PROBE, kProbe | kHigh | kArmed);
    host_->probe_i = 1;
    wait_for(CURVECORE_STATE_STANDING_MASK);
    host_.write(CURVECORE_CONTROL, kEnable | kFlush);
    wait_for(CURVECORE_STATE_FLUSHING_MASK, false);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_READY_MASK));
    std::vector<int64_t> stands;
    for (int a = 0; a < kSystemAxes; ++a) {
        stands.push_back(host_.drive(a).count());
        EXPECT_LE(std::abs(stands[a]), std::abs(part_.end(a)) + 40000);
    }
    host_.write(CURVECORE_PROBE, 0);
    EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
    host_.draw(part_);
    for (int a = 0; a < kSystemAxes; ++a) {
        EXPECT_EQ(host_.drive(a).count(), stands[a] + part_.end(a));
    }
}

TEST_F(MotionProbe, OfAnotherSwitchOrLevelOrUnarmedNothingHappens) {
    begin(400);
    for (const uint32_t probe : {1 | kHigh | kArmed, 0 | kArmed, 0 | kHigh, kProbe | kHigh}) {
        set_pin(0, (probe & kHigh) == 0);
        set_pin(1, false);
        host_.samples(1);
        host_.write(CURVECORE_PROBE, probe);
        EXPECT_EQ(host_.read(CURVECORE_PROBE), probe);
        set_pin(0, true);
        host_.samples(1);
        EXPECT_FALSE(host_.is(kCaught | CURVECORE_STATE_HOLDING_MASK)) << probe;
    }
    host_.write(CURVECORE_PROBE, 0 | kHigh | kArmed);
    host_.clocks(20);
    EXPECT_TRUE(host_.is(kCaught)) << "a level that is there already counts";
}

TEST_F(MotionProbe, SwitchesAreSeen) {
    host_.state();  // the first access takes longer
    for (int n = 0; n < 100; ++n) {
        const uint32_t pins = random_() % 16;
        host_->home_i = pins & 7;
        host_->probe_i = pins >> 3;
        host_.clocks(5);
        EXPECT_EQ(host_.read(CURVECORE_SWITCHES),
                  (pins & 7) | CURVECORE_PUT(SWITCHES_PROBE, pins >> 3));
    }
}

TEST_F(MotionProbe, AnAxisIsHomedUntilAPulseIsCut) {
    const auto homed = [this] {
        host_.clocks(5);
        return CURVECORE_FIELD(host_.read(CURVECORE_SWITCHES), SWITCHES_HOMED);
    };
    EXPECT_EQ(homed(), 0U);
    host_.write(CURVECORE_ORIGIN0 + 4, 12345);
    int cut = 0;
    for (int repeat = 0; repeat < 20 && !HasFailure(); ++repeat) {
        begin(500 + random_() % 100);
        host_.write(CURVECORE_HOMED, kEveryAxis);
        EXPECT_EQ(homed(), kEveryAxis);
        // In a pulse, which is long enough for this, or between two.
        host_.write(CURVECORE_PULSE, 100 | CURVECORE_PUT(PULSE_STEPSPACE, 2));
        host_.samples(2);
        const bool pulse = repeat % 2 == 0;
        for (int n = 0; (host_->step_o != 0) != pulse && n < 100 * kSystemPeriod; ++n) {
            host_.clock();
        }
        host_->estop_i = 1;
        host_.clocks(10);
        const uint32_t uncertain = CURVECORE_FIELD(host_.read(CURVECORE_AXES), AXES_UNCERTAIN);
        cut += uncertain != 0 ? 1 : 0;
        EXPECT_EQ(homed(), kEveryAxis & ~uncertain);
        host_.write(CURVECORE_HOMED, kEveryAxis);
        EXPECT_EQ(homed(), kEveryAxis & ~uncertain) << "as long as it is uncertain";
        host_->estop_i = 0;
        host_.clocks(5);
        host_.write(CURVECORE_STATE, kFaults);
        // A reference sets the place of the program's start, not the machine's.
        prepare();
        EXPECT_EQ(homed(), kEveryAxis & ~uncertain);
    }
    EXPECT_GT(cut, 2);
    EXPECT_LT(cut, 18);
    EXPECT_EQ(host_.read(CURVECORE_ORIGIN0 + 4), 12345U);
}

}  // namespace
}  // namespace curvecore::tb
