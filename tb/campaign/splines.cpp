// SPDX-License-Identifier: Apache-2.0
// The spline kernel's samples against the exact arc-length parameterised curves of seeded cubics,
// default configuration, 1 nm. Prints and writes the worst errors, and fails unless
//   - every sample is within 0.6 unit after rounding and within the derived bound before it,
//   - every sample is within 0.05 unit of the curve itself before rounding, 0.92 after,
//   - the path between consecutive samples is the commanded one to 1e-6 of it and 0.1 unit,
//   - every end is exact, and no family's bound is idle: bound / worst seen <= 8.
// The truth is the whole cubic and its own path length, not the pieces that the core is given.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hls/curve_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/curves/spline_families.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace {

using namespace curvecore;

struct Seen {
    std::int64_t curves = 0;
    std::int64_t samples = 0;
    std::int64_t segments = 0;
    std::int64_t steps = 0;
    double rounded = 0;
    double unrounded = 0;
    double bound = 0;
    double contour = 0;
    double contour_rounded = 0;
    double speed = 0;  // path between samples less the commanded path, beyond 1e-6 of it
    std::int64_t landing = 0;
    bool within_bound = true;
};

/// Distance from the curve near u.
double distance(const ref::Cubic& cubic, double u, const ref::Vec3& point) {
    for (int i = 0; i < 3; ++i) {
        const ref::Vec3 velocity = cubic.velocity(u);
        u += velocity.dot(point - cubic.position(u)) / velocity.squaredNorm();
    }
    return (point - cubic.position(u)).norm();
}

template <class C>
void draw(const ref::Cubic& cubic, int samples, sysc::SplineMaker& random, Seen& seen) {
    const ref::CoreParameters format = tb::parameters_of<C>();
    const std::vector<ref::Segment> segments = ref::split_spline(cubic, format, 0.1);
    const ref::ArcLength truth(cubic);
    const std::int64_t length =
        static_cast<std::int64_t>(segments.back().s_start + segments.back().length);
    hls::MotionKernel<C> kernel;
    std::size_t next = 0;
    std::int64_t walked = 0;
    double ahead = 0;  // lead of the sample before, along the path
    for (int n = 0; n <= samples; ++n) {
        // Irregular steps meet the joints of steps and segments at any place; the last is exactly
        // the end.
        const double place = (n + random.uniform(0, 0.999)) / samples;
        const std::int64_t s = n == samples ? length : static_cast<std::int64_t>(place * length);
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            s - walked, [&] { return hls::to_words<C>(segments.at(next++)); }, fine);
        const double ds = std::ldexp(static_cast<double>(s - walked), -hls::kPathFrac);
        walked = s;
        const double u = truth.parameter(std::ldexp(static_cast<double>(s), -hls::kPathFrac));
        const ref::Vec3 exact = cubic.position(u);
        ref::Vec3 point, whole;
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = std::ldexp(static_cast<double>(fine[axis]), -C::kGuardBits);
            whole[axis] = static_cast<double>(hls::to_position<C>(fine[axis]));
        }
        const double error = (point - exact).cwiseAbs().maxCoeff();
        seen.unrounded = std::max(seen.unrounded, error);
        seen.rounded = std::max(seen.rounded, (whole - exact).cwiseAbs().maxCoeff());
        seen.within_bound = seen.within_bound && error <= segments[next - 1].bound;
        const double before = ahead;
        ahead = tangent(cubic, u).dot(point - exact);
        seen.speed = std::max(seen.speed, std::abs(ahead - before) - 1e-6 * ds);
        seen.contour = std::max(seen.contour, distance(cubic, u, point));
        seen.contour_rounded = std::max(seen.contour_rounded, distance(cubic, u, whole));
        if (n == samples) {
            const ref::Vec3 end = cubic.position(1);
            for (int axis = 0; axis < 3; ++axis) {
                const double half = std::ldexp(0.5, -C::kGuardBits) + 1e-6;
                seen.landing += std::abs(point[axis] - end[axis]) > half;
            }
        }
    }
    for (const ref::Segment& segment : segments) {
        seen.bound = std::max(seen.bound, segment.bound);
        seen.steps += static_cast<std::int64_t>(
            (segment.length >> (segment.step_exponent + hls::kPathFrac)) + 1);
    }
    seen.segments += static_cast<std::int64_t>(segments.size());
    seen.samples += samples + 1;
    ++seen.curves;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Accuracy of the spline kernel over seeded cubics"};
    int curves = 100;
    int samples = 1000;
    std::string output;
    app.add_option("--curves", curves, "cubics per family")->capture_default_str();
    app.add_option("--samples", samples, "samples per cubic")->capture_default_str();
    app.add_option("-o,--output", output, "JSON file to write");
    CLI11_PARSE(app, argc, argv);

    nlohmann::json rows = nlohmann::json::array();
    bool good = true;
    for (const sysc::SplineFamily& family : sysc::spline_families()) {
        sysc::SplineMaker random(1);
        Seen seen;
        for (int n = 0; n < curves; ++n) {
            draw<hls::DefaultSplineConfiguration>(random.next(family), samples, random, seen);
        }
        const double ratio = seen.bound / seen.unrounded;
        const bool held = seen.rounded <= 0.6 && seen.within_bound && seen.landing == 0 &&
                          ratio <= 8 && seen.contour <= 0.05 && seen.speed <= 0.1 &&
                          seen.contour_rounded <= 0.92;
        good = good && held;
        fmt::print(
            "{:29s} rounded {:.4f} unrounded {:.4f} bound {:.4f} ratio {:.2f} contour {:.4f} "
            "{:.4f} speed {:.4f} segments {:.1f} steps {:.1f} {}\n",
            family.name, seen.rounded, seen.unrounded, seen.bound, ratio, seen.contour,
            seen.contour_rounded, seen.speed, double(seen.segments) / double(seen.curves),
            double(seen.steps) / double(seen.curves), held ? "ok" : "FAILED");
        rows.push_back({{"family", family.name},
                        {"curves", seen.curves},
                        {"samples", seen.samples},
                        {"segments", seen.segments},
                        {"steps", seen.steps},
                        {"worst_rounded", seen.rounded},
                        {"worst_unrounded", seen.unrounded},
                        {"bound", seen.bound},
                        {"worst_contour", seen.contour},
                        {"worst_contour_rounded", seen.contour_rounded},
                        {"worst_speed", seen.speed},
                        {"worst_landing", seen.landing}});
    }
    if (!output.empty()) {
        std::ofstream(output) << nlohmann::json{{"families", rows}}.dump(1) << '\n';
    }
    return good ? 0 : 1;
}
