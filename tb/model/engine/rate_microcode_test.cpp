// SPDX-License-Identifier: Apache-2.0
// The microcode of time: the rate is that of hls::TimeScaler with any events, and rates, branches
// and path together are those of the kernels, whatever is queued.
#include <gtest/gtest.h>

#include "tb/model/engine/time_microcode.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

TEST(RateMicrocode, EqualsTheScalerWithAnyEvents) {
    const assembler::Assembly assembly = time_microcode();
    MicrocodeMachine machine(assembly);
    RateComparison comparison(assembly, machine);
    std::mt19937_64 random(1);
    for (int n = 0; n < cases(300, 30000); ++n) {
        comparison.ticks(random, n % 4 == 0 ? 700 : 100);
        ASSERT_EQ(comparison.differ(), 0) << n;
    }
    EXPECT_GT(comparison.stop_ticks(), 200);
    EXPECT_GT(comparison.words(), 100000);
    EXPECT_FALSE(machine.hazard());
}

TEST(RateMicrocode, EqualsTheKernelsOfTimeAndPath) {
    const assembler::Assembly assembly = time_microcode();
    MicrocodeMachine machine(assembly);
    PathTimeComparison comparison(assembly, machine);
    for (int n = 1; n <= cases(130, 13000); ++n) {
        comparison.program(static_cast<std::uint32_t>(n), 12, n % 3 == 0 ? 3 : 100, 800);
        ASSERT_EQ(comparison.differ(), 0) << n;
    }
    EXPECT_GT(comparison.ticks(), 100000);
    EXPECT_GT(comparison.stop_ticks(), 2000);
    EXPECT_FALSE(machine.hazard());
    EXPECT_LE(comparison.bounds()[kRate], 750);
    EXPECT_LE(comparison.bounds()[kFetch], 2200);
    // The longest way takes and ends a step, and follows a target too: no tick does.
    EXPECT_GE(comparison.most()[kRate], comparison.bounds()[kRate] - 220);
}

}  // namespace
}  // namespace curvecore::tb
