// SPDX-License-Identifier: Apache-2.0
// The fewest multiplier blocks of a parallel sampler of arcs that keeps a requirement: all orders
// alike against a width for each (TurnBits).
#include "ref/format/order_words.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "ref/geometry/arc_cover.hpp"

namespace {

using namespace curvecore;

constexpr double kSegmentWords = 17;
constexpr double kStepsPerSecond = 1e6;  // at 150 MHz, 150 clocks each
constexpr int kLanes = 3;

struct Requirement {
    const char* text;
    double unit_mm, limit, radius_mm, feed, host_words;
};

/// Every radius from 10 um up, each as fast as 5 m/s^2 and 100 m/s^3 let it go
/// (ref/limits/limits.cpp).
bool keeps(const Requirement& requirement, const ref::CoreParameters& format) {
    const double ratio = std::sqrt(2.0);
    for (double high = requirement.radius_mm; high > 0.01; high /= ratio) {
        const ref::ArcCover cover = ref::arc_cover(format, high / ratio / requirement.unit_mm,
                                                   high / requirement.unit_mm, requirement.limit);
        if (cover.longest == 0) return false;
        const double speed = std::min({requirement.feed, std::sqrt(0.866 * 5000 * high),
                                       std::cbrt(0.4 * 1e5 * high * high)}) /
                             requirement.unit_mm;
        if (speed / cover.shortest * kSegmentWords > requirement.host_words) return false;
        if (speed * cover.steps_per_unit > kStepsPerSecond) return false;
    }
    return true;
}

int sum_bits(const ref::CoreParameters& format, int i) {
    return ref::sum_bits(format.coef_bits, format.turn_bits, i);
}

int tau_bits(const ref::CoreParameters& format, int i) {
    return ref::tau_bits(format.coef_bits, format.turn_bits, i);
}

/// Cost of the sampler's multipliers, axes and orders: 18 x 18 blocks, then bits.
std::pair<int, int> cost(const ref::CoreParameters& format) {
    const auto halves = [](int bits) { return bits > 18 ? 2 : 1; };
    std::pair<int, int> sum;
    for (int i = 1; i <= format.order; ++i) {
        const int sums = sum_bits(format, i);
        const int taus = tau_bits(format, i);
        sum.first += kLanes * halves(sums) * halves(taus);
        sum.second += kLanes * sums * taus;
    }
    return sum;
}

/// The cheapest; of orders from `least_order` on and turn bits up to `most_turn_bits`.
ref::CoreParameters search(const Requirement& requirement, int least_order, int most_turn_bits) {
    ref::CoreParameters best;
    std::pair<int, int> least{1 << 30, 0};
    for (int order = least_order; order <= 8; ++order) {
        for (int width = 18; width <= 36; ++width) {
            for (int turn = 0; turn <= most_turn_bits; ++turn) {
                const ref::CoreParameters format{order, width, 32, 12, false, turn};
                const auto its = cost(format);
                if (its >= least || !keeps(requirement, format)) continue;
                best = format;
                least = its;
            }
        }
    }
    return best;
}

std::string widths(const ref::CoreParameters& format) {
    std::string text;
    for (int i = 1; i <= format.order; ++i) {
        text += fmt::format("{}{}x{}", i > 1 ? " " : "", sum_bits(format, i), tau_bits(format, i));
    }
    return text;
}

nlohmann::ordered_json json(const ref::CoreParameters& format) {
    const auto [blocks, bits] = cost(format);
    return {{"order", format.order},
            {"coef_bits", format.coef_bits},
            {"turn_bits", format.turn_bits},
            {"widths", widths(format)},
            {"bits", bits},
            {"blocks", blocks}};
}

std::string text(const ref::CoreParameters& format) {
    const auto [blocks, bits] = cost(format);
    return fmt::format("Order={} CoefBits={} TurnBits={} ({}): {} blocks, {} bits", format.order,
                       format.coef_bits, format.turn_bits, widths(format), blocks, bits);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Words of a width for each order of a parallel sampler against words alike"};
    std::string output;
    app.add_option("-o,--output", output, "the table as .json");
    CLI11_PARSE(app, argc, argv);
    const Requirement requirements[] = {
        {"1 um, R <= 300 mm, 10 m/min", 1e-3, 0.5, 300, 10e3 / 60, 100e3},
        {"1 nm, R <= 1 m, 60 m/min", 1e-6, 0.5, 1000, 1000, 100e3},
        {"1 nm, R <= 1 m, 60 m/min, host 10,000 words/s", 1e-6, 0.5, 1000, 1000, 10e3},
    };
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Requirement& requirement : requirements) {
        for (const int least_order : {2, 4, 6}) {
            const ref::CoreParameters alike = search(requirement, least_order, 0);
            const ref::CoreParameters own = search(
                requirement, least_order, ref::parameter_of(&ref::CoreParameters::turn_bits).high);
            rows.push_back({{"requirement", requirement.text},
                            {"least_order", least_order},
                            {"alike", json(alike)},
                            {"own", json(own)}});
            fmt::print("{}, order >= {}\n    alike {}\n    own   {}\n", requirement.text,
                       least_order, text(alike), text(own));
        }
    }
    if (!output.empty()) {
        std::ofstream(output) << nlohmann::ordered_json{{"rows", rows}}.dump(1) << "\n";
    }
    return 0;
}
