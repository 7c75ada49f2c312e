// SPDX-License-Identifier: Apache-2.0
// The least multiplier bits of a parallel sampler of arcs that keeps a wish: all orders alike
// against a width for each.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ref/plan/arc_cover.hpp"

namespace {

using namespace curvecore;

constexpr double kSegmentWords = 17;
constexpr double kStepsPerSecond = 1e6;  // at 150 MHz, 150 clocks each
constexpr int kLanes = 3;

struct Wish {
    const char* text;
    double unit_mm, limit, radius_mm, feed, host_words;
};

/// Every radius from 10 um up, each as fast as 5 m/s^2 and 100 m/s^3 let it go
/// (ref/plan/limits.cpp).
bool keeps(const Wish& wish, const ref::WordFormat& format, const ref::OrderWords& words) {
    const double ratio = std::sqrt(2.0);
    for (double high = wish.radius_mm; high > 0.01; high /= ratio) {
        const ref::ArcCover cover = ref::arc_cover(format, words, high / ratio / wish.unit_mm,
                                                   high / wish.unit_mm, wish.limit);
        if (cover.longest == 0) return false;
        const double speed = std::min({wish.feed, std::sqrt(0.866 * 5000 * high),
                                       std::cbrt(0.4 * 1e5 * high * high)}) /
                             wish.unit_mm;
        if (speed / cover.shortest * kSegmentWords > wish.host_words) return false;
        if (speed * cover.steps_per_unit > kStepsPerSecond) return false;
    }
    return true;
}

struct Best {
    ref::WordFormat format;
    ref::OrderWords words;
    int bits = 1 << 30;
};

/// The narrowest words of each order; `thetas` empty: all orders alike.
Best search(const Wish& wish, const std::vector<double>& thetas, int least_order) {
    Best best;
    const auto consider = [&](const ref::WordFormat& format, const ref::OrderWords& words) {
        const int bits = ref::lane_bits(format, words);
        if (bits >= best.bits || !keeps(wish, format, words)) return;
        best = {format, words, bits};
    };
    for (int order = least_order; order <= 8; ++order) {
        for (int width = 18; width <= 36; ++width) {
            const ref::WordFormat format{order, width, 32, 12, false};
            if (thetas.empty()) consider(format, ref::uniform_words(format));
            for (const double theta : thetas) {
                for (const int spare : {0, 1, 2, 3}) {
                    consider(format, ref::order_words(format, theta, spare));
                }
            }
        }
    }
    return best;
}

std::string widths(const Best& best) {
    std::string text;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(best.format.order); ++i) {
        text += fmt::format("{}{}x{}", i > 1 ? " " : "", best.words.sum_bits[i],
                            best.words.tau_bits[i]);
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Words of a width for each order of a parallel sampler, on paper"};
    std::string output;
    app.add_option("-o,--output", output, "the table as .json");
    CLI11_PARSE(app, argc, argv);
    const Wish wishes[] = {
        {"1 um, R <= 300 mm, 10 m/min", 1e-3, 0.5, 300, 10e3 / 60, 100e3},
        {"1 nm, R <= 1 m, 60 m/min", 1e-6, 0.5, 1000, 1000, 100e3},
        {"1 nm, R <= 1 m, 60 m/min, host 10,000 words/s", 1e-6, 0.5, 1000, 1000, 10e3},
    };
    std::vector<double> thetas;
    for (int n = 1; n <= 14; ++n) thetas.push_back(std::ldexp(1.0, -n));
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Wish& wish : wishes) {
        for (const int least_order : {2, 4, 6}) {
            const Best alike = search(wish, {}, least_order);
            const Best own = search(wish, thetas, least_order);
            const double saved = 100 * (1 - static_cast<double>(own.bits) / alike.bits);
            const int alike_blocks = kLanes * ref::lane_blocks(alike.format, alike.words);
            const int own_blocks = kLanes * ref::lane_blocks(own.format, own.words);
            rows.push_back({{"wish", wish.text},
                            {"least_order", least_order},
                            {"uniform",
                             {{"order", alike.format.order},
                              {"coef_bits", alike.format.coef_bits},
                              {"bits", kLanes * alike.bits},
                              {"blocks", alike_blocks}}},
                            {"own",
                             {{"order", own.format.order},
                              {"coef_bits", own.format.coef_bits},
                              {"widths", widths(own)},
                              {"max_theta", own.words.max_theta},
                              {"bits", kLanes * own.bits},
                              {"blocks", own_blocks}}},
                            {"saved_percent", saved}});
            fmt::print(
                "{}, order >= {}: alike order {} x {} bits: {} ({} blocks); own order {}, {}"
                " (theta <= {:g}): {} ({} blocks); saved {:.1f} %\n",
                wish.text, least_order, alike.format.order, alike.format.coef_bits,
                kLanes * alike.bits, alike_blocks, own.format.order, widths(own),
                own.words.max_theta, kLanes * own.bits, own_blocks, saved);
        }
    }
    if (!output.empty()) {
        std::ofstream(output) << nlohmann::ordered_json{{"rows", rows}}.dump(1) << "\n";
    }
    return 0;
}
