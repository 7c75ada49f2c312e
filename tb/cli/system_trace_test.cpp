// SPDX-License-Identifier: Apache-2.0
// The file system.vcd: every step of the report is there, at the same times whichever block is RTL.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb::system_trace_test {

using Json = nlohmann::json;

struct Change {
    std::string time;
    std::string value;
    bool operator==(const Change& other) const {
        return time == other.time && value == other.value;
    }
};
/// Changes by signal, as GTKWave names it.
using Waves = std::map<std::string, std::vector<Change>>;

Waves waves_of(const std::string& vcd) {
    std::istringstream lines(vcd);
    std::map<std::string, std::string> names;
    std::vector<std::string> scopes;
    Waves waves;
    std::string time = "#0";
    bool defined = false;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        defined = defined || word == "$enddefinitions";
        if (word == "$scope") {
            words >> word >> word;
            scopes.push_back(word);
        } else if (word == "$upscope") {
            scopes.pop_back();
        } else if (word == "$var") {
            std::string id;
            words >> word >> word >> id >> word;
            for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope) {
                word = *scope + "." + word;
            }
            names[id] = word;
            waves[word];
        } else if (!defined) {
            continue;  // versions and units
        } else if (word[0] == '#') {
            time = word;
        } else if (word[0] == 'r') {
            std::string id;
            words >> id;
            waves[names[id]].push_back({time, word.substr(1)});
        } else if (word[0] == '0' || word[0] == '1') {
            waves[names[word.substr(1)]].push_back({time, word.substr(0, 1)});
        }
    }
    return waves;
}

class SystemTrace : public testing::Test {
  protected:
    Waves draw(const std::string& system) {
        const ProgramResult result =
            program_.run({"run", DATA_DIR "/pulses.ngc", "-q", "-o", "out", "--on", "systemc",
                          "--trace", "--set", "Splines=1", "--clock", "768kHz", "--sample-period",
                          "500us", "--system", "step=10um", "--system", system});
        EXPECT_EQ(result.status, 0) << result.err;
        return waves_of(program_.read("out/system.vcd"));
    }

    ProgramRun program_;
};

TEST_F(SystemTrace, HasEveryStepAndEverySignalOfTheSaveFile) {
    const Waves waves = draw("steps=kernel");
    const Json report = Json::parse(program_.read("out/report.json"));
    for (const char* axis : {"x", "y", "z"}) {
        const std::string name = std::string("SystemC.") + axis;
        std::uint64_t steps = 0;
        for (const Change& change : waves.at(name + ".step")) steps += change.value == "1" ? 1 : 0;
        EXPECT_EQ(steps, report["pulses"]["axes"][axis]["steps"].get<std::uint64_t>());
        EXPECT_GT(waves.at(name + ".place").size(), 100U);
    }
    std::istringstream lines(program_.read("out/system.gtkw"));
    std::size_t shown = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("SystemC.", 0) != 0) continue;
        EXPECT_EQ(waves.count(line), 1U) << line;
        ++shown;
    }
    EXPECT_EQ(shown, waves.size());
    const std::string save = program_.read("out/system.gtkw");
    const double zoom = std::stod(save.substr(save.find("\n*") + 2));
    EXPECT_NEAR(std::exp2(-zoom) * 5 / (report["duration_s"].get<double>() * 1e12), 1, 0.01)
        << "it opens on all of the motion";
}

TEST_F(SystemTrace, IsTheSameWhicheverBlockIsRtl) {
    const Waves kernel = draw("steps=kernel");
    EXPECT_TRUE(draw("steps=rtl,interpolator=rtl") == kernel);
    EXPECT_FALSE(draw("steplen=5us") == kernel) << "the comparison is blind";
}

}  // namespace curvecore::tb::system_trace_test
