// SPDX-License-Identifier: Apache-2.0
// Programs of posts, senders and slicers, and those of bug reports, as their owners would start
// them: without options or edits. tb/model/gcode/posts_test.cpp checks their moves.
#include <gtest/gtest.h>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::posts_plan_test {

namespace fs = std::filesystem;

class PostsPlan : public testing::TestWithParam<const char*> {};

TEST_P(PostsPlan, EveryProgramRunsToItsEnd) {
    const ProgramRun program;
    int programs = 0;
    for (const auto& entry : fs::directory_iterator(std::string(DATA_DIR) + '/' + GetParam())) {
        const fs::path& file = entry.path();
        if (file.extension() == ".md" || file.filename() == "figures.csv") continue;
        const ProgramResult result =
            program.run({"plan", file.string(), "-q", "--no-segments", "-o", "out"});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(program.exists("out/report.json")) << file;
        fs::remove_all(program.folder() / "out");
        ++programs;
    }
    EXPECT_GE(programs, 10);
}

INSTANTIATE_TEST_SUITE_P(Folder, PostsPlan, testing::Values("posts", "cases"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace curvecore::tb::posts_plan_test
