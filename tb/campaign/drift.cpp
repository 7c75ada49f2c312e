// SPDX-License-Identifier: Apache-2.0
// A chain of a million segments: turn after turn of a quarter circle in a tilted plane, every turn
// sampled. Fails unless the worst error before rounding in the last 1,000 turns is at most 1.05
// times that in the first 1,000.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hls/interpolator_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/curve/segment_curve.hpp"
#include "ref/plan/geometry.hpp"

namespace {

using namespace curvecore;
using C = hls::DefaultConfiguration;

constexpr double kUnit = 1e-6;
constexpr int kWindow = 1000;

/// Four quarter turns of 25 mm radius: one full circle, whose end is its start.
ref::Geometry full_turn() {
    ref::Move move;
    move.line = 1;
    move.feed = 10;
    move.kind = ref::Move::Kind::kArc;
    move.normal = ref::Vec3(1, 2, 3).normalized();
    move.centre = ref::Vec3(10, -20, 5);
    move.start = move.centre + 25 * move.normal.unitOrthogonal();
    move.end = move.start;
    move.angle = 2 * M_PI;
    ref::PlanOptions options;
    options.unit_mm = kUnit;
    return ref::make_geometry({"drift", {move}, {}, 0}, ref::Machine{}, options);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Drift over a chain of segments"};
    std::int64_t chain = 1000000;
    std::string output;
    app.add_option("--segments", chain, "segments in the chain")->capture_default_str();
    app.add_option("-o,--output", output, "JSON file to write");
    CLI11_PARSE(app, argc, argv);

    const ref::Geometry turn = full_turn();
    const std::size_t per_turn = turn.segments.size();
    const ref::Segment& last = turn.segments.back();
    const std::int64_t turn_length = static_cast<std::int64_t>(last.s_start + last.length);
    const std::int64_t window = static_cast<std::int64_t>(kWindow) * turn_length;
    const std::int64_t total = (chain / static_cast<std::int64_t>(per_turn)) * turn_length;

    hls::InterpolatorKernel<C> kernel;
    std::size_t opened = 0;
    std::int64_t s = 0;
    std::int64_t samples = 0;
    double first = 0;
    double final = 0;
    const std::int64_t ds = turn_length / 41 + 12345;  // incommensurate: never the same places
    while (s + ds <= total) {
        s += ds;
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            ds, [&] { return hls::to_words<C>(turn.segments[opened++ % per_turn]); }, fine);
        ++samples;
        const bool head = s <= window;
        const bool tail = s > total - window;
        if (!head && !tail) continue;
        const ref::Segment& segment = turn.segments[(opened - 1) % per_turn];
        const std::int64_t local = s % turn_length - static_cast<std::int64_t>(segment.s_start);
        const ref::Vec3 exact =
            ref::exact_position(segment, std::ldexp(static_cast<double>(local), -hls::kPathFrac));
        for (int axis = 0; axis < 3; ++axis) {
            const double error = std::fabs(
                std::ldexp(static_cast<double>(fine[axis]), -C::kGuardBits) - exact[axis]);
            double& worst = head ? first : final;
            worst = std::max(worst, error);
        }
    }
    const double ratio = final / first;
    fmt::print("{} segments, {} samples: first {} turns {:.5f}, last {:.5f} units, ratio {:.4f}\n",
               opened, samples, kWindow, first, final, ratio);
    if (!output.empty()) {
        std::ofstream(output) << nlohmann::json{{"segments", opened},
                                                {"samples", samples},
                                                {"first", first},
                                                {"last", final},
                                                {"ratio", ratio}}
                                     .dump(1)
                              << '\n';
    }
    return ratio <= 1.05 && first > 0 ? 0 : 1;
}
