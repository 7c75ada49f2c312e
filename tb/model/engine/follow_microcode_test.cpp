// SPDX-License-Identifier: Apache-2.0
// Samples of streams of segments, rtl/engine/programs/follow.asm and segment.asm with the programs
// of the curves, are those of hls::MotionKernel: over steps and segments, those without length, to
// their ends, and where the next segment comes late.
#include <gtest/gtest.h>

#include "tb/support/microcode/follow_comparison.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::follow_microcode_test {

TEST(FollowMicrocode, EqualsTheKernelInEveryConfiguration) {
    std::int64_t samples = 0;
    std::int64_t words = 0;
    for (CurveCase& of : configurations()) {
        of.core.splines = of.spline ? 1 : 0;
        const assembler::Assembly assembly = follow_microcode(of.core, kLargeStore);
        MicrocodeMachine machine(assembly);
        FollowComparison comparison(of.core, assembly, machine, 3);
        int differ = 0;
        int drawn = 0;
        while (drawn < cases(600, 100000) && differ == 0) {
            differ += comparison.sample();
            ++drawn;
        }
        EXPECT_EQ(differ, 0) << text(of) << ": sample " << drawn;
        EXPECT_EQ(comparison.ranges().missing(), 0) << text(of);
        EXPECT_FALSE(machine.hazard()) << text(of);
        EXPECT_GT(comparison.kernel().segments(), drawn / 20) << text(of);
        EXPECT_GT(comparison.kernel().steps(), comparison.kernel().segments() * 3 / 2) << text(of);
        EXPECT_GT(comparison.kernel().empty_segments(), 0) << text(of);
        EXPECT_GT(comparison.landings(), 0) << text(of);
        samples += drawn;
        words += comparison.words();
    }
    EXPECT_GE(samples, 100000);
    std::printf("%lld samples, %lld words\n", static_cast<long long>(samples),
                static_cast<long long>(words));
}

TEST(FollowMicrocode, KeepsItsBounds) {
    for (const int which : {0, 1, 2, 3}) {
        sysc::CoreParameters core;
        core.mode = which % 2;
        core.splines = which / 2;
        const assembler::Assembly assembly = follow_microcode(core);
        MicrocodeMachine machine(assembly);
        FollowComparison comparison(core, assembly, machine, 4);
        int differ = 0;
        for (int n = 0; n < 10000 && differ == 0; ++n) differ += comparison.sample();
        EXPECT_EQ(differ, 0);
        const FollowClocks& bound = comparison.bounds();
        const FollowClocks& most = comparison.most();
        std::printf(
            "Mode %d, Splines %d: %d clocks a sample, %d a step, %d a segment; seen %d %d %d\n",
            core.mode, core.splines, bound.sample, bound.step, bound.segment, most.sample,
            most.step, most.segment);
        EXPECT_EQ(most.sample, bound.sample);
        EXPECT_LE(most.step, bound.step);
        EXPECT_GE(most.step, bound.step - 60);
        EXPECT_LE(most.segment, bound.segment);
        EXPECT_GE(most.segment, bound.segment - 60);
    }
}

TEST(FollowMicrocode, AQueueOfPartsOfSegmentsIsRefused) {
    try {
        follow_microcode({}, {}, -kEntries);
        ADD_FAILURE() << "it has room for two segments and 16 words";
    } catch (const assembler::AssemblyError& error) {
        EXPECT_STREQ(error.what(),
                     "segment.asm: error: the queue holds whole segments, of 17 words");
    }
}

TEST(FollowMicrocode, AChangedInstructionIsSeen) {
    for (const int mode : {0, 1}) {
        sysc::CoreParameters core;
        core.splines = 1;
        core.mode = mode;
        core.aux_axes = 1;
        const assembler::Assembly assembly = follow_microcode(core, {2048, 512, 1});
        const MutantShare share = seen_mutants(
            assembly, static_cast<std::size_t>(cases(29, 1)),
            [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
                MicrocodeMachine machine(assembly, program, &trace);
                for (std::uint32_t seed = 1; seed <= 2; ++seed) {
                    FollowComparison comparison(core, assembly, machine, seed);
                    for (int n = 0; n < 300; ++n) {
                        if (comparison.sample() > 0) return true;
                    }
                }
                return !machine.starts_hold();
            },
            [](const std::string& file) {  // others: curve_microcode_test.cpp
                return file.find(".net") == std::string::npos && file != kOfFollowTest;
            });
        EXPECT_EQ(share.deleted, "");
        // The rest: small words with fewer limbs, a sign taken higher up, a way to the same place.
        share.expect(0.99);
    }
}

}  // namespace curvecore::tb::follow_microcode_test
