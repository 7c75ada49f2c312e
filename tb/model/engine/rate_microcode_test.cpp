// SPDX-License-Identifier: Apache-2.0
// The microcode of time: the rate is that of hls::TimeScaler with any events, and rates, branches
// and path together are those of the kernels, whatever is queued; an instruction deleted or a field
// changed is seen.
#include <gtest/gtest.h>

#include "tb/model/engine/microcode_mutants.hpp"
#include "tb/model/engine/path_time_comparison.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

TEST(RateMicrocode, EqualsTheScalerWithAnyEvents) {
    const assembler::Assembly assembly = time_microcode();
    MicrocodeMachine machine(assembly);
    RateComparison comparison(assembly, machine);
    std::mt19937_64 random(1);
    for (int n = 0; n < cases(300, 30000); ++n) {
        comparison.ticks(random, n % 4 == 0 ? 500 : n % 4 == 1 ? 3 : 100);
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
    EXPECT_FALSE(machine.strays());
    EXPECT_LE(comparison.bounds()[kRate], 610);
    EXPECT_LE(comparison.bounds()[kFetch], 1100);
    // The longest way of all lands and follows: no tick does.
    EXPECT_GE(comparison.most()[kRate], comparison.bounds()[kRate] - 70);
}

TEST(RateMicrocode, AChangedInstructionIsSeen) {
    const assembler::Assembly assembly = time_microcode();
    const MutantShare share = seen_mutants(
        assembly, static_cast<std::size_t>(cases(97, 1)),
        [&](const std::vector<std::uint32_t>& program) {
            MicrocodeMachine rate_machine(assembly, program);
            RateComparison rate(assembly, rate_machine);
            std::mt19937_64 random(1);
            for (int n = 0; n < 90 && rate.differ() == 0; ++n) {
                rate.ticks(random, n % 3 == 0 ? 4 : n % 3 == 1 ? 300 : 80);
            }
            if (rate.differ() > 0 || rate_machine.strays()) return true;
            MicrocodeMachine path_machine(assembly, program);
            PathTimeComparison path(assembly, path_machine);
            for (std::uint32_t n = 1; n < 12 && path.differ() == 0; ++n) {
                path.program(n, 5, n % 3 == 0 ? 3 : 100, 300);
            }
            return path.differ() > 0 || path_machine.strays();
        },
        [](const std::string& file) { return file.find("path.asm") == std::string::npos; });
    EXPECT_EQ(share.deleted, "");
    // The rest changes no word: another 0 is added, another number than 1 is true, a jump ends
    // where the same happens.
    EXPECT_GE(share.seen, 0.97 * share.mutants) << "of " << share.mutants;
}

}  // namespace
}  // namespace curvecore::tb
