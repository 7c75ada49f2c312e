// SPDX-License-Identifier: Apache-2.0
// Cubics at the ends of the words' ranges, planned for Orders 2 .. 12 and widths 18 .. 36 in both
// modes, and drawn by the kernel whose words throw on overflow: fails if one does.
#define CURVECORE_CHECKED
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ref/segment/spline_segment.hpp"
#include "tb/support/judge/checked_drawing.hpp"
#include "tb/support/segments/extreme_cubics.hpp"
#include "tb/support/segments/parameters_of.hpp"

namespace {

using namespace curvecore;
using hls::SamplerMode;

struct Seen {
    std::int64_t cubics = 0;
    std::int64_t segments = 0;
    std::int64_t steps = 0;
    std::int64_t overflows = 0;

    void add(const Seen& more) {
        cubics += more.cubics;
        segments += more.segments;
        steps += more.steps;
        overflows += more.overflows;
    }
};

template <class C>
Seen draw_cubics(int cubics, tb::Extreme extreme) {
    const ref::CoreParameters format = tb::parameters_of<C>();
    const double hair = std::ldexp(1.0, 6 - C::kCoefBits);
    tb::ExtremeCubics random(7 + C::kOrder, 1.0 / 1024, hair);
    Seen seen;
    for (int n = 0; n < cubics; ++n) {
        // The limit, 0.2 .. 1, is at least some hundred last bits of the curve.
        const double limit = random.uniform(0.2, 1);
        const double large = std::min(std::ldexp(limit, C::kCoefBits - 8), 1e9);
        const double size = std::max(100.0, large * std::exp2(random.uniform(-6, 0)));
        const ref::Cubic cubic = random.next(extreme, size);
        ++seen.cubics;
        for (const ref::Segment& segment : ref::split_spline(cubic, format, limit)) {
            if (segment.kind() != ref::CurveKind::kSpline || segment.length == 0) continue;
            ++seen.segments;
            seen.steps += static_cast<std::int64_t>(
                (segment.length >> (segment.step_exponent + hls::kPathFrac)) + 1);
            try {
                tb::draw_checked<C>(segment);
            } catch (const std::range_error&) {
                ++seen.overflows;
            }
        }
    }
    return seen;
}

template <int P, int W, int G, SamplerMode Mode, int Guard = 0>
using Core = hls::Configuration<P, W, 32, G, 0, Mode, true, Guard>;
constexpr SamplerMode kSeries = SamplerMode::kSeries;
constexpr SamplerMode kPolynomial = SamplerMode::kPolynomial;

template <class... Cores>
struct List {
    static constexpr int kCores = sizeof...(Cores);
    template <class Each>
    static void for_each(Each each) {
        (each(Cores{}), ...);
    }
};

using Cores =
    List<Core<2, 36, 10, kPolynomial>, Core<2, 18, 4, kSeries>, Core<2, 28, 8, kPolynomial, 4>,
         Core<3, 36, 10, kSeries>, Core<3, 24, 8, kPolynomial>, Core<4, 18, 4, kPolynomial>,
         Core<4, 32, 10, kSeries, 8>, Core<5, 22, 6, kSeries>, Core<5, 36, 10, kPolynomial>,
         Core<6, 36, 10, kPolynomial>, Core<6, 36, 10, kSeries>, Core<6, 20, 5, kPolynomial>,
         Core<7, 30, 10, kPolynomial>, Core<7, 19, 4, kSeries>, Core<8, 36, 12, kSeries>,
         Core<8, 26, 8, kPolynomial>, Core<9, 34, 10, kPolynomial>, Core<10, 36, 12, kSeries>,
         Core<11, 29, 9, kPolynomial>, Core<12, 36, 12, kPolynomial>, Core<12, 18, 4, kSeries>>;

constexpr const char* kNames[] = {"slowest at a step's end", "fastest at a step's end",
                                  "b + 3 a v at 2", "3 a at 2", "any"};

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Ranges of the spline kernel's words over extreme cubics"};
    int cubics = 20;
    std::string output;
    app.add_option("--cubics", cubics, "of each kind and configuration")->capture_default_str();
    app.add_option("-o,--output", output, "JSON file to write");
    CLI11_PARSE(app, argc, argv);

    nlohmann::json rows = nlohmann::json::array();
    Seen all;
    for (int kind = 0; kind < static_cast<int>(tb::Extreme::kCount); ++kind) {
        Seen seen;
        Cores::for_each([&](auto core) {
            const Seen one = draw_cubics<decltype(core)>(cubics, static_cast<tb::Extreme>(kind));
            if (one.overflows > 0) {
                fmt::print("  Order {} CoefBits {}: {} of {} segments overflow\n", core.kOrder,
                           core.kCoefBits, one.overflows, one.segments);
            }
            seen.add(one);
        });
        fmt::print("{:24s} cubics {} segments {} steps {} overflows {}\n", kNames[kind],
                   seen.cubics, seen.segments, seen.steps, seen.overflows);
        rows.push_back({{"kind", kNames[kind]},
                        {"cubics", seen.cubics},
                        {"segments", seen.segments},
                        {"steps", seen.steps},
                        {"overflows", seen.overflows}});
        all.add(seen);
    }
    fmt::print("{} cubics, {} segments, {} overflows\n", all.cubics, all.segments, all.overflows);
    if (!output.empty()) {
        std::ofstream(output) << nlohmann::json{{"kinds", rows}}.dump(1) << '\n';
    }
    return all.overflows == 0 ? 0 : 1;
}
