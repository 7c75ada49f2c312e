// SPDX-License-Identifier: Apache-2.0
// A chain of a million segments, turn after turn, every turn sampled: a circle in a tilted plane,
// and a closed loop of four cubics. Fails unless the worst error before rounding in the last 1,000
// turns is at most 1.05 times that in the first 1,000.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "hls/curve_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/segment/spline_segment.hpp"

namespace {

using namespace curvecore;

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

/// Four cubics that close a loop with a change of curvature at every joint.
std::vector<ref::Segment> loop() {
    const double size = 20e6;
    std::vector<ref::Segment> turn;
    for (int i = 0; i < 4; ++i) {
        const Eigen::AngleAxisd quarter(i * M_PI / 2, ref::Vec3(1, 2, 3).normalized());
        const auto point = [&](double x, double y) -> ref::Vec3 {
            const ref::Vec3 across = ref::Vec3(3, 0, -1).normalized();
            const ref::Vec3 up = ref::Vec3(1, 2, 3).normalized().cross(across);
            return quarter * (size * (x * across + y * up));
        };
        const ref::Cubic cubic =
            ref::from_bezier({point(1, 0), point(1, 0.8), point(0.8, 1), point(0, 1)});
        const std::uint64_t s = turn.empty() ? 0 : turn.back().s_start + turn.back().length;
        for (const ref::Segment& piece : ref::split_spline(cubic, {6, 36, 32, 10, true}, 0.1, s)) {
            turn.push_back(piece);
        }
    }
    return turn;
}

/// Exact positions of a turn's segments by local path length.
class Truth {
  public:
    explicit Truth(const std::vector<ref::Segment>& turn) : turn_(turn) {
        for (const ref::Segment& segment : turn) {
            if (segment.kind() == ref::CurveKind::kSpline) {
                splines_.emplace_back(segment.spline().cubic(segment.start));
            }
        }
    }
    ref::Vec3 position(std::size_t index, double s) const {
        if (splines_.empty()) return ref::exact_position(turn_[index], s);
        const ref::Segment& piece = turn_[index];
        return piece.spline().cubic(piece.start).position(splines_[index].parameter(s));
    }

  private:
    const std::vector<ref::Segment>& turn_;
    std::vector<ref::ArcLength> splines_;
};

struct Drift {
    std::size_t segments = 0;
    std::int64_t samples = 0;
    double first = 0;
    double last = 0;

    double ratio() const { return last / first; }
    nlohmann::json json() const {
        return {{"segments", segments},
                {"samples", samples},
                {"first", first},
                {"last", last},
                {"ratio", ratio()}};
    }
};

template <class C>
Drift measure(const std::vector<ref::Segment>& turn, std::int64_t chain) {
    const Truth truth(turn);
    const std::size_t per_turn = turn.size();
    const std::int64_t turn_length =
        static_cast<std::int64_t>(turn.back().s_start + turn.back().length);
    const std::int64_t turns = chain / static_cast<std::int64_t>(per_turn);

    hls::MotionKernel<C> kernel;
    Drift drift;
    std::int64_t turn_now = 0;
    std::int64_t s = 0;  // place in the turn
    // The two are incommensurate, so that 1,000 turns meet every part of the turn and compare.
    const std::int64_t ds = turn_length / 41 + turn_length / 41000 + 12345;
    while (true) {
        s += ds;
        if (s > turn_length) {
            s -= turn_length;
            ++turn_now;
        }
        if (turn_now == turns) break;
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            ds, [&] { return hls::to_words<C>(turn[drift.segments++ % per_turn]); }, fine);
        ++drift.samples;
        const bool head = turn_now < kWindow;
        const bool tail = turn_now >= turns - kWindow;
        if (!head && !tail) continue;
        const std::size_t index = (drift.segments - 1) % per_turn;
        const std::int64_t start = static_cast<std::int64_t>(turn[index].s_start);
        // The end of a turn is a point of its last segment.
        std::int64_t local = s - start;
        if (local < 0) local += turn_length;
        const ref::Vec3 exact =
            truth.position(index, std::ldexp(static_cast<double>(local), -hls::kPathFrac));
        for (int axis = 0; axis < 3; ++axis) {
            const double error = std::fabs(
                std::ldexp(static_cast<double>(fine[axis]), -C::kGuardBits) - exact[axis]);
            double& worst = head ? drift.first : drift.last;
            worst = std::max(worst, error);
        }
    }
    return drift;
}

bool report(const char* name, const Drift& drift) {
    fmt::print(
        "{}: {} segments, {} samples: first {} turns {:.5f}, last {:.5f} units, ratio {:.4f}\n",
        name, drift.segments, drift.samples, kWindow, drift.first, drift.last, drift.ratio());
    return drift.ratio() <= 1.05 && drift.first > 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Drift over a chain of segments"};
    std::int64_t chain = 1000000;
    std::string output;
    app.add_option("--segments", chain, "segments in the chain")->capture_default_str();
    app.add_option("-o,--output", output, "JSON file to write");
    CLI11_PARSE(app, argc, argv);

    const Drift arcs = measure<hls::DefaultConfiguration>(full_turn().segments, chain);
    const Drift splines = measure<hls::DefaultSplineConfiguration>(loop(), chain);
    const bool arcs_good = report("arcs", arcs);
    const bool splines_good = report("splines", splines);
    if (!output.empty()) {
        nlohmann::json rows = arcs.json();
        rows["splines"] = splines.json();
        std::ofstream(output) << rows.dump(1) << '\n';
    }
    return arcs_good && splines_good ? 0 : 1;
}
