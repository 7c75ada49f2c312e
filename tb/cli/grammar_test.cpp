// SPDX-License-Identifier: Apache-2.0
// The grammar that all commands share: units, folders, pipes, devices, names.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::grammar_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

class Grammar : public testing::Test {
  protected:
    Grammar() { program_.write("part.ngc", "G21 G90 G94 F600\nG1 X10\nG2 X20 Y10 I5 J5\nM2\n"); }

    Json plan(Arguments options) {
        options.insert(options.begin(), {"plan", "part.ngc", "-q", "-o", "out"});
        const ProgramResult result = program_.run(options);
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(program_.read("out/report.json"));
    }

    ProgramRun program_;
};

TEST_F(Grammar, AloneTheProgramPrintsItsHelp) {
    const ProgramResult alone = program_.run({});
    EXPECT_EQ(alone.status, 0);
    EXPECT_EQ(alone.out, program_.run({"--help"}).out);
    EXPECT_NE(alone.out.find("choose"), std::string::npos);
}

TEST_F(Grammar, ATypoNamesTheNearestCommand) {
    const auto refusal = [this](const char* word) { return program_.run({word, "part.ngc"}).err; };
    EXPECT_EQ(refusal("rnu"), "curvecore: error: there is no command 'rnu'; did you mean 'run'?\n");
    EXPECT_EQ(refusal("compaer"),
              "curvecore: error: there is no command 'compaer'; did you mean 'compare'?\n");
    EXPECT_EQ(
        refusal("draw").rfind("curvecore: error: there is no command 'draw'; there are run, ", 0),
        0U);
    EXPECT_EQ(program_.run({"rnu"}).status, 2);
}

TEST_F(Grammar, ATypoNamesTheNearestOption) {
    const auto refusal = [this](Arguments line) {
        const ProgramResult result = program_.run(line);
        EXPECT_EQ(result.status, 2);
        return result.err;
    };
    EXPECT_EQ(refusal({"run", "part.ngc", "--otput", "x"}),
              "curvecore: error: run has no option '--otput'; did you mean '--output'?\n");
    EXPECT_EQ(refusal({"run", "--halp"}),
              "curvecore: error: run has no option '--halp'; did you mean '--help'?\n");
    EXPECT_EQ(refusal({"plan", "part.ngc", "--sampleperiod=1ms"}),
              "curvecore: error: plan has no option '--sampleperiod'; did you mean "
              "'--sample-period'?\n");
    EXPECT_EQ(refusal({"choose", "--colour", "red"}),
              "curvecore: error: choose has no option '--colour'; choose --help-all lists them\n");
    EXPECT_EQ(refusal({"help", "rnu"}),
              "curvecore: error: there is no command 'rnu'; did you mean 'run'?\n");
}

TEST_F(Grammar, CaseOfNamesDoesNotMatter) {
    const ProgramResult result = program_.run(
        {"Plan", "part.ngc", "-q", "--BUILD", "Serial", "--set", "coefbits=24", "--Output", "out"});
    EXPECT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(program_.read("out/report.json"));
    EXPECT_EQ(report["build"], "serial");
    EXPECT_EQ(report["parameters"]["CoefBits"], 24);
}

TEST_F(Grammar, HelpHasExamplesAndHidesWhatIsRare) {
    const std::string commands = program_.run({"help"}).out;
    EXPECT_EQ(commands, program_.run({"--help"}).out);
    for (const char* command : {"run", "plan", "words", "vectors", "cam", "join", "compare",
                                "choose", "stream", "home", "board", "explore", "curve"}) {
        const std::string help = program_.run({command, "--help"}).out;
        const std::string all = program_.run({command, "--help-all"}).out;
        EXPECT_EQ(help, program_.run({"help", command}).out);
        std::size_t examples = 0;
        for (std::size_t at = help.find("Examples:");
             (at = help.find(std::string("\n  curvecore ") + command, at)) != std::string::npos;
             ++at) {
            ++examples;
        }
        EXPECT_EQ(examples, 3U) << help;
        EXPECT_EQ(help.find("Option Group"), std::string::npos) << command;
        EXPECT_EQ(help.find("{false}"), std::string::npos) << command;
        EXPECT_GE(all.size() + 40, help.size()) << command;
    }
    const std::string help = program_.run({"run", "--help"}).out;
    const std::string all = program_.run({"run", "--help-all"}).out;
    for (const char* group : {"\nInput:", "\nCore:", "\nPlan:", "\nBoard:", "\nOutput:"}) {
        EXPECT_NE(help.find(group), std::string::npos) << group;
    }
    EXPECT_EQ(help.find("--trace-clocks"), std::string::npos);
    EXPECT_NE(all.find("--trace-clocks"), std::string::npos);
    EXPECT_EQ(program_.run({"plan", "part.ngc", "-q", "--effort", "rules"}).status, 0)
        << "a hidden option is one";
}

TEST_F(Grammar, AShellCompletesCommandsAndOptions) {
    const ProgramRun shell("/bin/bash");
    shell.write("completion", program_.run({"completion"}).out);
    const auto completed = [&shell](const std::string& words) {
        return shell
            .run({"-c", ". ./completion; COMP_WORDS=(" + words +
                            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _curvecore; "
                            "echo ${COMPREPLY[@]}"})
            .out;
    };
    EXPECT_EQ(completed("curvecore com"), "compare completion\n");
    EXPECT_EQ(completed("curvecore help ho"), "home\n");
    EXPECT_EQ(completed("curvecore plan --sample-p"), "--sample-period\n");
    EXPECT_EQ(completed("curvecore run --trace-c"), "--trace-clocks\n") << "a hidden option is one";
    EXPECT_EQ(completed("curvecore choose --trace-c"), "\n");
    EXPECT_EQ(completed("curvecore run par"), "\n") << "names of files are the shell's own";
}

TEST_F(Grammar, AnyLengthIsAUnit) {
    EXPECT_EQ(plan({"--unit", "2.5um"})["unit_mm"], 2.5e-3);
    EXPECT_EQ(plan({"--unit", "1/65536in"})["unit_mm"], 25.4 / 65536);
    EXPECT_EQ(plan({"--unit", "0.01mm"})["unit_mm"], 0.01);
    EXPECT_EQ(plan({})["unit_mm"], 1e-6);
}

TEST_F(Grammar, TheErrorIsThatOfTheRoundedPosition) {
    const auto bound = [this](const Arguments& options) {
        return plan(options)["unrounded"]["bound_lsb"].get<double>();
    };
    EXPECT_LE(bound({}), 0.1);
    EXPECT_LE(bound({"--error", "0.52nm"}), 0.02);
    const double loose = bound({"--error", "20nm"});
    EXPECT_GT(loose, 0.1);
    EXPECT_LE(loose, 19.5);
}

TEST_F(Grammar, WithoutAFolderResultsStandBesideTheFile) {
    EXPECT_EQ(program_.run({"plan", "part.ngc", "-q"}).status, 0);
    EXPECT_TRUE(program_.exists("part.ngc.out/report.json"));
}

TEST_F(Grammar, APipeIsReadAsGCode) {
    const ProgramRun shell("/bin/sh");
    shell.write("part.ngc", program_.read("part.ngc"));
    const auto piped = [&](const std::string& text) {
        return shell.run({"-c", text + " | " CURVECORE_PROGRAM " plan - -q"});
    };
    const ProgramResult result = piped("cat part.ngc");
    EXPECT_EQ(result.status, 0) << result.err;
    const Json report = plan({});
    EXPECT_EQ(Json::parse(shell.read("stdin.out/report.json"))["segments"], report["segments"]);
    const ProgramResult bad = piped("printf 'G21\\nG999\\n'");
    EXPECT_EQ(bad.status, 2);
    EXPECT_EQ(bad.err.rfind("stdin:2: error: ", 0), 0U) << bad.err;
}

TEST_F(Grammar, ADeviceGivesClockAndMultipliers) {
    const Json report = plan({"--device", "up5k", "--build", "serial"});
    EXPECT_EQ(report["parameters"]["MultiplierForm"], 2);
    EXPECT_GT(report["clock_hz"], 20e6);
    EXPECT_LT(report["clock_hz"], 40e6);
    EXPECT_EQ(plan({"--device", "up5k", "--build", "serial", "--clock", "12MHz"})["clock_hz"],
              12e6);
    const ProgramResult unknown = program_.run({"plan", "part.ngc", "--device", "gw2a-18"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err,
              "curvecore: error: --device gw2a-18: there are no measured runs of the parallel "
              "build for it yet: say --clock\n");
}

TEST_F(Grammar, ManySegmentsOfNarrowWordsAreWarnedOf) {
    program_.write("part.ngc", "G21 G90 G94 F600\nG2 X0 Y0 I30 J0\nM2\n");
    const ProgramResult narrow = program_.run(
        {"plan", "part.ngc", "-q", "--set", "CoefBits=22", "--set", "Order=4", "-o", "narrow"});
    EXPECT_EQ(narrow.status, 0) << narrow.err;
    EXPECT_NE(narrow.err.find(" segments with Order=4 CoefBits=22 GuardBits=10, "),
              std::string::npos)
        << narrow.err;
    EXPECT_NE(narrow.err.find(" of the widest words"), std::string::npos) << narrow.err;
    EXPECT_EQ(program_.run({"plan", "part.ngc", "-q"}).err, "");
}

}  // namespace curvecore::tb::grammar_test
