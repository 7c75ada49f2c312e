// SPDX-License-Identifier: Apache-2.0
// `curvecore run` with cores that are not built in: it makes and keeps them, or reports why it
// cannot.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::core_cache_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

constexpr char kPart[] = "G21 G90 F900\nG1 X1\nG3 X2 Y1 I0 J1\nM2\n";

/// The smallest core that draws the part, and the folder in which cores are kept.
class MadeCore : public testing::Test {
  protected:
    void SetUp() override {
        shell_.write("part.ngc", kPart);
        setenv("CURVECORE_CORES", cores().c_str(), 1);
    }

    fs::path cores() const { return shell_.folder() / "cores"; }

    /// Runs a script such as `$RUN OUT &` by a shell.
    ProgramResult run(const std::string& script) const {
        const std::string command =
            "RUN() { folder=$1; shift; '" CURVECORE_PROGRAM
            "' run part.ngc -o $folder --build engine --set Order=3 --set CoefBits=24 "
            "--set GuardBits=6 --unit 1um \"$@\"; }\n";
        return shell_.run({"-c", command + script});
    }

    std::vector<fs::path> made() const {
        std::vector<fs::path> all;
        for (const auto& entry : fs::directory_iterator(cores())) {
            if (entry.is_directory()) all.push_back(entry.path());
        }
        return all;
    }

    /// Puts a tool of that name into a folder of its own.
    std::string tool(const std::string& name, const std::string& script) const {
        const fs::path folder = shell_.folder() / "tools";
        fs::create_directories(folder);
        std::ofstream(folder / name) << "#!/bin/sh\n" << script << "\n";
        fs::permissions(folder / name, fs::perms(0755));
        return folder;
    }

    ProgramRun shell_{"/bin/sh"};
};

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
    return found;
}

TEST_F(MadeCore, IsMadeOnceForTwoRunsAndKeptAndMadeAgainWhenBroken) {
    const ProgramResult both = run("RUN one & first=$!; RUN two; s=$?; wait $first && exit $s");
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_EQ(count(both.err, "making the core engine Order=3 CoefBits=24"), 1) << both.err;
    EXPECT_EQ(count(both.err, "waiting for another run that makes this core"), 1) << both.err;
    ASSERT_EQ(made().size(), 1U);
    EXPECT_TRUE(shell_.read("one/samples.csv") == shell_.read("two/samples.csv"));
    const Json report = Json::parse(shell_.read("one/report.json"));
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_EQ(report["parameters"]["Order"], 3);

    const ProgramResult kept = run("PATH=/nowhere RUN three");
    EXPECT_EQ(kept.status, 0) << kept.err;
    EXPECT_EQ(kept.err, "");
    EXPECT_TRUE(shell_.read("three/samples.csv") == shell_.read("one/samples.csv"));

    const fs::path file = made()[0] / "core.so";
    fs::resize_file(file, fs::file_size(file) / 2);
    const ProgramResult again = run("RUN four");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(count(again.err, "making the core"), 1) << again.err;
    EXPECT_TRUE(shell_.read("four/samples.csv") == shell_.read("one/samples.csv"));
}

TEST_F(MadeCore, OfTheEngineKeepsItsProgramsBesideIt) {
    const auto draw = [&](const std::string& out) {
        return shell_.run({"-c", "'" CURVECORE_PROGRAM "' run part.ngc -o " + out +
                                     " --build engine --set Order=3 --set CoefBits=24 --unit 1um"});
    };
    const ProgramResult once = draw("one");
    EXPECT_EQ(once.status, 0) << once.err;
    EXPECT_EQ(count(once.err, "making the core engine Order=3 CoefBits=24"), 1) << once.err;
    EXPECT_EQ(Json::parse(shell_.read("one/report.json"))["rtl_equals_kernel"], 0);
    EXPECT_EQ(draw("two").err, "");
    ASSERT_EQ(made().size(), 1U);
    const fs::path file = made()[0] / "program.hex";
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_EQ(count(draw("three").err, "making the core"), 1) << "with half of its program";
    EXPECT_TRUE(shell_.read("three/samples.csv") == shell_.read("one/samples.csv"));
}

/// A copy of the RTL is drawn as it stands; one with a sign changed is found out. One of its
/// modules is Verilog's.
TEST_F(MadeCore, OfAFolderOfOnesOwnIsHeldToTheKernel) {
    const auto draw = [&](const std::string& change, const std::string& options) {
        return shell_.run({"-c", change +
                                     "\n'" CURVECORE_PROGRAM "' run part.ngc --set Order=2 "
                                     "--set CoefBits=18 --unit 1um " +
                                     options});
    };
    const ProgramResult same = draw("cp -r " CURVES_DIR
                                    "/../../rtl fork && cd fork/arithmetic && mv fine_scale.sv "
                                    "fine_scale.v && cd ../..",
                                    "-o same --rtl fork");
    EXPECT_EQ(same.status, 0) << same.err;
    EXPECT_EQ(count(same.err, "making the core parallel"), 1) << same.err;
    EXPECT_EQ(Json::parse(shell_.read("same/report.json"))["rtl_equals_kernel"], 0);
    const ProgramResult linked = draw("ln -s fork link", "-o linked --rtl link");
    EXPECT_EQ(linked.status, 0) << linked.err;
    EXPECT_EQ(linked.err, "") << "the core of the folder";

    const ProgramResult wrong =
        draw("sed -i 's/{d_i, /{-d_i, /' fork/arithmetic/fine_scale.v", "-o wrong --rtl fork");
    EXPECT_EQ(wrong.status, 1) << wrong.err;
    EXPECT_NE(wrong.err.find(" words differ; first: sample "), std::string::npos) << wrong.err;
    EXPECT_NE(wrong.err.find(" of line 2: board fine x -4, kernel fine x 4"), std::string::npos)
        << wrong.err;

    const ProgramResult broken =
        draw("echo module >fork/motion_interpolator.sv", "-o broken --rtl fork -q");
    EXPECT_EQ(broken.status, 2);
    EXPECT_EQ(broken.err.substr(0, 24), "curvecore: error: --rtl ") << broken.err;
    EXPECT_NE(broken.err.find("motion_interpolator.sv:"), std::string::npos) << broken.err;
    EXPECT_FALSE(shell_.exists("broken"));
    EXPECT_EQ(made().size(), 2U) << "the first, the wrong one";
    for (const auto& [name, character] : {std::pair{"fork/a b", " "}, {"fork/line/a*", "*"}}) {
        const fs::path folder = shell_.folder() / name;
        fs::create_directory(folder);
        EXPECT_EQ(draw("", "--rtl fork").err,
                  "curvecore: error: --rtl '" + folder.string() +
                      "': no file of RTL can be read whose path has a '" + character + "'\n");
        fs::remove(folder);
    }
    EXPECT_EQ(draw("", "--rtl tools").err,
              "curvecore: error: --rtl 'tools': there is no motion_interpolator.sv\n");
    EXPECT_EQ(draw("", "--rtl fork --on kernel").err,
              "curvecore: error: --rtl: with --on rtl or systemc-rtl\n");
}

/// Verilator may have read a file before or after it changed.
TEST_F(MadeCore, OfFilesThatChangeMeanwhileIsNotKept) {
    const std::string tools = tool("verilator",
                                   "case $1 in --cc) echo >>fork/line/more.vh ;; esac\n"
                                   "exec /usr/bin/verilator \"$@\"");
    const ProgramResult result =
        run("cp -r " CURVES_DIR "/../../rtl fork\nPATH=" + tools + ":$PATH RUN out -q --rtl fork");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "curvecore: error: " + (shell_.folder() / "fork").string() +
                              ": files changed while the core was made from them: run it again\n");
    EXPECT_FALSE(shell_.exists("out"));
    EXPECT_TRUE(made().empty());
}

TEST_F(MadeCore, WithoutVerilatorSaysWhatToInstall) {
    const ProgramResult result = run("PATH=/nowhere RUN out");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err,
              "curvecore: error: this core is not built in, and verilator is missing to make it: "
              "install verilator, make and " COMPILER ", or run with --on kernel\n");
    EXPECT_FALSE(shell_.exists("out"));
}

TEST_F(MadeCore, WithAnotherVerilatorSaysWhichItNeeds) {
    const std::string tools = tool("verilator", "echo Verilator 4.038 2020-07-11");
    const ProgramResult result = run("PATH=" + tools + ":$PATH RUN out");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("here is Verilator 4.038 2020-07-11"), std::string::npos)
        << result.err;
    EXPECT_FALSE(shell_.exists("out"));
}

TEST_F(MadeCore, ThatCannotBeMadeLeavesNothingButItsLog) {
    const std::string tools =
        tool("verilator",
             "case $1 in --version) exec /usr/bin/verilator --version ;; esac\n"
             "echo no more space; exit 1");
    const ProgramResult result = run("PATH=" + tools + ":$PATH RUN out -q");
    EXPECT_EQ(result.status, 1);
    const std::string reason = "the core could not be made: no more space; see ";
    const std::size_t at = result.err.find(reason);
    ASSERT_NE(at, std::string::npos) << result.err;
    std::string log = result.err.substr(at + reason.size());
    log.pop_back();
    std::ifstream file(log);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "no more space");
    EXPECT_FALSE(shell_.exists("out"));
    EXPECT_TRUE(made().empty());
    EXPECT_EQ(run("RUN out -q").status, 0) << "a failure is not kept";
}

/// The answer of `choose` is drawn by `run`.
TEST_F(MadeCore, IsWhatChooseAnswered) {
    const ProgramRun program;
    const ProgramResult chosen =
        program.run({"choose", "--error", "1um", "--radius", "300mm", "--feed", "10m/min",
                     "--device", "ecp5-25", "--build", "parallel", "-o", "."});
    ASSERT_EQ(chosen.status, 0) << chosen.err;
    program.write("part.ngc",
                  "G21 G90 F10000\nG1 X100\nG3 X200 Y100 J100\nG2 X500 Y100 R150\nM2\n");
    const ProgramResult result =
        program.run({"run", "part.ngc", "-q", "-o", "out", "--core", "core.json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json choice = Json::parse(program.read("choose.json"))["choice"];
    const Json report = Json::parse(program.read("out/report.json"));
    EXPECT_EQ(report["build"], choice["build"]);
    for (const auto& [name, value] : report["parameters"].items()) {
        EXPECT_EQ(value, choice["parameters"][name]) << name;
    }
    EXPECT_EQ(report["rtl_equals_kernel"], 0);
    EXPECT_LE(report["unrounded"]["bound_lsb"], choice["bound_lsb"]);
}

}  // namespace curvecore::tb::core_cache_test
