// SPDX-License-Identifier: Apache-2.0
// Outputs of a program: what each code switches, and where on the drawn path, however it is made
// smooth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "hls/path_outputs.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/program/gcode_stream.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/words/bus_words.hpp"

namespace curvecore::tb::output_places_test {

using ref::OutputKind;

struct Planned {
    sysc::Job job;
    std::vector<ref::PlannedOutput> outputs;
};

Planned plan(
    const std::string& text,
    const std::function<void(sysc::Options&)>& change = [](sysc::Options&) {}) {
    std::istringstream stream(text);
    ref::GcodeStream gcode(stream, "t.ngc", {});
    ref::HeldProgram program{ref::read_all(gcode, "t.ngc"), gcode.events(), {}};
    sysc::Options options;
    options.program = std::make_shared<ref::HeldProgram>(std::move(program));
    change(options);
    Planned planned{sysc::JobStream(options).all(), {}};
    for (std::size_t n = 0; n < planned.job.plan.outputs.size(); ++n) {
        planned.outputs.push_back(planned.job.plan.outputs[n]);
    }
    return planned;
}

/// Point of the drawn path at a place, mm.
ref::Vec3 point_at(const sysc::Job& job, std::uint64_t place) {
    const auto& segments = job.plan.segments;
    std::size_t n = 0;
    while (n + 1 < segments.size() && segments[n].s_start + segments[n].length < place) ++n;
    const ref::Segment& segment = segments[n];
    const double s = std::ldexp(static_cast<double>(place - segment.s_start), -16);
    return ref::exact_position(segment, s) * job.plan.unit_mm;
}

std::vector<double> values(const Planned& planned, OutputKind kind) {
    std::vector<double> all;
    for (const ref::PlannedOutput& output : planned.outputs) {
        if (output.kind == kind) all.push_back(output.value);
    }
    return all;
}

TEST(OutputPlaces, CodesSwitchTheirBits) {
    const Planned planned = plan(
        "M3 S500\nM8\nG1 X1 F600\nM4\nG1 X2\nM7\nG1 X3\nM9\nM64 P1\nG1 X4\nM62 P3\nG1 X5\nM65 P1\n"
        "M5\nG1 X6\nM62 P9\nG1 X7\nM2\n");
    EXPECT_EQ(values(planned, OutputKind::kBits),
              (std::vector<double>{9, 11, 15, 3, 3 + 32, 3 + 32 + 128, 128}));
    EXPECT_EQ(values(planned, OutputKind::kLevel), (std::vector<double>{0.5, 0}));
    EXPECT_TRUE(values(planned, OutputKind::kFollow).empty());
    for (std::size_t n = 0; n + 1 < planned.outputs.size(); ++n) {
        EXPECT_LE(planned.outputs[n].place, planned.outputs[n + 1].place);
    }
}

TEST(OutputPlaces, ALaserIsDarkInRapidsAndFollowsTheFeedWithM4) {
    const Planned planned = plan(
        "M4 S1000\nG1 X1 F600\nG0 X2\nG1 X3\nG1 X4 F1200 S2000\nG0 X5\nM3 S250\nG1 X6\nM5\nG1 X7\n"
        "M2\n",
        [](sysc::Options& options) { options.rules.laser = true; });
    EXPECT_EQ(values(planned, OutputKind::kBits), (std::vector<double>{1, 0}));
    EXPECT_EQ(values(planned, OutputKind::kFollow), (std::vector<double>{10, 20, 0}));
    EXPECT_EQ(values(planned, OutputKind::kLevel), (std::vector<double>{1, 0, 1, 0, 0.25, 0}));
}

TEST(OutputPlaces, AnalogOutputsSetTheLevelWhereTheyAreAskedTo) {
    const std::string text =
        "M67 E0 Q20\nS700\nG1 X1 F600\nM68 E0 Q50\nG1 X2\nM67 E1 Q30\nM3\nG0 X3\nM67 E0 Q-5\n"
        "G1 X4\nM68 E0 Q10\nG1 X5\nM2\n";
    const auto by_q = [](bool laser) {
        return [laser](sysc::Options& options) {
            options.rules.full_q = 40;
            options.rules.laser = laser;
        };
    };
    EXPECT_EQ(values(plan(text, by_q(false)), OutputKind::kLevel),
              (std::vector<double>{0.5, 1, 0, 0.25, 0}));
    // A laser is dark while it is off, and in rapids.
    EXPECT_EQ(values(plan(text, by_q(true)), OutputKind::kLevel), (std::vector<double>{0.25, 0}));
}

TEST(OutputPlaces, ARestStatesAllOutputsWhereItBegins) {
    const Planned planned =
        plan("M4 S1000\nG1 X10 F600\nG0 X20\nM3\nG1 X30\nM2\n", [](sysc::Options& options) {
            options.rules.laser = true;
            options.from_mm = 15;
        });
    for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(planned.outputs.at(n).place, 0U);
    EXPECT_EQ(values(planned, OutputKind::kBits), (std::vector<double>{1, 0}));
    EXPECT_EQ(values(planned, OutputKind::kFollow), (std::vector<double>{0}));
    EXPECT_EQ(values(planned, OutputKind::kLevel), (std::vector<double>{0, 1, 0}));
}

TEST(OutputPlaces, NothingButOutputsStaysOnAtTheEnd) {
    const Planned planned = plan("M3 S1000\nM8\nM62 P2\nG1 X1 F600\nM2\n");
    EXPECT_EQ(values(planned, OutputKind::kBits), (std::vector<double>{1 + 8 + 64, 64}));
    EXPECT_EQ(values(planned, OutputKind::kLevel), (std::vector<double>{1, 0}));
    EXPECT_EQ(planned.outputs.back().place, planned.job.plan.path_length());
}

TEST(OutputPlaces, WhatComesBehindADwellIsBehindIt) {
    const Planned planned = plan("G1 X1 F600\nM62 P0\nG4 P0.1\nM63 P0\nG1 X2\nM2\n");
    ASSERT_EQ(planned.outputs.size(), 2U);
    EXPECT_EQ(planned.outputs[1].place, planned.outputs[0].place + 65536);
}

/// Outputs that change at random between random moves.
class OutputPlacesOnPaths : public testing::TestWithParam<const char*> {};

TEST_P(OutputPlacesOnPaths, AreWithinTheToleranceOfWhereTheyAreAsked) {
    const std::string form = GetParam();
    constexpr double kTolerance = 0.01;
    constexpr double kRounding = 2e-5;  // mm: places and points in text
    std::mt19937 random{7};
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<ref::Vec3> asked;
    std::string text = "G64 P0.01 F3000\n";
    ref::Vec3 at(0, 0, 0);
    for (int n = 0; n < 600; ++n) {
        const double size = form == "chords" ? 0.15 : 4;
        const double turn = form == "chords" ? 0.02 * n : 3 * any(random);
        ref::Vec3 to = at + size * (1 + 0.5 * any(random)) *
                                ref::Vec3(std::cos(turn), std::sin(turn), 0.2 * any(random));
        to = (to * 1e5).array().round() / 1e5;
        if (form == "arcs" && n % 3 == 0) {
            to.z() = at.z();
            text += fmt::format("G3 X{:.5f} Y{:.5f} R{:.5f}\n", to.x(), to.y(), (to - at).norm());
        } else {
            text += fmt::format("G1 X{:.5f} Y{:.5f} Z{:.5f}\n", to.x(), to.y(), to.z());
        }
        at = to;
        if (n + 1 < 600 && random() % 3 == 0) {
            text += asked.size() % 2 == 0 ? "M62 P0\n" : "M63 P0\n";
            asked.push_back(at);
        }
    }
    const Planned planned = plan(text + "M2\n", [&](sysc::Options& options) {
        if (form == "fit") options.arc_tolerance = 0.001;
    });
    ASSERT_GE(planned.outputs.size(), asked.size());
    double worst = 0;
    for (std::size_t n = 0; n < asked.size(); ++n) {
        const double off = (point_at(planned.job, planned.outputs[n].place) - asked[n]).norm();
        worst = std::max(worst, off);
        EXPECT_LE(off, 1.5 * kTolerance + kRounding) << n << ", line " << planned.outputs[n].line;
    }
    printf("%zu changes, %.4f mm off at most\n", asked.size(), worst);
}

INSTANTIATE_TEST_SUITE_P(Form, OutputPlacesOnPaths,
                         testing::Values("lines", "chords", "arcs", "fit"),
                         [](const auto& form) { return std::string(form.param); });

void expect_refused(const std::function<void()>& planned, const std::string& why) {
    try {
        planned();
        ADD_FAILURE() << "not refused";
    } catch (const ref::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
}

TEST(OutputPlaces, WordsSayTheirDistancesHoweverLong) {
    sysc::OutputWriter writer(100e-6, 1e-6);
    std::vector<std::uint64_t> words;
    hls::PathOutputs outputs;
    const std::uint64_t places[] = {0, 5, 5, 300'000'000, 300'000'002, 900'000'000};
    unsigned bits = 0;
    for (const std::uint64_t place : places) {
        writer.pass(place << 16, words);
        writer.write({place << 16, OutputKind::kBits, double(++bits), 0}, words);
    }
    for (const std::uint64_t word : words) EXPECT_TRUE(outputs.take(word));
    EXPECT_EQ(outputs.bits(), 1U);
    bits = 0;
    constexpr std::uint64_t kWay = 5'000'000;  // of a sample, at most
    std::uint64_t path = 0;
    for (const std::uint64_t place : places) {
        ++bits;
        if (place <= path) continue;
        for (; path + kWay < place; path += kWay) outputs.sample(path << 16);
        outputs.sample((place << 16) - 1);
        EXPECT_LT(outputs.bits(), bits);
        path = place;
        outputs.sample(place << 16);
        EXPECT_GE(outputs.bits(), bits);
    }
}

TEST(OutputPlaces, MoreThanTheBoardKeepsAreRefused) {
    std::string text = "G64 P0.01\nG1 F6000\n";
    for (int n = 1; n < 2000; ++n) text += fmt::format("X{:.2f} M6{} P0\n", 0.02 * n, 2 + n % 2);
    const auto on = [&](int words) {
        return plan(text, [&](sysc::Options& options) { options.outputs = words; });
    };
    EXPECT_EQ(on(4096).outputs.size(), 1998U) << "the first one changes nothing";
    expect_refused([&] { on(256); }, "changes of outputs within");
}

TEST(OutputPlaces, ALevelFollowsFeedsOfLessThanAUnitASample) {
    sysc::OutputWriter writer(100e-6, 1e-3);
    for (const double feed : {9.0, 0.5, 0.1}) {  // mm/s: 0.9, 0.05 and 0.01 units a sample
        std::vector<std::uint64_t> words;
        hls::PathOutputs outputs;
        sysc::OutputWriter(writer).write({0, OutputKind::kFollow, feed, 1}, words);
        words.push_back(hls::pack({OutputKind::kLevel, hls::kMostLevel, 0}, 1));
        for (const std::uint64_t word : words) EXPECT_TRUE(outputs.take(word));
        const auto way = [&](double share) {
            return static_cast<std::uint64_t>(std::ceil(share * feed * 0.1 * 256)) << 8;
        };
        std::uint64_t path = 0;
        outputs.sample(path += way(1));
        EXPECT_GE(outputs.power(), 0.99 * hls::kMostLevel) << feed;
        outputs.sample(path += way(0.5) - (1 << 8));
        EXPECT_LE(outputs.power(), 0.51 * hls::kMostLevel) << feed;
    }
}

TEST(OutputPlaces, WaysThatAreNotCountedAreRefused) {
    const auto at = [](double unit_mm, double sample_s, const std::string& feed) {
        return plan("G64 P0.01\nM4 S1000 G1 X1 " + feed + "\n",
                    [&](sysc::Options& options) {
                        options.unit_mm = unit_mm;
                        options.sample_period_s = sample_s;
                        options.outputs = 1024;
                        options.rules.laser = true;
                    })
            .outputs;
    };
    EXPECT_FALSE(at(1e-3, 1e-4, "F3").empty());
    expect_refused([&] { at(1e-3, 1e-4, "F2"); }, ":2: error: the laser's power is to follow");
    EXPECT_FALSE(at(1e-9, 1e-3, "F200").empty());
    expect_refused([&] { at(1e-9, 1e-3, "F300"); }, "ways up to");
}

}  // namespace curvecore::tb::output_places_test
