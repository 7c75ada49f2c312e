// SPDX-License-Identifier: Apache-2.0
// Cams drawn by the RTL: every sample of samples.csv, read back to (rho, theta, x), within delta
// and (1 + |drho/dtheta| + |drho/dx|) length units of the surface that the options name.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/cli/program_run.hpp"
#include "tb/support/programs/plain_surface.hpp"
#include "tb/support/programs/sample_cam.hpp"

namespace curvecore::tb::cam_surface_test {

using Json = nlohmann::json;

constexpr double kUnit = 1e-6;  // mm and degrees

struct DrawnCam {
    const char* name;
    CamRadius radius;
    int angles;
    double dx;
    int sections;
    ref::SurfaceKind kind;
    ref::SurfaceKind another;  // a surface that the samples must not fit
    double delta;              // mm
    std::vector<std::string> helix;
};

void PrintTo(const DrawnCam& cam, std::ostream* out) { *out << cam.name; }

/// The table as it is written, with its rounding.
std::vector<ref::CamSection> table_of(const DrawnCam& cam) {
    auto table = cam_table(cam.radius, cam.angles, cam.dx, cam.sections);
    for (ref::CamSection& section : table) {
        for (double& rho : section.rho) rho = std::round(rho * 1e6) / 1e6;
    }
    return table;
}

std::string text_of(const std::vector<ref::CamSection>& table) {
    std::string text = "x";
    const std::size_t n = table.front().rho.size();
    for (std::size_t m = 0; m < n; ++m) {
        text += fmt::format(",{:.10g}", 360. * static_cast<double>(m) / static_cast<double>(n));
    }
    for (const ref::CamSection& section : table) {
        text += fmt::format("\n{:.10g}", section.x);
        for (const double rho : section.rho) text += fmt::format(",{:.6f}", rho);
    }
    return text + "\n";
}

struct Sample {
    std::size_t piece;
    double rho, x, degrees;
};

/// Starts of the program's pieces, and the last one's end.
std::vector<Sample> program_points(const std::string& text) {
    std::vector<Sample> points;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        Sample point{points.size(), 0, 0, 0};
        int code = 0;
        if (std::sscanf(line.c_str(), "G%d X%lf Z%lf A%lf", &code, &point.rho, &point.x,
                        &point.degrees) == 4) {
            points.push_back(point);
        }
    }
    return points;
}

/// Samples on pieces; each segment is a move here, and the first one goes to the start.
std::vector<Sample> samples_of(const std::string& file) {
    std::vector<Sample> samples;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        unsigned long long k = 0, segment = 0, s = 0;
        long long at[4] = {};
        if (std::sscanf(line.c_str(), "%llu,%llu,%llu,%lld,%lld,%lld,%lld", &k, &segment, &s,
                        &at[0], &at[1], &at[2], &at[3]) != 7 ||
            segment == 0) {
            continue;
        }
        EXPECT_EQ(at[1], 0) << "Y of sample " << k;
        samples.push_back({segment - 1, static_cast<double>(at[0]) * kUnit,
                           static_cast<double>(at[2]) * kUnit, static_cast<double>(at[3]) * kUnit});
    }
    return samples;
}

/// Jumps of the surface: distances of pieces' starts from the surface before them.
std::vector<double> jumps_of(const PlainSurface& surface, const std::vector<Sample>& points) {
    std::vector<double> jumps;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        constexpr double kOn = 1e-3;  // of the piece
        const Sample &from = points[k], &to = points[k + 1];
        const double x = from.x + kOn * (to.x - from.x);
        const double degrees = from.degrees + kOn * (to.degrees - from.degrees);
        const PlainSurface::Place place = surface.at(x, degrees);
        const double there =
            place.rho - place.by_x * (x - from.x) - place.by_degree * (degrees - from.degrees);
        const double jump = std::abs(from.rho - there);
        jumps.push_back(jump > 10 * kUnit ? jump : 0);
    }
    return jumps;
}

struct Distance {
    double most = 0;   // mm
    double share = 0;  // share of the allowed distance
};

/// Measures the samples; `jumps` are those of every piece.
Distance distance(const std::vector<Sample>& samples, const PlainSurface& surface, double delta,
                  const std::vector<double>& jumps) {
    Distance found;
    for (const Sample& sample : samples) {
        const PlainSurface::Place place = surface.at(sample.x, sample.degrees);
        const double error = std::abs(sample.rho - place.rho);
        // A sample at a piece's end may be rounded onto the next one's side of the jump.
        const double jump =
            std::max(jumps[sample.piece], jumps[std::min(sample.piece + 1, jumps.size() - 1)]);
        const double units = (1 + std::abs(place.by_degree) + std::abs(place.by_x)) * kUnit;
        found.most = std::max(found.most, error);
        found.share = std::max(found.share, error / (delta + jump + units));
    }
    return found;
}

void draw_and_hold(const DrawnCam& cam, std::size_t least_pieces) {
    const ProgramRun program;
    const std::vector<ref::CamSection> table = table_of(cam);
    program.write("cam.csv", text_of(table));
    const auto surface_name = ref::kSurfaceNames[static_cast<std::size_t>(cam.kind.surface)];
    std::vector<std::string> arguments{"cam",
                                       "cam.csv",
                                       "-o",
                                       "out",
                                       "--surface",
                                       std::string(surface_name),
                                       "--delta",
                                       fmt::format("{:g}um", cam.delta * 1e3),
                                       "--feed",
                                       "6m/min",
                                       "--sample-period",
                                       "1ms",
                                       "--set",
                                       "AuxAxes=6"};
    if (ref::has_generatrix(cam.kind.surface)) {
        const auto name = ref::kGeneratrixNames[static_cast<std::size_t>(cam.kind.generatrix)];
        arguments.insert(arguments.end(), {"--generatrix", std::string(name)});
    }
    arguments.insert(arguments.end(), cam.helix.begin(), cam.helix.end());
    const auto begin = std::chrono::steady_clock::now();
    const ProgramResult result = program.run(arguments);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(program.read("out/report.json"));
    ASSERT_EQ(report["board"], "rtl");
    ASSERT_EQ(report["rtl_equals_kernel"], 0);
    ASSERT_EQ(report["segments"], report["moves"]);

    const std::vector<Sample> points = program_points(program.read("out/cam.ngc"));
    const std::vector<Sample> samples = samples_of((program.folder() / "out/samples.csv").string());
    ASSERT_GE(points.size() - 1, least_pieces);
    ASSERT_EQ(points.size(), report["moves"].get<std::size_t>());
    ASSERT_GT(samples.size(), 2 * points.size());
    const PlainSurface surface(table, cam.kind);
    std::vector<double> jumps(points.size() - 1, 0);
    if (cam.kind.surface == ref::Surface::kTamm) jumps = jumps_of(surface, points);
    const Distance found = distance(samples, surface, cam.delta, jumps);
    EXPECT_LE(found.share, 1);
    EXPECT_GT(found.share, 0.98) << "pieces are as long as delta lets them be";
    const Json own = Json::parse(program.read("out/cam.json"));
    EXPECT_NEAR(own["from_surface"]["max_mm"].get<double>(), found.most, 1e-9);
    // Controls: half of delta, the surface of other options, the other sense of rotation.
    EXPECT_GT(distance(samples, surface, cam.delta / 2, jumps).share, 1);
    EXPECT_GT(distance(samples, {table, cam.another}, cam.delta, jumps).share, 1);
    std::vector<Sample> mirrored = samples;
    for (Sample& sample : mirrored) sample.degrees = -sample.degrees;
    EXPECT_GT(distance(mirrored, surface, cam.delta, jumps).share, 1);
    fmt::print(
        "{}: {} pieces, {} samples, {:.4g} um off at worst, {:.4f} of what is allowed, {:.0f} s\n",
        cam.name, points.size() - 1, samples.size(), found.most * 1e3, found.share, took.count());
}

using ref::Generatrix;
using ref::Surface;

const DrawnCam kCams[] = {
    {"Sample",
     sample_cam,
     48,
     5,
     8,
     {Surface::kTamm, Generatrix::kParabola},
     {Surface::kTamm, Generatrix::kLinear},
     5e-3,
     {"--kappa", "2"}},
    {"ConcaveFlanks",
     harmonic_cam,
     36,
     6,
     6,
     {Surface::kBlend, Generatrix::kCubic},
     {Surface::kBlend, Generatrix::kParabola},
     5e-3,
     {"--kappa", "2.5"}},
    {"Twisted", twisted_cam, 24, 5, 7, kSmooth, kTensor, 10e-3, {"--kappa", "2"}},
    {"Lobe",
     lobe_cam,
     60,
     8,
     3,
     kTensor,
     kSmooth,
     2e-3,
     {"--scallop", "20um", "--cutter", "10mm", "--ends", "helix"}},
};

class CamSurface : public testing::TestWithParam<DrawnCam> {};

TEST_P(CamSurface, HoldsEverySample) { draw_and_hold(GetParam(), 500); }

INSTANTIATE_TEST_SUITE_P(Cli, CamSurface, testing::ValuesIn(kCams),
                         [](const auto& test) { return std::string(test.param.name); });

/// A cutter of 10 mm that leaves 1 um on 220 mm of cam.
TEST(LongCam, OfAHundredThousandPieces) {
    draw_and_hold({"long lobe",
                   lobe_cam,
                   48,
                   10,
                   23,
                   kTensor,
                   kSmooth,
                   2e-3,
                   {"--scallop", "1um", "--cutter", "10mm"}},
                  100000);
}

}  // namespace curvecore::tb::cam_surface_test
