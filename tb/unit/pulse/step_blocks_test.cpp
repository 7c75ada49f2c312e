// SPDX-License-Identifier: Apache-2.0
// Both step blocks of the system: the kernel, which skips clocks, changes the pins in the same
// clocks as the Verilated step generator.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "Vstep_generator.h"
#include "sysc/steps/rtl_steps.hpp"
#include "tb/support/pins/step_motion.hpp"

namespace curvecore::tb {
namespace {

using namespace sysc;

constexpr double kPeriod = 1 << CFG_PeriodLog2;

class StepBlocks : public testing::Test {
  protected:
    int any(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most)); }

    StepSetup any_setup() {
        StepSetup setup;
        setup.axes = CFG_Axes;
        setup.period_log2 = CFG_PeriodLog2;
        setup.scale = (std::int64_t{1} << (30 + any(25))) + any(1 << 30);
        const int turn = any(4) == 0 ? 600 : 12;
        setup.times = {any(9), any(9), any(turn), any(turn)};
        return setup;
    }

    /// Continues at some steps per period, sometimes more than the pulses allow.
    void move(std::vector<double>& speed, std::vector<std::int64_t>& position,
              const StepSetup& setup) {
        const double units = std::exp2(kStepFineBits + 16) / static_cast<double>(setup.scale);
        const double most = std::exp2(kStepFineBits - 2);
        for (std::size_t a = 0; a < position.size(); ++a) {
            if (any(4) == 0) speed[a] = kPeriod * (any(2001) - 1000) / 1000 * std::exp2(-any(9));
            if (any(8) == 0) speed[a] = 0;
            if (any(200) == 0) speed[a] = kPeriod;  // refused
            if (std::abs(static_cast<double>(position[a]) + speed[a] * units) > most) speed[a] = 0;
            position[a] += std::llround(speed[a] * units) + any(3) - 1;
        }
    }

    std::mt19937_64 random_{1};
};

TEST_F(StepBlocks, ChangeThePinsInTheSameClocks) {
    std::size_t seen = 0;
    int overruns = 0;
    int refused = 0;
    for (int machine = 0; machine < (kPeriod > 1000 ? 10 : 60); ++machine) {
        const StepSetup setup = any_setup();
        const auto kernel = make_kernel_steps(setup);
        RtlSteps<Vstep_generator> rtl(setup, CFG_Axes);
        std::vector<double> speed(CFG_Axes);
        std::vector<std::int64_t> position(CFG_Axes);
        std::vector<PinChange> expected;
        std::vector<PinChange> changes;
        for (int n = 0; n < 100; ++n) {
            const bool late = any(16) == 0;
            if (!late) move(speed, position, setup);
            kernel->period(late ? nullptr : position.data(), changes);
            rtl.period(late ? nullptr : position.data(), expected);
            const auto differ =
                std::mismatch(expected.begin(), expected.end(), changes.begin(), changes.end());
            ASSERT_TRUE(changes == expected)
                << "machine " << machine << " period " << n << ": change "
                << differ.first - expected.begin() << " of " << expected.size() << " and "
                << changes.size();
        }
        seen += expected.size();
        for (int a = 0; a < CFG_Axes; ++a) {
            ASSERT_EQ(kernel->flags(a).overrun, rtl.flags(a).overrun) << machine << " axis " << a;
            ASSERT_EQ(kernel->flags(a).refused, rtl.flags(a).refused) << machine << " axis " << a;
            overruns += kernel->flags(a).overrun ? 1 : 0;
            refused += kernel->flags(a).refused ? 1 : 0;
        }
    }
    printf("%zu changes, %d overruns, %d refused\n", seen, overruns, refused);
    EXPECT_GT(seen, 10000U);
    EXPECT_GT(overruns, 0);
    EXPECT_GT(refused, 0);
}

/// Control: the comparison detects one clock more of a time.
TEST_F(StepBlocks, ComparisonSeesOneClock) {
    StepSetup setup;
    setup.axes = CFG_Axes;
    setup.period_log2 = CFG_PeriodLog2;
    setup.scale = std::int64_t{1} << kStepFineBits;
    setup.times = {2, 2, 3, 3};
    const auto steps = [&] {
        const auto block = make_kernel_steps(setup);
        std::vector<PinChange> changes;
        for (const std::int64_t place : {0, 400000, 800000, 0, 0}) {
            const std::vector<std::int64_t> position(CFG_Axes, place);
            block->period(position.data(), changes);
        }
        return changes;
    };
    const std::vector<PinChange> before = steps();
    ++setup.times.steplen;
    EXPECT_GT(before.size(), 20U);
    EXPECT_FALSE(steps() == before);
}

}  // namespace
}  // namespace curvecore::tb
