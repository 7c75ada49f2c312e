// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/step_generator.sv: equal to its kernel clock by clock; references, stops, samples that
// are late or jump.
#include "hls/step_generator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <random>

#include "ref/numeric/step_crossings.hpp"
#include "tb/support/pins/step_bench.hpp"
#include "tb/support/pins/step_motion.hpp"

namespace curvecore::tb {
namespace {

constexpr int64_t kAll = kEveryAxis;
constexpr int64_t kScale = int64_t{1} << std::min(kScaleBits - 2, kFineBits + 6);
/// Clocks from a taken sample until its last step is out.
constexpr int64_t kMove = 2 * kPeriod + 32;
constexpr double kUnitsPerStep = 65536.0 * (int64_t{1} << kFineBits) / kScale;

std::vector<int64_t> everywhere(double steps) {
    return std::vector<int64_t>(kStepAxes, static_cast<int64_t>(steps * kUnitsPerStep));
}

class StepGenerator : public testing::Test {
  protected:
    /// Sets all axes to 0, referenced, with the period's tick just over.
    void begin(const hls::PulseTimes& times = {}) {
        bench_.reset();
        bench_.set_times(times);
        for (int a = 0; a < kStepAxes; ++a) bench_.set_scale(a, kScale);
        start(0);
    }
    void start(double steps) {
        bench_.reference();
        bench_.sample(everywhere(steps));
        to_tick();
        bench_.clocks(kStepAxes + 5);
        ASSERT_EQ(bench_->referenced_o, kAll);
    }

    void to_tick() {
        const int64_t ticked = bench_.ticked();
        while (bench_.ticked() == ticked) bench_.clock();
    }

    /// Pulses of all axes in `clocks` clocks, up less down.
    int64_t count(int64_t clocks) {
        int64_t sum = 0;
        while (clocks-- > 0) {
            bench_.clock();
            for (int a = 0; a < kStepAxes; ++a) {
                if (bench_.step(a) && !(high_ >> a & 1)) sum += bench_.direction(a) ? -1 : 1;
            }
            high_ = bench_->step_o;
        }
        return sum;
    }

    StepBench bench_;
    std::mt19937_64 random_{1};
    int64_t high_ = 0;
};

TEST_F(StepGenerator, EqualsKernelClockByClock) {
    int64_t steps = 0;
    int stops = 0;
    int late = 0;
    int refused = 0;
    int overrun = 0;
    for (int machine = 0; machine < (kPeriod > 1000 ? 60 : 200); ++machine) {
        hls::StepGenerator kernel(kStepAxes, kFineBits, kPeriodLog2);
        bench_.reset();
        const auto any = [&](int most) { return static_cast<int>(random_() % most); };
        const int turn = machine % 4 == 0 ? kMostTime : std::min(kMostTime, 30);
        const hls::PulseTimes times{any(8), any(8), any(turn), any(turn)};
        bench_.set_times(times);
        kernel.set_times(times);
        const bool stalls = any(2) == 0;
        const bool jumps = any(4) == 0;
        const int64_t inverted = machine % 2 == 0 ? 0 : any(1 << kStepAxes);
        bench_->step_inverted_i = bench_->direction_inverted_i = inverted;

        std::vector<StepMotion> motions;
        for (int a = 0; a < kStepAxes; ++a) {
            motions.emplace_back(random_, kFineBits, kMotionScaleBits, 0.3 * kPeriod);
            bench_.set_scale(a, motions[a].scale());
            kernel.clock();
            kernel.set_scale(a, motions[a].scale());
        }
        std::deque<int64_t> synchroniser(2, 0);
        std::vector<int64_t> position(kStepAxes);
        int64_t last = 0;
        bool offered = false;
        const int samples = static_cast<int>(std::max<int64_t>(12, 8000 / kPeriod));
        for (int n = 0; n < samples;) {
            // Settings of a sample while none passes through the scaler.
            int64_t referenced = 0;
            if (!offered && any(static_cast<int>(kPeriod)) < 8) {
                referenced = n == 0 ? kAll : any(1 << kStepAxes) & any(1 << kStepAxes);
                const bool stop = any(16) == 0;
                bench_->limit_i = stop ? any(1 << kStepAxes) : 0;
                bench_->estop_i = any(64) == 0;
                stops += stop ? 1 : 0;
            }
            const bool offers = !offered && (!stalls || any(static_cast<int>(kPeriod)) == 0) &&
                                synchroniser[0] == synchroniser[1];
            if (offers) {
                for (int a = 0; a < kStepAxes; ++a) {
                    position[a] = motions[a].next(random_);
                    if (jumps && any(20) == 0) position[a] = -position[a];
                }
                bench_->begins_i = any(8) == 0;
                bench_.offer(position);
                offered = true;
            }
            synchroniser.push_back(bench_->limit_i | (bench_->estop_i ? kAll : 0));
            bench_->reference_i = to_port(referenced, kStepAxes);
            const bool taken = bench_.clock();
            for (int a = 0; a < kStepAxes; ++a) kernel.stop(a, synchroniser[0] >> a & 1);
            synchroniser.pop_front();
            kernel.clock();
            for (int a = 0; a < kStepAxes; ++a) {
                if (referenced >> a & 1) kernel.reference(a);
            }
            if (taken) {
                kernel.sample(position.data(), bench_->begins_i);
                offered = false;
                ++n;
            }
            int64_t step = 0;
            for (int a = 0; a < kStepAxes; ++a) {
                const hls::StepAxis& axis = kernel.axis(a);
                const bool inverts = inverted >> a & 1;
                step |= int64_t{axis.pulse().step()} << a;
                ASSERT_EQ(bench_.step(a), axis.pulse().step() != inverts) << bench_.now();
                ASSERT_EQ(bench_.direction(a), axis.pulse().direction() != inverts);
                ASSERT_EQ(bench_->referenced_o >> a & 1, axis.referenced());
                ASSERT_EQ(bench_->refused_o >> a & 1, axis.refused());
                ASSERT_EQ(bench_->overrun_o >> a & 1, axis.pulse().overrun());
                ASSERT_EQ(bench_->uncertain_o >> a & 1, axis.pulse().uncertain());
                refused += axis.refused() ? 1 : 0;
                overrun += axis.pulse().overrun() ? 1 : 0;
            }
            ASSERT_EQ(bench_->late_o, kernel.late());
            late += kernel.late() ? 1 : 0;
            steps += __builtin_popcountll(step & ~last);
            last = step;
        }
    }
    EXPECT_GT(steps, 10'000);
    EXPECT_GT(stops, 10);
    EXPECT_GT(late, 10);
    EXPECT_GT(refused, 10);
    EXPECT_GT(overrun, 10);
}

TEST_F(StepGenerator, TakesASampleInTheClocksThatItsHeaderSays) {
    begin();
    bench_.offer(everywhere(1));
    const int64_t offered = bench_.now();
    while (!bench_.clock()) {
    }
    EXPECT_EQ(bench_.now() - 1 - offered, kStepAxes * (kFineBits + 6));
}

// Scales, places and rates share a memory.
TEST_F(StepGenerator, TakesAScaleOfAnAxisInEveryClockOfASample) {
    const int last = kStepAxes - 1;
    for (int clock = 0; clock < kStepAxes * (kFineBits + 6) + 1; ++clock) {
        begin();
        bench_.offer(everywhere(1));
        bench_.clocks(clock);
        bench_.set_scale(last, 2 * kScale);
        count(kMove);
        bench_.reference(1 << last);
        bench_.sample(everywhere(2));
        EXPECT_EQ(count(kMove), last) << clock << ": a step of each, none of the last";
        bench_.sample(everywhere(5));
        EXPECT_EQ(count(kMove), 3 * last + 6) << clock;
    }
}

TEST_F(StepGenerator, GivesNoStepUntilAReferenceAndThenCountsFromThere) {
    begin();
    bench_.reset();
    for (int n = 0; n < 4; ++n) bench_.sample(everywhere(n * 3));
    EXPECT_EQ(count(kMove), 0);
    EXPECT_EQ(bench_.late(), 0) << "nothing counts";
    // Places between two steps: the axis stands at the nearest.
    for (const double place : {0.0, 100.25, -100.25, 0.499, -0.501, 7.5, -7.5}) {
        start(place);
        bench_.sample(everywhere(std::floor(place + 0.5) + 4));
        EXPECT_EQ(count(kMove), 4 * kStepAxes) << place;
        bench_.sample(everywhere(place));
        EXPECT_EQ(count(kMove), -4 * kStepAxes) << place;
    }
    EXPECT_EQ(bench_->refused_o, 0);
}

TEST_F(StepGenerator, PlacesAreAbsoluteInAllOfTheRange) {
    for (const int64_t scale : {(int64_t{1} << kMotionScaleBits) - 1, kScale / 3, int64_t{65537}}) {
        begin();
        const int64_t end = (int64_t{1} << (kFineBits - 1)) - 1;
        std::vector<int64_t> counts;
        for (int64_t from : {-end - 1, end, int64_t{-1}, int64_t{0}, end / 3}) {
            for (int a = 0; a < kStepAxes; ++a) bench_.set_scale(a, scale);
            // Forward beyond the end, and back in one sample.
            const auto units =
                static_cast<int64_t>(0.3 * kPeriod * 65536 * std::exp2(kFineBits) / scale);
            const int64_t to = from > 0 ? from - std::min(units, end) : from + std::min(units, end);
            bench_.reference();
            bench_.sample(std::vector<int64_t>(kStepAxes, from));
            count(kMove);
            bench_.sample(std::vector<int64_t>(kStepAxes, to));
            const ref::StepCrossings crossings(1, int64_t{1} << hls::kStepFraction);
            const int64_t expected = crossings.count(exact_place(to, scale, kFineBits)) -
                                     crossings.count(exact_place(from, scale, kFineBits));
            EXPECT_EQ(count(kMove), expected * kStepAxes) << scale << " from " << from;
        }
    }
}

TEST_F(StepGenerator, RunsUpToHalfAStepPerClockAndRefusesMore) {
    const double half = static_cast<double>(kPeriod) / 2;
    const double least = 1.0 / 512;
    begin();
    for (int n = 1; n <= 20; ++n) bench_.sample(everywhere(n % 2 * (half - 1)));
    for (const double steps : {0.49 * kPeriod, half - least}) {
        start(0);
        bench_.sample(everywhere(steps));
        EXPECT_EQ(count(kMove), static_cast<int64_t>(std::floor(steps + 0.5)) * kStepAxes);
        bench_.sample(everywhere(0));
        EXPECT_EQ(count(kMove), -static_cast<int64_t>(std::floor(steps + 0.5)) * kStepAxes);
    }
    EXPECT_EQ(bench_->refused_o, 0);
    // The fourth is a whole turn of the word.
    for (const double steps : {half, 2 * half, 3 * half, 4 * half, -half - least}) {
        start(-steps / 2);
        EXPECT_EQ(bench_->refused_o, 0) << "a reference clears it";
        bench_.sample(everywhere(steps / 2));
        EXPECT_EQ(count(kMove), 0) << steps;
        EXPECT_EQ(bench_->refused_o, kAll);
        EXPECT_EQ(bench_->referenced_o, 0);
        bench_.sample(everywhere(steps / 2 + 3));
        EXPECT_EQ(count(kMove), 0) << "it needs a reference";
    }
}

TEST_F(StepGenerator, SamplesThatComeLateAreReportedWhenItMoves) {
    begin();
    EXPECT_EQ(count(5 * kPeriod), 0);
    EXPECT_EQ(bench_.late(), 0) << "it stands";
    bench_.sample(everywhere(3));
    to_tick();
    bench_.clock();
    EXPECT_EQ(bench_->late_o, 0);
    int64_t steps = count(kPeriod - 2);
    EXPECT_EQ(bench_->late_o, 0);
    steps += count(1);
    EXPECT_EQ(bench_->late_o, 1);
    steps += count(1);
    EXPECT_EQ(bench_->late_o, 0) << "once";
    steps += count(3 * kPeriod);
    EXPECT_EQ(steps, 3 * kStepAxes) << "and it waits where it is";
    EXPECT_EQ(bench_.late(), 1);
    bench_.sample(everywhere(5));
    EXPECT_EQ(count(kMove), 2 * kStepAxes);
    EXPECT_EQ(bench_.late(), 2) << "and again";
}

TEST_F(StepGenerator, StopsReachThePinsOneClockAfterTheSynchroniser) {
    const hls::PulseTimes times{5, 3, 2, 2};
    int cut = 0;
    int whole = 0;
    for (int offset = 0; offset < 64; ++offset) {
        const int64_t estop = offset % 2;
        const int64_t limit = estop != 0 ? 0 : 1 + offset / 2 % kAll;
        const int64_t stopped = estop != 0 ? kAll : limit;
        begin(times);
        std::array<int, kStepAxes> lengths{};  // of the present pulse, or the last one
        bench_.each_clock = [&] {
            for (int a = 0; a < kStepAxes; ++a) {
                const bool step = bench_.step(a);
                if (step) lengths[a] = (high_ >> a & 1) != 0 ? lengths[a] + 1 : 1;
            }
            high_ = bench_->step_o;
        };
        bench_.sample(everywhere(static_cast<double>(kPeriod) / 16));
        to_tick();
        bench_.clocks(20 + offset / 2);
        bench_->estop_i = static_cast<unsigned>(estop);
        bench_->limit_i = to_port(limit, kStepAxes);
        bench_.clocks(2);  // through both flip-flops
        const int64_t high = bench_->step_o & stopped;
        const int64_t directions = bench_->direction_o;
        bench_.clock();
        bench_.each_clock = {};
        EXPECT_EQ(bench_->step_o & stopped, 0) << offset;
        EXPECT_EQ(bench_->referenced_o, kAll & ~stopped);
        for (int a = 0; a < kStepAxes; ++a) {
            const bool short_pulse = (high >> a & 1) != 0 && lengths[a] < times.steplen;
            EXPECT_EQ(bench_->uncertain_o >> a & 1, short_pulse) << offset << " axis " << a;
            if (high >> a & 1) ++(short_pulse ? cut : whole);
        }
        // The state stays after the input is gone, until the next reference.
        bench_->estop_i = 0;
        bench_->limit_i = 0;
        const int64_t uncertain = bench_->uncertain_o;
        bench_.sample(everywhere(0));
        for (int n = 0; n < 2 * kPeriod; ++n) {
            bench_.clock();
            ASSERT_EQ(bench_->step_o & stopped, 0) << offset;
            ASSERT_EQ((bench_->direction_o ^ directions) & stopped, 0) << offset;
        }
        EXPECT_EQ(bench_->uncertain_o, uncertain);
        start(0);
        EXPECT_EQ(bench_->uncertain_o, 0);
    }
    EXPECT_GT(cut, 5);
    EXPECT_GT(whole, 0);
}

TEST_F(StepGenerator, PinsRestAtTheirLevels) {
    bench_->step_inverted_i = kAll;
    bench_->direction_inverted_i = kAll;
    begin();
    EXPECT_EQ(bench_->step_o, kAll);
    EXPECT_EQ(bench_->direction_o, kAll);
    bench_->estop_i = 1;
    bench_.clocks(8);
    EXPECT_EQ(bench_->step_o, kAll);
}

}  // namespace
}  // namespace curvecore::tb
