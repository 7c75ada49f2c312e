// SPDX-License-Identifier: Apache-2.0
// Blocks that `compare` counts, beside the cells that Yosys makes of the same cores.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::synth_cells_test {

using Json = nlohmann::json;

/// The tools themselves, half a minute a core.
class LongSynthCells : public testing::Test {
  protected:
    /// DSP and RAM blocks of a serial core in an XC7A35T.
    static std::pair<int, int> synthesised(const std::string& core, const std::string& bits) {
        const ProgramRun shell("/bin/sh");
        const std::string tools = std::filesystem::path(SYNTH_PYTHON).parent_path();
        const ProgramResult result = shell.run(
            {"-c", "PATH=" + tools + ":$PATH " SYNTH_PYTHON " " SYNTH_PY " --output out --core " +
                       core + " --build serial --device xc7a35t --set CoefBits=" + bits});
        EXPECT_EQ(result.status, 0) << result.err;
        const Json json =
            Json::parse(shell.read("out/" + core + "-serial-xc7a35t-CoefBits" + bits + ".json"));
        return {json.at("dsp"), json.at("bram")};
    }

    static std::pair<int, int> counted(const std::string& program, const std::string& bits) {
        const ProgramRun compare;
        compare.write("part.ngc", program);
        const ProgramResult result =
            compare.run({"compare", "part.ngc", "-q", "-o", "out", "--build", "serial", "--device",
                         "xc7a35t", "--samples", "100", "--set", "CoefBits=" + bits});
        EXPECT_EQ(result.status, 0) << result.err;
        const Json json = Json::parse(compare.read("out/compare.json"));
        const Json& estimate = json.at("rows").at(0).at("estimate");
        return {estimate.at("dsp"), estimate.at("ram")};
    }
};

TEST_F(LongSynthCells, AreTheBlocksThatCompareCounts) {
    for (const std::string bits : {"18", "22", "36"}) {
        EXPECT_EQ(counted("F600 G3 X10 Y10 I10\nM2\n", bits), synthesised("spherical", bits))
            << bits;
    }
    EXPECT_EQ(counted("F600 G5 X10 Y10 I5 J0 P0 Q-5\nM2\n", "36"), synthesised("curve", "36"));
}

}  // namespace curvecore::tb::synth_cells_test
