// SPDX-License-Identifier: Apache-2.0
// The same curves drawn by other interpolators and by the cores: distance from the curve, evenness
// of speed, amount of data. Prints rows and writes them as JSON; fails if a method strays further
// than it promises.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hls/curve_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/feed/planner.hpp"
#include "ref/feed/stops/planned_branches.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/series/spline_tables.hpp"
#include "sysc/curves/built_in_curves.hpp"
#include "tb/bench/others/interpolators.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace {

using namespace curvecore;
using tb::Drawing;
using tb::DrawnCurve;

constexpr double kSamplePeriod = 1e-4;  // s
constexpr double kPaperTick = 10e-3;    // s: period of [Chikurov]'s Runge-Kutta
constexpr double kTick = 1e-3;          // s: LinuxCNC's servo period
constexpr double kUnit = 1e-6;          // mm
constexpr double kTolerance = 0.002;    // mm: of chords, grblHAL's default
constexpr const char* kFineChords = "chords, 0.002 mm off";
constexpr const char* kCore = "curvecore, at one speed";
constexpr const char* kProfile = "curvecore, from rest to rest";
constexpr const char* kBranches = "curvecore, and stop branches";

double bits_of_words(std::size_t segments, std::size_t profile) {
    return 48.0 * static_cast<double>(17 * segments + profile);
}
/// Bits of the segments' words and of one piece of the profile.
double bits_of(std::size_t segments) { return bits_of_words(segments, hls::kProfileBusWords); }

ref::PlanOptions plan_options() {
    using C = hls::DefaultSplineConfiguration;
    ref::PlanOptions options;
    options.unit_mm = kUnit;
    options.format = tb::parameters_of<C>();
    return options;
}

/// Bits that a whole plan of the built-in machine sends.
double planned_bits(const DrawnCurve& curve, double feed, ref::Holds holds) {
    ref::Program program;
    program.moves.push_back(curve.move(feed));
    ref::PlanOptions options = plan_options();
    options.holds = holds;
    const ref::Plan plan = make_plan(program, ref::Machine(), options);
    return bits_of_words(plan.segments.size(), ref::profile_words(plan));
}

/// Draws with the kernel (= RTL, bit for bit), default widths, 1 nm.
Drawing draw_core(const DrawnCurve& curve, double feed) {
    using C = hls::DefaultSplineConfiguration;
    ref::Program program;
    program.moves.push_back(curve.move(feed));
    const ref::PlanOptions options = plan_options();
    const ref::Geometry geometry = make_geometry(program, sysc::unlimited_machine(), options);
    Drawing drawing{{}, bits_of(geometry.segments.size())};
    hls::MotionKernel<C> kernel;
    std::size_t next = 0;
    std::int64_t walked = 0;
    const double ds = feed * kSamplePeriod / kUnit * 65536;
    for (int n = 0; n * ds * kUnit / 65536 <= curve.length(); ++n) {
        const std::int64_t s = std::llround(n * ds);
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            s - walked, [&] { return hls::to_words<C>(geometry.segments.at(next++)); }, fine);
        walked = s;
        ref::Vec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = static_cast<double>(hls::to_position<C>(fine[axis])) * kUnit;
        }
        drawing.positions.push_back(point);
    }
    return drawing;
}

struct Measured {
    double off = 0;     // mm, worst of all samples
    double ripple = 0;  // of the speed, relative to its commanded value
    double jump = 0;    // mm/s: change of velocity from sample to sample beyond the curve's own
};

Measured measure(const DrawnCurve& curve, const Drawing& drawing, double ds) {
    Measured measured;
    const std::vector<ref::Vec3>& p = drawing.positions;
    for (std::size_t n = 0; n < p.size(); ++n) {
        measured.off = std::max(measured.off, curve.off(p[n]));
        if (n + 2 > p.size() - 1) continue;
        const double s = static_cast<double>(n) * ds;
        const ref::Vec3 exact[3] = {curve.position(s), curve.position(s + ds),
                                    curve.position(s + 2 * ds)};
        const double moved = (p[n + 1] - p[n]).norm() / (exact[1] - exact[0]).norm();
        measured.ripple = std::max(measured.ripple, std::abs(moved - 1));
        const double jump = (p[n + 2] - 2 * p[n + 1] + p[n]).norm();
        const double own = (exact[2] - 2 * exact[1] + exact[0]).norm();
        measured.jump = std::max(measured.jump, (jump - own) / kSamplePeriod);
    }
    return measured;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Chords, Runge-Kutta, forward differences and the cores on the same curves"};
    std::string output;
    app.add_option("-o,--output", output, "JSON file to write");
    CLI11_PARSE(app, argc, argv);

    struct Part {
        std::string name;
        DrawnCurve curve;
        double feed;  // mm/s
    };
    const auto spline = [](const std::string& name) {
        for (const ref::TestSpline& one : ref::test_splines()) {
            if (one.name == name) return DrawnCurve(one.cubic);
        }
        throw std::logic_error("no test spline " + name);
    };
    const std::vector<Part> parts{
        {"circle, R = 25 mm, 6 m/min", DrawnCurve(25.0), 100},
        {"circle, R = 2 mm, 1.5 m/min", DrawnCurve(2.0), 25},
        {"spline, gentle, 6 m/min", spline("gentle 3D"), 100},
        {"spline, hairpin r = 0.3 mm, 1.5 m/min", spline("hairpin 0.3"), 25}};
    nlohmann::json rows = nlohmann::json::array();
    bool good = true;
    for (const Part& part : parts) {
        const double ds = part.feed * kSamplePeriod;
        const Drawing core = draw_core(part.curve, part.feed);
        const auto sent = [&](ref::Holds holds) {
            return Drawing{core.positions, planned_bits(part.curve, part.feed, holds)};
        };
        const std::vector<std::pair<std::string, Drawing>> drawings{
            {kFineChords, draw_chords(part.curve, chords_of_tolerance(part.curve, kTolerance), ds)},
            {"chords of 1 mm", draw_chords(part.curve, chords_of_length(part.curve, 1), ds)},
            {"Runge-Kutta each 10 ms",
             draw_runge_kutta(part.curve, part.feed * kPaperTick, ds, bits_of(1))},
            {"Runge-Kutta each ms",
             draw_runge_kutta(part.curve, part.feed * kTick, ds, bits_of(1))},
            {"forward differences, cubic", draw_forward_differences(part.curve, core.bits, ds)},
            {kCore, core},
            {kProfile, sent(ref::Holds::kBounds)},
            {kBranches, sent(ref::Holds::kBranches)}};
        for (const auto& [method, drawing] : drawings) {
            const Measured found = measure(part.curve, drawing, ds);
            const double data = drawing.bits / part.curve.length();
            fmt::print(
                "{:38s} {:27s} {:8.1f} bit/mm  off {:9.3g} mm  ripple {:9.3g} %  jump {:9.3g} "
                "mm/s\n",
                part.name, method, data, found.off, 100 * found.ripple, found.jump);
            if (method == kFineChords) good = good && found.off <= 1.01 * kTolerance;
            if (method == kCore) good = good && found.off <= 0.92 * kUnit;
            rows.push_back({{"curve", part.name},
                            {"method", method},
                            {"bits_per_mm", data},
                            {"off_mm", found.off},
                            {"ripple", found.ripple},
                            {"jump_mm_s", found.jump}});
        }
    }
    if (!output.empty()) std::ofstream(output) << nlohmann::json{{"rows", rows}}.dump(1) << '\n';
    return good ? 0 : 1;
}
