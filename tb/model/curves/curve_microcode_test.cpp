// SPDX-License-Identifier: Apache-2.0
// Microcode that the assembler makes of ref/curves/ draws the kernels' words, in every
// configuration of tb/configurations.csv; an instruction deleted or a field changed is seen.
#include <gtest/gtest.h>

#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/support/microcode/curve_comparison.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::curve_microcode_test {

TEST(CurveMicrocode, EqualsTheKernelsInEveryConfiguration) {
    std::int64_t words = 0;
    for (const CurveCase& of : configurations()) {
        const CurveMicrocode code = curve_microcode(of, kLargeStore);
        MicrocodeMachine machine(code.assembly);
        CurveComparison comparison(of, code, machine);
        std::mt19937_64 random(7);
        int differ = 0;
        for (int n = 0; n < 12; ++n) differ += comparison.segment(random, 3, 3);
        EXPECT_EQ(differ, 0) << text(of);
        EXPECT_EQ(comparison.ranges().missing(), 0) << text(of);
        EXPECT_FALSE(machine.hazard()) << text(of);
        words += comparison.words();
    }
    EXPECT_GT(words, 100000);
}

TEST(CurveMicrocode, AChangedInstructionIsSeen) {
    for (const bool spline : {false, true}) {
        for (const int mode : {0, 1}) {
            CurveCase of;
            of.spline = spline;
            of.core.mode = mode;
            const CurveMicrocode code = curve_microcode(of);
            const std::string name = spline ? "spline" : "arc";
            const int clocks[] = {worst_case(code.assembly, name + "_load", {"idle"}),
                                  worst_case(code.assembly, name + "_step", {"idle"}),
                                  worst_case(code.assembly, name + "_sample", {"idle"})};
            const MutantShare share =
                seen_mutants(code.assembly, static_cast<std::size_t>(cases(29, 1)),
                             [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
                                 MicrocodeMachine machine(code.assembly, program, &trace);
                                 CurveComparison comparison(of, code, machine);
                                 std::mt19937_64 random(1);
                                 int differ = 0;
                                 for (int n = 0; n < 8 && differ == 0; ++n) {
                                     differ = comparison.segment(random, 3, 3);
                                 }
                                 for (int part = 0; part < 3; ++part) {
                                     differ += comparison.most_clocks(part) > clocks[part] ? 1 : 0;
                                 }
                                 return differ > 0;
                             });
            EXPECT_EQ(share.deleted, "") << text(of);
            share.expect(0.99);
        }
    }
}

}  // namespace curvecore::tb::curve_microcode_test
