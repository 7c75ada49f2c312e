// SPDX-License-Identifier: Apache-2.0
// Programs of any length, feed and kind in bounded memory.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/long_programs.hpp"

namespace curvecore::tb::memory_test {

constexpr long kMostKib = 64 * 1024;

/// A command with its arguments.
class Memory : public testing::TestWithParam<std::vector<std::string>> {
  protected:
    long peak_kib(const std::string& name, const std::string& text,
                  const std::vector<std::string>& more) const {
        program_.write(name, text);
        std::vector<std::string> arguments = GetParam();
        arguments.insert(arguments.end(), {name, "-q", "-o", "out"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.peak_kib;
    }

  private:
    ProgramRun program_;
};

class MovesMemory : public Memory {};

TEST_P(MovesMemory, HasABoundForLongMoves) {
    const std::vector<std::string> rules{"--effort", "rules"};
    EXPECT_LT(peak_kib("part.ngc", strokes(3500, "G64 P0.01"), rules), kMostKib);
    EXPECT_LT(peak_kib("part.ngc", waves(3500, "G61"), rules), kMostKib);
    EXPECT_LT(peak_kib("part.ngc", waves(1500, "G64 P0.01"), rules), kMostKib);
}

TEST_P(Memory, DoesNotGrowWithTheProgram) {
    const std::vector<std::string> rules{"--effort", "rules"};
    const long short_one = peak_kib("part.ngc", raster(15000, "G61"), rules);
    const long long_one = peak_kib("part.ngc", raster(60000, "G61"), rules);
    EXPECT_LT(long_one, kMostKib);
    EXPECT_LT(long_one, 1.25 * static_cast<double>(short_one));
}

/// A print has many pieces a line; a move alone has half a kilobyte.
TEST_P(Memory, DoesNotGrowWithAPrint) {
    constexpr int kShort = 10000;
    constexpr int kLong = 40000;
    constexpr double kBytes = 160;  // a line: 20 to 142 are taken; `plan` with all pieces took 244
    const std::vector<std::string> fast{"--sample-period", "1ms"};
    const long before = peak_kib("print.gcode", print(kShort), fast);
    const long after = peak_kib("print.gcode", print(kLong), fast);
    EXPECT_LT(after, kMostKib);
    EXPECT_LT(static_cast<double>(after - before) * 1024, kBytes * (kLong - kShort));
}

class LongMemory : public Memory {};

TEST_P(LongMemory, HasABoundForProgramsOfManyLines) {
    constexpr int kLines = 172275;
    EXPECT_LT(peak_kib("print.gcode", print(kLines), {}), kMostKib);
    EXPECT_LT(peak_kib("waves.ngc", waves(kLines / 4, "G64 P0.01"), {}), kMostKib);
    EXPECT_LT(peak_kib("raster.ngc", raster(kLines, "G64 P0.01"), {}), kMostKib);
}

const std::vector<std::string> kWords{"words"};
const std::vector<std::string> kPlan{"plan", "--no-segments"};
const std::vector<std::string> kRun{"run", "--no-segments", "--on", "kernel"};
const auto kCommands = testing::Values(kWords, kPlan, kRun);
std::string name_of(const testing::TestParamInfo<std::vector<std::string>>& of) {
    return of.param.front();
}
INSTANTIATE_TEST_SUITE_P(Of, Memory, kCommands, name_of);
INSTANTIATE_TEST_SUITE_P(Of, MovesMemory, testing::Values(kWords, kPlan), name_of);
INSTANTIATE_TEST_SUITE_P(Long, MovesMemory, testing::Values(kRun), name_of);  // half a minute
INSTANTIATE_TEST_SUITE_P(Long, LongMemory, kCommands, name_of);

/// Motions that take hours: chords, and two lines.
TEST(SlowPrograms, AreInTheSameMemory) {
    std::string chords = "G21 G90 G64 P0.01 F6\n";
    for (int i = 1; i <= 3000; ++i) {
        chords += fmt::format("G1 X{} Y{:.2f}\n", i / 300 % 2 == 0 ? i % 300 : 300 - i % 300,
                              i / 300 + i % 20 * 0.02);
    }
    const ProgramRun program;
    for (const std::string& text : {chords, std::string("G21 G90 F1\nG1 X900\nG1 X0\n")}) {
        program.write("part.ngc", text);
        const ProgramResult result = program.run({"words", "part.ngc", "-q", "-o", "out"});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_LT(result.peak_kib, 64 * 1024) << text.substr(0, 40);
    }
}

}  // namespace curvecore::tb::memory_test
