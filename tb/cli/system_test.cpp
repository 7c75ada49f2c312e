// SPDX-License-Identifier: Apache-2.0
// The system in SystemC around the cores: the same samples, and the same steps at the same times,
// whichever of its blocks is RTL.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::system_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// A sample of 2^8 clocks for the step generator; the Verilated one simulates each of them.
const Arguments kFewClocks{"--set",           "Splines=1", "--clock",  "512kHz",
                           "--sample-period", "500us",     "--system", "step=10um"};

class System : public testing::Test {
  protected:
    struct Drawn {
        std::string samples;
        Json report;
        Json pulses() const { return report["pulses"]; }
    };

    Drawn draw(const std::string& file, const std::string& system, const Arguments& options,
               int status = 0) {
        Arguments arguments{"run", file, "-q", "-o", "out", "--on", "systemc"};
        if (!system.empty()) arguments.insert(arguments.end(), {"--system", system});
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = program_.run(arguments);
        EXPECT_EQ(result.status, status) << system << ": " << result.err;
        std::string samples = program_.read("out/samples.csv");
        samples.erase(0, samples.find("\n", samples.rfind("#")));
        return {samples, Json::parse(program_.read("out/report.json"))};
    }

    void compare(const std::string& file) {
        const Drawn kernel = draw(file, "", kFewClocks);
        EXPECT_EQ(kernel.report["board"], "systemc");
        std::int64_t steps = 0;
        const Json pulses = kernel.pulses();
        for (const Json& axis : pulses["axes"]) steps += axis["steps"].get<std::int64_t>();
        EXPECT_GT(steps, 1000);
        for (const char* blocks :
             {"steps=rtl", "interpolator=rtl", "interpolator=rtl,steps=rtl", "steps=pins"}) {
            const Drawn other = draw(file, blocks, kFewClocks);
            EXPECT_EQ(other.report["late_samples"], 0) << blocks;
            EXPECT_TRUE(other.samples == kernel.samples) << blocks;
            EXPECT_EQ(other.pulses(), kernel.pulses()) << blocks;
        }
    }

    ProgramRun program_;
};

/// Words of a rotary axis leave whole turns out, unless the board counts its steps: 40,000 too few
/// steps were made, at a speed that no drive has.
TEST_F(System, ARotaryAxisMakesTheStepsOfAllItsTurns) {
    const std::string turns = "G21 G90 G61 F20000\nG1 A200\nG1 A400\nG1 A500\nG1 A-400\nM2\n";
    program_.write("turns.ngc", turns);
    const Json pulses = draw("turns.ngc", "step=0.1mm", {}).pulses();
    EXPECT_EQ(pulses["axes"]["a"]["count"], -4000);
    program_.write("more.ngc", "G21 G90 G61 F20000\nG1 A3000\nM2\n");
    const ProgramResult result =
        program_.run({"run", "more.ngc", "-q", "-o", "out", "--on", "systemc"});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("needs PositionBits 33 (now 32) or a larger unit"), std::string::npos)
        << result.err;
    EXPECT_EQ(program_.run({"run", "more.ngc", "-q", "-o", "out", "--on", "kernel"}).status, 0);
}

using LongSystem = System;
TEST_F(LongSystem, StepsTheDemoAlike) { compare(DATA_DIR "/demo.ngc"); }
TEST_F(System, StepsArcsAlike) { compare(DATA_DIR "/arcs.ngc"); }
TEST_F(System, StepsSplinesAlike) { compare(DATA_DIR "/splines.ngc"); }

/// Negative control of the comparison: a pin's time that is a clock longer is detected.
TEST_F(System, ComparisonSeesOneClock) {
    const Json before = draw(DATA_DIR "/pulses.ngc", "", kFewClocks).pulses();
    const Json later = draw(DATA_DIR "/pulses.ngc", "steplen=5us", kFewClocks).pulses();
    EXPECT_NE(before["pins"], later["pins"]);
    EXPECT_EQ(before["axes"], later["axes"]);
}

/// Nine axes at the clocks of a board.
TEST_F(System, StepsNineAxesAlike) {
    program_.write("part.ngc", "G21 G90 G94 F1200\nG1 X1 A2 C-1\nG3 X3 Y2 I0 J2 B1 W0.5\nM2\n");
    const Arguments options{"--set", "Splines=1", "--set", "AuxAxes=6"};
    const Json kernel = draw("part.ngc", "", options).pulses();
    EXPECT_EQ(kernel["clock_hz"], 81.92e6);
    EXPECT_EQ(kernel["axes"].size(), 9U);
    EXPECT_EQ(kernel["axes"]["x"]["count"], 1200);
    EXPECT_EQ(kernel["axes"]["c"]["count"], -400);
    EXPECT_EQ(draw("part.ngc", "interpolator=rtl,steps=rtl", options).pulses(), kernel);
}

TEST_F(System, CountsEndWhereTheProgramEnds) {
    const Json axes = draw(DATA_DIR "/pulses.ngc", "steps=rtl", kFewClocks).pulses();
    EXPECT_EQ(axes["axes"]["x"]["count"], 0);
    EXPECT_EQ(axes["axes"]["z"]["count"], -25);
    EXPECT_EQ(axes["axes"]["z"]["due"], -25);
}

TEST_F(System, FollowingErrorIsThatOfTheSecondOrder) {
    program_.write("line.ngc", "G21 G90 G94 F6000\nG1 X80\nM2\n");
    const auto behind = [this](const std::string& system) {
        const Json axis = draw("line.ngc", system, {}).pulses()["axes"]["x"];
        return axis["following_error_mm"].get<double>();
    };
    // 2 D v / w + friction / w^2 at 100 mm/s
    EXPECT_NEAR(behind("frequency=50Hz,damping=0.7,friction=0"), 0.4456, 0.01);
    EXPECT_NEAR(behind("frequency=100Hz,damping=0.7,friction=0"), 0.2228, 0.01);
    EXPECT_NEAR(behind("frequency=50Hz,damping=0.7,friction=20000"), 0.6483, 0.01);
}

/// A host that sleeps longer than its words last: the core would stop time, and the Verilated one
/// does.
TEST_F(System, ReportsThatTheHostStarvedTheQueues) {
    const std::string part = DATA_DIR "/demo.ngc";
    const std::vector<std::string> builds{"interpolator=kernel", "interpolator=rtl"};
    for (int n = 0; n < cases(1, 2); ++n) {
        const std::string& blocks = builds[static_cast<std::size_t>(n)];
        const auto starved = [&](const std::string& host, int status) {
            const Json report = draw(part, blocks + "," + host, kFewClocks, status).report;
            EXPECT_EQ(report["underruns"] != 0, report["starved"] != 0) << blocks << " " << host;
            return report["starved"].get<int>();
        };
        EXPECT_EQ(starved("host=1s,jitter=100ms", 0), 0) << blocks;
        EXPECT_GT(starved("host=4s", 1), 0) << blocks;
    }
}

TEST_F(System, ReportsStepsThatDoNotFitTheirTimes) {
    program_.write("line.ngc", "G21 G90 G94 F6000\nG1 X20\nM2\n");
    for (const char* steps : {"kernel", "rtl"}) {
        const std::string blocks = std::string("steps=") + steps;
        const Json drawn = draw("line.ngc", blocks + ",stepspace=40us", {}, 1).pulses();
        EXPECT_EQ(drawn["axes"]["x"]["overrun"], true);
        EXPECT_EQ(drawn["axes"]["y"]["overrun"], false);
    }
}

}  // namespace curvecore::tb::system_test
