// SPDX-License-Identifier: Apache-2.0
// scripts/flat.sh: its file, and invalid command lines. A test of tb/unit shows that the file is
// equivalent to the sources.
#include <gtest/gtest.h>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::flat_command_test {

using testing::IsNotSubstring;
using testing::IsSubstring;

struct BadCommand {
    std::vector<std::string> options;
    std::string message;
};

TEST(FlatCommand, RefusesWhatItDoesNotKnow) {
    const std::vector<BadCommand> bad{
        {{}, "A core as one file of Verilog-2005"},
        {{"circle"}, "flat: rtl/ has no module 'circle'"},
        {{"multiplier", "horner"}, "flat: one module at a time: multiplier or horner"},
        {{"multiplier", "Degree=3"}, "flat: multiplier has no parameter Degree"},
        {{"multiplier", "ABits=six"}, "flat: 'ABits=six' must be Name=Value, a whole number"},
        {{"multiplier", "-o"}, "flat: -o needs a file"},
        {{"multiplier", "--out"}, "flat: unknown option '--out'"},
    };
    const ProgramRun flat(FLAT_SH);
    for (const BadCommand& one : bad) {
        const ProgramResult result = flat.run(one.options);
        EXPECT_EQ(result.status, 2) << one.message;
        EXPECT_EQ(result.err.substr(0, one.message.size()), one.message);
    }
}

TEST(FlatCommand, MakesNoFileOfACoreThatCannotBe) {
    const ProgramRun flat(FLAT_SH);
    const ProgramResult result = flat.run({"multiplier", "ABits=37", "-o", "m.v"});
    EXPECT_EQ(result.status, 1);
    EXPECT_PRED_FORMAT2(IsSubstring, "flat: multiplier cannot be made with ABits=37", result.err);
    EXPECT_FALSE(flat.exists("m.v"));
}

TEST(FlatCommand, MakesOneFileWithoutPathsOrSystemVerilog) {
    const ProgramRun flat(FLAT_SH);
    EXPECT_EQ(flat.run({"spherical_interpolator", "Order=2", "-o", "made/core.v"}).status, 0);
    const std::string text = flat.read("made/core.v");
    EXPECT_PRED_FORMAT2(IsSubstring, "\nmodule spherical_interpolator(clk_i, rst_ni, ", text);
    EXPECT_PRED_FORMAT2(IsSubstring, "\nmodule spherical_interpolator_local_copy_", text);
    EXPECT_PRED_FORMAT2(IsSubstring, "Order=2: made by scripts/flat.sh", text);
    for (const std::string other : {"always_ff", "logic ", "paramod", "src = "}) {
        EXPECT_PRED_FORMAT2(IsNotSubstring, other, text);
    }
}

}  // namespace curvecore::tb::flat_command_test
