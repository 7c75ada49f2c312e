// SPDX-License-Identifier: Apache-2.0
// The kernel's samples against the exact curves of random programmed moves, planned with the
// default configuration at 1 nm. Prints and writes the worst errors, and fails unless
//   - every sample is within 0.6 unit after rounding and within the derived bound before it,
//   - every end point is exact,
//   - no family's bound is idle: bound / worst seen <= 8.
// The truth is the programmed move's closed form in long double, not the planner's segments.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hls/interpolator_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/curve/helix.hpp"
#include "ref/geometry/geometry.hpp"
#include "sysc/curves/arc_families.hpp"

namespace {

using namespace curvecore;
using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

constexpr double kUnit = 1e-6;  // mm

struct Seen {
    std::int64_t curves = 0;
    std::int64_t samples = 0;
    std::int64_t segments = 0;
    double rounded = 0;
    double unrounded = 0;
    double bound = 0;
    std::int64_t landing = 0;
    bool within_bound = true;
};

/// The programmed curve in units, at a path length in units.
class Truth {
  public:
    explicit Truth(const ref::Move& move) : move_(move) {
        if (move.kind == ref::Move::Kind::kArc) {
            // The words of the normal and of the start are doubles: the plane is the one that they
            // span.
            const Vector normal = move.normal.cast<Real>().normalized();
            Vector outward = (move.start - move.centre).cast<Real>();
            outward -= normal * normal.dot(outward);
            helix_.emplace_back(outward / kUnit, Vector::Zero(), normal, Real(move.angle),
                                Real(move.normal.dot(move.advance)) / kUnit);
        }
    }
    Real length() const {
        return helix_.empty() ? Real((move_.end - move_.start).norm()) / kUnit : helix_[0].length();
    }
    Vector position(Real s) const {
        if (helix_.empty()) {
            const Vector start = move_.start.cast<Real>() / kUnit;
            const Vector end = move_.end.cast<Real>() / kUnit;
            return start + (end - start) * (s / length());
        }
        return move_.centre.cast<Real>() / kUnit + helix_[0].position(s);
    }

  private:
    ref::Move move_;
    std::vector<ref::Helix<Real>> helix_;
};

/// Distance in units of the last position from the programmed end, rounded. Random ends are no
/// whole units: within half a guard quantum of a tie both neighbours are right.
template <class C>
std::int64_t landing_error(std::int64_t position, double end) {
    const double tie = std::ldexp(0.5, -C::kGuardBits) + 1e-6;
    const std::int64_t low = std::llround(end - tie);
    const std::int64_t high = std::llround(end + tie);
    return position < low ? low - position : position > high ? position - high : 0;
}

template <class C>
void draw(const ref::Move& move, int samples, sysc::ArcMaker& random, Seen& seen) {
    ref::Machine machine;
    for (auto& axis : machine.axis) {
        axis.min = -3000;
        axis.max = 3000;
    }
    const ref::Program program{"campaign", {move}, {}, 0};
    const ref::Geometry geometry = ref::make_geometry(program, machine, ref::PlanOptions{});
    const Truth truth(move);
    const ref::Segment& last = geometry.segments.back();
    const std::int64_t length = static_cast<std::int64_t>(last.s_start + last.length);

    hls::InterpolatorKernel<C> kernel;
    std::size_t next = 0;
    std::int64_t walked = 0;
    for (int n = 0; n <= samples; ++n) {
        // Irregular steps meet the joints of steps and segments at any place; the last is exactly
        // the end.
        const double place = n == samples ? 1.0 : (n + random.uniform(0, 0.999)) / samples;
        const std::int64_t s = n == samples ? length : static_cast<std::int64_t>(place * length);
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            s - walked, [&] { return hls::to_words<C>(geometry.segments.at(next++)); }, fine);
        walked = s;
        const Vector exact = truth.position(std::ldexp(Real(s), -hls::kPathFrac));
        const double bound = geometry.segments[next - 1].bound;
        for (int axis = 0; axis < 3; ++axis) {
            const Real before = std::ldexp(Real(fine[axis]), -C::kGuardBits) - exact[axis];
            const Real after = Real(hls::to_position<C>(fine[axis])) - exact[axis];
            seen.unrounded = std::max(seen.unrounded, static_cast<double>(std::fabs(before)));
            seen.rounded = std::max(seen.rounded, static_cast<double>(std::fabs(after)));
            seen.within_bound = seen.within_bound && std::fabs(before) <= bound;
            if (n == samples) {
                seen.landing = std::max(
                    seen.landing,
                    landing_error<C>(hls::to_position<C>(fine[axis]), move.end[axis] / kUnit));
            }
        }
    }
    for (const auto& segment : geometry.segments) seen.bound = std::max(seen.bound, segment.bound);
    seen.segments += static_cast<std::int64_t>(geometry.segments.size());
    seen.samples += samples + 1;
    ++seen.curves;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Accuracy of the arc kernel over random moves"};
    int curves = 300;
    int samples = 2000;
    std::string output;
    app.add_option("--curves", curves, "moves per family")->capture_default_str();
    app.add_option("--samples", samples, "samples per move")->capture_default_str();
    app.add_option("-o,--output", output, "JSON file to write");
    CLI11_PARSE(app, argc, argv);

    nlohmann::json rows = nlohmann::json::array();
    bool good = true;
    for (const sysc::ArcFamily& family : sysc::arc_families()) {
        sysc::ArcMaker random(1);
        Seen seen;
        for (int n = 0; n < curves; ++n) {
            draw<hls::DefaultConfiguration>(random.next(family), samples, random, seen);
        }
        const double ratio = seen.bound / seen.unrounded;
        const bool held =
            seen.rounded <= 0.6 && seen.within_bound && seen.landing == 0 && ratio <= 8;
        good = good && held;
        fmt::print(
            "{:22s} rounded {:.4f} unrounded {:.4f} bound {:.4f} ratio {:.2f} landing {} "
            "segments {} {}\n",
            family.name, seen.rounded, seen.unrounded, seen.bound, ratio, seen.landing,
            seen.segments, held ? "ok" : "FAILED");
        rows.push_back({{"family", family.name},
                        {"curves", seen.curves},
                        {"samples", seen.samples},
                        {"segments", seen.segments},
                        {"worst_rounded", seen.rounded},
                        {"worst_unrounded", seen.unrounded},
                        {"bound", seen.bound},
                        {"worst_landing", seen.landing}});
    }
    if (!output.empty()) {
        std::ofstream(output) << nlohmann::json{{"families", rows}}.dump(1) << '\n';
    }
    return good ? 0 : 1;
}
