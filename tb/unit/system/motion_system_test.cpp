// SPDX-License-Identifier: Apache-2.0
// rtl/motion_system.sv from its registers to its pins: programs, silence, stops, invalid words.
#include <gtest/gtest.h>

#include "hls/registers/board_facts.h"
#include "hls/xy2_frame.hpp"
#include "tb/support/bench/motion_system_bench.hpp"

namespace curvecore::tb {
namespace {

constexpr uint32_t kEntryWords = 128;  // rtl/engine/engine_pkg.sv
/// Room of an empty queue, as far as ROOM can represent it; of the engine's entry.
constexpr uint32_t kSegmentRoom = CFG_Build == 2                  ? kEntryWords
                                  : CFG_SegmentQueueWords < 65536 ? CFG_SegmentQueueWords
                                                                  : 65535;
constexpr uint32_t kProfileRoom = CFG_Build == 2 ? kEntryWords : CFG_ProfileQueueWords;
/// Sample periods of silence that the watchdog takes for the host's end.
constexpr int64_t kSilence = 500 * kTenth / kSystemPeriod;

TEST_F(MotionSystem, SaysWhatItIs) {
    EXPECT_EQ(host_.read(CURVECORE_ID), CURVECORE_ID_ID_VALUE);
    const uint32_t capability = host_.read(CURVECORE_CAPABILITY);
    EXPECT_EQ(capability & CURVECORE_CAPABILITY_AXES_MASK, uint32_t{kSystemAxes});
    EXPECT_EQ(CURVECORE_FIELD(capability, CAPABILITY_PERIOD_LOG2), uint32_t{CFG_PeriodLog2});
    EXPECT_EQ(host_.read(CURVECORE_ROOM), kProfileRoom << 16 | kSegmentRoom);
    EXPECT_EQ(host_.read(CURVECORE_CLOCK), uint32_t{CFG_ClockHertz});
    const uint32_t widths = host_.read(CURVECORE_WIDTHS);
    EXPECT_EQ(CURVECORE_FIELD(widths, WIDTHS_TIME_BITS), uint32_t{CFG_TimeBits});
    EXPECT_EQ(CURVECORE_FIELD(widths, WIDTHS_SCALE_BITS), uint32_t{CFG_ScaleBits});
    EXPECT_EQ(CURVECORE_FIELD(widths, WIDTHS_SAMPLES_AHEAD), uint32_t{CFG_SamplesAhead});
    EXPECT_EQ(host_.state(), uint32_t{CURVECORE_STATE_STANDING_MASK | CURVECORE_STATE_CLEAN_MASK});
}

TEST_F(MotionSystem, DrawsAProgramThatIsWrittenToRegisters) {
    host_.prepare(part_);
    host_.draw(part_);
    expect_drawn();
    EXPECT_FALSE(host_.is(CURVECORE_STATE_UNDERRUN_MASK));
    for (int a = 0; a < kSystemAxes && CFG_Galvo == 1; ++a) {
        const double units = part_.job.plan.moves.back().end[a] / part_.job.options.unit_mm;
        const int64_t fine = std::llround(units) << (kFineBits - 32);
        EXPECT_EQ(host_.galvo_frame(a), hls::xy2_frame(fine, kFineBits)) << "axis " << a;
    }
    printf("%ld steps, %ld clocks\n", steps(), host_.now());
}

/// OVERRIDE is the rate at once while nothing is under way; then the rate goes after it.
TEST_F(MotionSystem, DrawsAProgramAtTheRateOfOverride) {
    constexpr uint32_t kWhole = 1 << 16;
    constexpr std::size_t kLooks = 100;
    host_.prepare(part_);
    host_.write(CURVECORE_OVERRIDE, kWhole / 2);
    std::vector<uint32_t> rates;
    RegisterHost::Sent sent;
    const auto idle = [] {};
    while (!sent.all(part_) || host_.path() != part_.job.plan.path_length()) {
        ASSERT_FALSE(HasFailure());
        host_.feed(part_, sent, idle);
        host_.samples(1);
        if (!host_.is(CURVECORE_STATE_ACTIVE_MASK)) continue;
        host_.path();  // keeps RATE
        rates.push_back(host_.read(CURVECORE_RATE));
        if (rates.size() == kLooks) host_.write(CURVECORE_OVERRIDE, kWhole);
    }
    host_.finish(part_);
    expect_drawn();
    EXPECT_FALSE(host_.is(CURVECORE_STATE_UNDERRUN_MASK));
    ASSERT_GT(rates.size(), kLooks);
    int between = 0;
    for (std::size_t n = 0; n < rates.size(); ++n) {
        if (n < kLooks) {
            EXPECT_EQ(rates[n], kWhole / 2) << n;
        }
        between += rates[n] > kWhole / 2 && rates[n] < kWhole ? 1 : 0;
    }
    EXPECT_GT(between, 0);
    EXPECT_EQ(rates.back(), kWhole);
}

/// The engine tells the path limb by limb: no reading has limbs of two samples.
TEST_F(MotionSystem, ThePathThatIsReadNeverGoesBack) {
    host_.prepare(part_);
    RegisterHost::Sent sent;
    uint64_t last = 0;
    int moved = 0;
    while (last != part_.job.plan.path_length() && !HasFailure()) {
        if (!sent.all(part_)) host_.feed(part_, sent, [] {});
        for (int n = 0; n < 100; ++n) {
            const uint64_t path = host_.path();
            EXPECT_GE(path, last);
            moved += path != last ? 1 : 0;
            last = path;
        }
    }
    EXPECT_GT(moved, 1000);
    host_.finish(part_);
    expect_drawn();
}

TEST_F(MotionSystem, DrawsAProgramThatStreamsBring) {
    host_->segment_valid_i = 1;
    host_->segment_data_i = part_.segments[0];
    host_.samples(2);
    EXPECT_EQ(host_->segment_ready_o, 0) << "before the machine is on";
    host_->segment_valid_i = 0;
    host_.prepare(part_);
    host_.stream(part_, random_);
    expect_drawn();
    EXPECT_FALSE(host_.is(CURVECORE_STATE_UNDERRUN_MASK));
}

TEST_F(MotionSystem, StandsOnThePathHoweverTheHostStalls) {
    host_.prepare(part_);
    int stalls = 0;
    const std::size_t words = part_.segments.size() + part_.pieces.size();
    host_.draw(part_, [&] {
        if (random_() % words >= 16) return;
        ++stalls;
        host_.tenths(4000 + random_() % 8000);
    });
    expect_drawn();
    EXPECT_GT(stalls, 2);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_UNDERRUN_MASK));
}

TEST_F(MotionSystem, HoldsWhenTheHostIsSilentAndGoesOn) {
    host_.prepare(part_);
    host_.write(CURVECORE_WATCHDOG, kSilence);
    int silences = 0;
    std::size_t words = 0;
    const std::size_t all = part_.segments.size() + part_.pieces.size();
    host_.draw(part_, [&] {
        if (++words % (all / 4) != 0) return;
        host_.samples(kSilence - 1);
        EXPECT_FALSE(host_.is(CURVECORE_STATE_WATCHDOG_MASK));
        if (!host_.is(CURVECORE_STATE_ACTIVE_MASK)) return;
        host_.tenths(8000);
        const uint32_t state = host_.state();
        EXPECT_TRUE(state & CURVECORE_STATE_WATCHDOG_MASK);
        EXPECT_TRUE(state & CURVECORE_STATE_HOLDING_MASK);
        EXPECT_TRUE(state & CURVECORE_STATE_STANDING_MASK);
        EXPECT_TRUE(state & CURVECORE_STATE_ENABLED_MASK);
        const auto stands = counts();
        host_.samples(10);
        EXPECT_EQ(counts(), stands);
        clear_faults();
        ++silences;
    });
    expect_drawn();
    EXPECT_GT(silences, 0);
}

/// A monitor reads a hundred times as often as the watchdog requires signs of life.
TEST_F(MotionSystem, HoldsWhenTheMasterIsGoneHoweverManyRead) {
    begin(700);
    host_.write(CURVECORE_WATCHDOG, kSilence);
    const int64_t gone = host_.now();
    while (!host_.is(CURVECORE_STATE_WATCHDOG_MASK)) {
        ASSERT_LT(host_.now() - gone, (kSilence + 2) * kSystemPeriod) << "reads are taken for life";
        host_.samples(1);
    }
    EXPECT_GT(host_.now() - gone, (kSilence - 2) * kSystemPeriod);
    while (!host_.is(CURVECORE_STATE_STANDING_MASK)) {
        ASSERT_LT(host_.now() - gone, 8000 * kTenth);
        host_.samples(1);
    }
    EXPECT_TRUE(host_.is(CURVECORE_STATE_ACTIVE_MASK)) << "it drew on to the end";
    // Refused writes are no signs of life either.
    clear_faults();
    const int64_t refused = host_.now();
    while (!host_.is(CURVECORE_STATE_WATCHDOG_MASK)) {
        ASSERT_LT(host_.now() - refused, (kSilence + 3) * kSystemPeriod)
            << "refused writes are taken for life";
        EXPECT_FALSE(host_.write(CURVECORE_ID, 0));
        host_.samples(1);
    }
}

TEST_F(MotionSystem, TakesNoWordUntilEveryAxisIsReferenced) {
    EXPECT_FALSE(host_.push(CURVECORE_SEGMENT_LO, part_.segments[0]));
    EXPECT_EQ(host_.state() & kFaults, uint32_t{CURVECORE_STATE_BUS_MASK});
    clear_faults();
    host_.write(CURVECORE_CONTROL, kEnable);
    EXPECT_FALSE(host_.push(CURVECORE_SEGMENT_LO, part_.segments[0]));
    host_.write(CURVECORE_REFERENCE, kEveryAxis >> 1);
    EXPECT_FALSE(host_.is(CURVECORE_STATE_READY_MASK));
    EXPECT_FALSE(host_.push(CURVECORE_SEGMENT_LO, part_.segments[0]));
    EXPECT_FALSE(host_.push(CURVECORE_PROFILE_LO, part_.pieces[0]));
    host_.write(CURVECORE_REFERENCE, kEveryAxis & ~(kEveryAxis >> 1));
    EXPECT_TRUE(host_.is(CURVECORE_STATE_READY_MASK));
    EXPECT_TRUE(host_.push(CURVECORE_SEGMENT_LO, part_.segments[0]));
    // Its word may be under way to the first sample.
    EXPECT_FALSE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
}

TEST_F(MotionSystem, RefusesAWordThatDoesNotFitAndLosesNone) {
    host_.prepare(part_, kEnable | kHold);
    std::size_t segment = 0;
    std::size_t piece = 0;
    // No program begins under a hold. The pieces' queue is the smaller one.
    while (piece < part_.pieces.size() && host_.push(CURVECORE_PROFILE_LO, part_.pieces[piece])) {
        ++piece;
    }
    EXPECT_GE(piece, std::size_t{kProfileRoom});  // some have left for the generator
    ASSERT_LT(piece, part_.pieces.size()) << "a longer program is needed";
    EXPECT_EQ(host_.read(CURVECORE_ROOM) >> 16, 0U);
    EXPECT_EQ(host_.state() & kFaults, uint32_t{CURVECORE_STATE_BUS_MASK});
    clear_faults();
    host_.write(CURVECORE_CONTROL, kEnable);
    int refused = 0;
    while ((segment < part_.segments.size() || piece < part_.pieces.size()) && !HasFailure()) {
        if (segment < part_.segments.size()) {
            const bool good = host_.push(CURVECORE_SEGMENT_LO, part_.segments[segment]);
            segment += good ? 1 : 0;
            refused += good ? 0 : 1;
        }
        if (piece < part_.pieces.size()) {
            const bool good = host_.push(CURVECORE_PROFILE_LO, part_.pieces[piece]);
            piece += good ? 1 : 0;
            refused += good ? 0 : 1;
        }
    }
    EXPECT_GT(refused, 0);
    clear_faults();
    host_.finish(part_);
    expect_drawn();
}

TEST_F(MotionSystem, EstopReachesThePinsOneClockAfterTheSynchroniser) {
    for (int repeat = 0; repeat < 4 && !HasFailure(); ++repeat) {
        begin(500 + random_() % 500);
        for (int n = 0; host_->step_o == 0 && n < 100 * kSystemPeriod; ++n) host_.clock();
        ASSERT_NE(host_->step_o, 0);
        host_.clocks(random_() % kSystemPeriod);
        const auto before = steps();
        host_->estop_i = 1;
        host_.clocks(2);
        EXPECT_TRUE(host_->enable_o);
        host_.clock();
        EXPECT_EQ(host_->step_o, 0);
        EXPECT_FALSE(host_->enable_o);
        const auto after = steps();
        EXPECT_LE(after, before + 2 * kSystemAxes);
        host_.samples(10);
        EXPECT_EQ(steps(), after);
        expect_counted();
        EXPECT_EQ(host_.state() & kFaults, uint32_t{CURVECORE_STATE_ESTOP_INPUT_MASK});
        EXPECT_EQ(host_.read(CURVECORE_AXES) & CURVECORE_AXES_REFERENCED_MASK, 0U);
        EXPECT_EQ(host_.read(CURVECORE_ROOM) & 0xffff, kSegmentRoom);
        // The machine turns on when the pin is free and the fault is cleared, not before.
        EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kEnable));
        host_->estop_i = 0;
        host_.clocks(4);
        EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kEnable));
        clear_faults();
    }
    const auto start = counts();
    host_.prepare(part_);
    host_.draw(part_);
    expect_drawn(start);
}

/// Motion before the stop is not waited for.
TEST_F(MotionSystem, ComesOnAtOnceAfterAnEstopInMotion) {
    for (int repeat = 0; repeat < 12 && !HasFailure(); ++repeat) {
        begin(500 + random_() % 500);
        host_.clocks(random_() % kSystemPeriod);
        // In motion the machine does not change to positions, but an e-stop with that is obeyed.
        constexpr uint32_t kRefused = kEnable | CURVECORE_CONTROL_POSITION_MASK;
        const bool refused = repeat % 2 != 0;
        EXPECT_NE(
            host_.write(CURVECORE_CONTROL, CURVECORE_CONTROL_ESTOP_MASK | (refused ? kRefused : 0)),
            refused);
        EXPECT_FALSE(host_.is(CURVECORE_STATE_ENABLED_MASK));
        do {
            clear_faults();
        } while (!host_.write(CURVECORE_CONTROL, kEnable));
        clear_faults();  // faults of the refused words
        host_.samples(4);
        EXPECT_EQ(host_.state() & (kFaults | CURVECORE_STATE_ENABLED_MASK),
                  uint32_t{CURVECORE_STATE_ENABLED_MASK});
        host_.write(CURVECORE_CONTROL, 0);
    }
}

TEST_F(MotionSystem, LimitSwitchesStopAllAxesUnlessTheyAreMasked) {
    host_.write(CURVECORE_PINS, CURVECORE_PUT(PINS_LIMIT_MASKED, 2));
    host_->limit_i = 2;
    begin(600);
    EXPECT_EQ(host_.read(CURVECORE_AXES) & CURVECORE_AXES_LIMIT_MASK, CURVECORE_PUT(AXES_LIMIT, 2));
    host_->limit_i = 1;
    host_.clocks(3);
    EXPECT_EQ(host_->step_o & 1, 0);
    host_.clock();
    EXPECT_EQ(host_->step_o, 0);
    EXPECT_EQ(host_.state() & (kFaults | CURVECORE_STATE_ENABLED_MASK),
              uint32_t{CURVECORE_STATE_LIMIT_MASK});
    clear_faults();
    EXPECT_FALSE(host_.write(CURVECORE_CONTROL, kEnable));
    host_.write(CURVECORE_PINS, CURVECORE_PUT(PINS_LIMIT_MASKED, 1));
    while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
    EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kEnable));
}

TEST_F(MotionSystem, FlushStopsOnThePathEmptiesAndKeepsThePosition) {
    begin(700);
    const auto moving = steps();
    host_.write(CURVECORE_CONTROL, kEnable | kFlush);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_FLUSHING_MASK));
    EXPECT_FALSE(host_.push(CURVECORE_SEGMENT_LO, part_.segments[0]));
    while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
    EXPECT_GT(steps(), moving + 100) << "it has stopped at once";
    clear_faults();
    const uint32_t state = host_.state();
    EXPECT_EQ(state & (kFaults | CURVECORE_STATE_ACTIVE_MASK), 0U);
    EXPECT_TRUE(state & CURVECORE_STATE_CLEAN_MASK);
    EXPECT_TRUE(state & CURVECORE_STATE_READY_MASK) << "positions are kept";
    EXPECT_EQ(host_.read(CURVECORE_ROOM) & 0xffff, kSegmentRoom);
    const auto stands = counts();
    host_.samples(20);
    EXPECT_EQ(counts(), stands);
    // The host declares this place to be the program's start.
    EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
    host_.draw(part_);
    expect_drawn(stands);
}

TEST_F(MotionSystem, DrawsBehindAFlushAsFastAsBefore) {
    host_.prepare(part_);
    const int64_t before = host_.now();
    host_.draw(part_);
    const int64_t clocks = host_.now() - before;
    const auto stands = counts();
    host_.write(CURVECORE_CONTROL, kEnable | kHold | kFlush);
    const int64_t flushed = host_.now();
    while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
    EXPECT_LT(host_.now() - flushed, 50 * kSystemPeriod) << "nothing is under way";
    host_.samples(50);
    EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
    host_.write(CURVECORE_CONTROL, kEnable);
    const int64_t again = host_.now();
    host_.draw(part_);
    expect_drawn(stands);
    EXPECT_NEAR(static_cast<double>(host_.now() - again), static_cast<double>(clocks),
                50.0 * kSystemPeriod);
}

TEST_F(MotionSystem, RandomAccessesHangNothingAndGiveNoStep) {
    int errors = 0;
    for (int n = 0; n < 10000 && !HasFailure(); ++n) {
        const auto address = static_cast<uint32_t>(random_() % 128 * 4);
        errors += host_.write(address, random_() >> random_() % 32) ? 0 : 1;
    }
    EXPECT_GT(errors, 1000);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_BUS_MASK));
    for (int a = 0; a < kSystemAxes; ++a) {
        const uint32_t axis = static_cast<uint32_t>(a) * CURVECORE_AXIS_STRIDE;
        EXPECT_EQ(host_.read(CURVECORE_AXIS_STEPS + axis), 0U);
    }
}

}  // namespace
}  // namespace curvecore::tb
