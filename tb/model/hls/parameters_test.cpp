// SPDX-License-Identifier: Apache-2.0
// The table of parameters (ref/format/parameters.def): the RTL's tops have its names, defaults and
// ranges, and combinations that are not built are refused with a reason.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "ref/format/parameter_text.hpp"

namespace curvecore::tb::parameters_test {

using ref::Build;
using ref::CoreParameters;
using ref::Parameter;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<std::smatch> matches(const std::string& text, const std::regex& pattern) {
    return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

/// Parameters of a top that are no row: its build, its structure, its queues.
const std::set<std::string> kStructure{"Build", "Curves", "Table", "SegmentQueueWords",
                                       "ProfileQueueWords"};

class Top : public testing::TestWithParam<const char*> {
  protected:
    const std::string text_ = text_of(std::filesystem::path(RTL_DIR) / GetParam()) + "\n";
};

TEST_P(Top, HasTheTablesNamesAndDefaults) {
    static const std::regex kLine(R"( parameter int (\w+) *= (\d+))");
    const auto lines = matches(text_, kLine);
    EXPECT_GE(lines.size(), 2U);
    for (const std::smatch& line : lines) {
        const std::string name = line[1];
        if (kStructure.count(name) != 0) continue;
        const Parameter* const row = ref::find_parameter(name);
        ASSERT_NE(row, nullptr) << name;
        // A spline's own core has the sampler that suits it.
        const bool other = name == "Mode" && std::string(GetParam()) == "spline_interpolator.sv";
        EXPECT_EQ(std::stoi(line[2]), other ? 1 : row->default_value) << name;
    }
}

TEST_P(Top, StatesTheTablesRangesBesideThem) {
    static const std::regex kLine(R"( parameter int (\w+) *= \d+,? *// [^\n]*\[(\d+), (\d+)\])");
    for (const std::smatch& line : matches(text_, kLine)) {
        if (kStructure.count(line[1]) != 0) continue;
        const Parameter& row = *ref::find_parameter(line[1]);
        EXPECT_EQ(std::stoi(line[2]), row.low) << line[1];
        EXPECT_EQ(std::stoi(line[3]), row.high) << line[1];
    }
}

TEST_P(Top, RefusesWhatTheTableRefuses) {
    static const std::regex kMessage("\"((\\w+) must be [^\"]*)\"");
    for (const std::smatch& message : matches(text_, kMessage)) {
        const Parameter* const row = ref::find_parameter(message[2]);
        if (row != nullptr) {
            EXPECT_EQ(message[1], ref::range_text(*row));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Model, Top,
                         testing::Values("motion_interpolator.sv", "curve_interpolator.sv",
                                         "curve_interpolator_serial.sv",
                                         "spherical_interpolator.sv", "spline_interpolator.sv",
                                         "sine_cosine_interpolator.sv",
                                         "hyperbola_interpolator.sv"),
                         [](const auto& test) {
                             return std::filesystem::path(test.param).stem().string();
                         });

TEST(Parameters, AreAllOfTheWholeCore) {
    const std::string whole = text_of(RTL_DIR "/motion_interpolator.sv");
    std::map<std::string, int> refused;
    for (const char* file : {"motion_interpolator.sv", "curve_interpolator.sv"}) {
        const std::string text = text_of(std::filesystem::path(RTL_DIR) / file);
        for (const Parameter& row : ref::kParameters) {
            refused[row.name] += text.find('"' + ref::range_text(row) + '"') != std::string::npos;
        }
    }
    for (const Parameter& row : ref::kParameters) {
        EXPECT_NE(whole.find(std::string("parameter int ") + row.name + ' '), std::string::npos)
            << row.name;
        EXPECT_GE(refused[row.name], 1) << row.name;
    }
}

TEST(Parameters, DefaultsAreBuilt) {
    CoreParameters parameters;
    for (parameters.splines = 0; parameters.splines <= 1; ++parameters.splines) {
        for (const Build build : {Build::kParallel, Build::kSerial, Build::kEngine}) {
            parameters.build = build;
            EXPECT_EQ(ref::why_not_built(parameters), "");
        }
    }
}

TEST(Parameters, BothEndsOfARangeAreBuiltAndNoMore) {
    for (const Parameter& row : ref::kParameters) {
        CoreParameters parameters;
        parameters.splines = std::string(row.needs) == "Splines=1" ? 1 : 0;
        for (const int value : {row.low, row.high}) {
            parameters.*row.value = value;
            EXPECT_EQ(ref::why_not_built(parameters), "") << row.name;
        }
        for (const int value : {row.low - 1, row.high + 1}) {
            parameters.*row.value = value;
            EXPECT_EQ(ref::why_not_built(parameters), ref::range_text(row));
        }
    }
    CoreParameters parameters;
    parameters.sample_interval = 3;
    EXPECT_EQ(ref::why_not_built(parameters), "SampleInterval must be 1, 2, 4 or 8");
}

TEST(Parameters, EachNeedIsNeeded) {
    CoreParameters parameters;
    parameters.splines = 1;
    parameters.parameter_guard = 4;
    EXPECT_TRUE(ref::legal(parameters));
    const std::string reason = "ParameterGuard=4 works with --build parallel and Splines=1 only";
    CoreParameters arcs = parameters;
    arcs.splines = 0;
    EXPECT_EQ(ref::why_not_built(arcs), reason);
    for (const Build other : {Build::kSerial, Build::kEngine}) {
        parameters.build = other;
        EXPECT_EQ(ref::why_not_built(parameters), reason);
    }
}

TEST(Parameters, DifferWhereOneOfThemDoes) {
    for (const Parameter& row : ref::kParameters) {
        CoreParameters parameters;
        parameters.*row.value += 1;
        EXPECT_FALSE(parameters == CoreParameters()) << row.name;
        EXPECT_TRUE(parameters == parameters);
    }
    for (const Build build : {Build::kSerial, Build::kEngine}) {
        CoreParameters other;
        other.build = build;
        EXPECT_FALSE(other == CoreParameters());
        EXPECT_STREQ(ref::build_name(build), build == Build::kSerial ? "serial" : "engine");
    }
}

}  // namespace curvecore::tb::parameters_test
