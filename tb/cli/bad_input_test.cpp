// SPDX-License-Identifier: Apache-2.0
// Invalid inputs of bad_input_cases.json: each is refused with status 2 and its exact message, and
// leaves nothing behind.
#include <gtest/gtest.h>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/bad_input_case.hpp"

namespace curvecore::tb::bad_input_test {

using Json = nlohmann::json;

class BadInputFile : public testing::TestWithParam<Json> {};

TEST_P(BadInputFile, IsRefused) {
    const Json& bad = GetParam();
    const ProgramRun program;
    write_bad_input(program.folder(), bad);
    const std::string file = bad.at("file");
    std::vector<std::string> arguments{"plan", file, "-o", "out"};
    std::string expected = with_path(bad.at("stderr"), "FILE", file);
    if (bad.contains("fit")) {
        arguments.insert(arguments.end(), {"--fit", bad["fit"].get<std::string>()});
    }
    if (bad.contains("ends")) {
        arguments.insert(arguments.end(), {"--ends", bad["ends"].get<std::string>()});
    }
    if (bad.contains("machine")) {
        write_bad_input(program.folder(), bad["machine"]);
        const std::string machine = bad["machine"].at("file");
        arguments.insert(arguments.end(), {"--machine", machine});
        expected = with_path(expected, "MACHINE", machine);
    }
    const std::vector<std::string> before = program.files();
    const ProgramResult result = program.run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, expected + "\n");
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(program.files(), before);
}

INSTANTIATE_TEST_SUITE_P(Cli, BadInputFile, testing::ValuesIn(bad_input_cases(BAD_INPUT_CASES)),
                         [](const auto& test) {
                             return test.param.at("name").template get<std::string>();
                         });

}  // namespace curvecore::tb::bad_input_test
