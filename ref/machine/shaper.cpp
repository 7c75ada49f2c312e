// SPDX-License-Identifier: Apache-2.0
#include "ref/machine/shaper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kMostGain = 6;  // of feed-forward: of the near difference
constexpr double kLeft = 0.05;   // V of EI

ShaperTaps impulses(const Vibration& mode, ShaperKind kind, double sample_s) {
    const double root = std::sqrt(1 - mode.damping * mode.damping);
    const double e = std::exp(-mode.damping * M_PI / root);
    ShaperTaps taps;
    taps.delay = static_cast<int>(std::lround(0.5 / (mode.hertz * root * sample_s)));
    if (kind == ShaperKind::kZv) {
        taps.near = 1 / (1 + e);
        return taps;
    }
    const double first = (1 + kLeft) / 4;
    const double sum = first + (1 - kLeft) / 2 * e + first * e * e;
    taps.near = first / sum;
    taps.far = -first * e * e / sum;
    return taps;
}

ShaperTaps feed_forward(const Vibration& mode, int delay, double sample_s) {
    const double tau = delay * sample_s;
    double a = mode.advance_s / (2 * tau);
    double b = 0;
    if (mode.hertz > 0) {
        const double wt = 2 * M_PI * mode.hertz * tau;
        a += mode.damping / wt;
        b = 1 / (wt * wt);
    }
    return {delay, b + a, a - b};
}

/// Settings of an axis that leads, as in the machine's file.
std::string settings_of(const Vibration& mode) {
    std::string text;
    if (mode.hertz > 0) text = fmt::format("SHAPER_FREQUENCY = {:g}", mode.hertz);
    if (mode.advance_s == 0) return text;
    return fmt::format("{}{}PRESSURE_ADVANCE = {:g}", text, text.empty() ? "" : ", ",
                       mode.advance_s);
}

bool leads(const Vibration& mode) { return mode.hertz > 0 || mode.advance_s > 0; }

}  // namespace

std::array<ShaperTaps, kMachineAxes> shaper_taps(const Machine& machine, double sample_s,
                                                 int most) {
    std::array<ShaperTaps, kMachineAxes> all;
    const auto check = [&](std::size_t n, int delay) {
        if (delay >= 1 && delay <= most) return;
        throw InputError(machine.name, 0,
                         fmt::format("{}: {} asks for a delay of {} samples of {:g} ms, 1 to {} "
                                     "are possible",
                                     kAxisLetters[n], settings_of(machine.modes[n]), delay,
                                     1e3 * sample_s, most));
    };
    int together = 0;  // samples, of feed-forward
    for (std::size_t n = 0; n < all.size(); ++n) {
        const Vibration& mode = machine.modes[n];
        if (machine.shaper != ShaperKind::kFeedForward || !leads(mode)) continue;
        int delay = 1;
        while (delay <= most && feed_forward(mode, delay, sample_s).near > kMostGain) ++delay;
        check(n, delay);
        together = std::max(together, delay);
    }
    for (std::size_t n = 0; n < all.size(); ++n) {
        const Vibration& mode = machine.modes[n];
        ShaperTaps& taps = all[n];
        taps.delay = together;
        if (!leads(mode) || machine.shaper == ShaperKind::kNone) continue;
        taps = machine.shaper == ShaperKind::kFeedForward
                   ? feed_forward(mode, together, sample_s)
                   : impulses(mode, machine.shaper, sample_s);
        check(n, taps.delay);
    }
    return all;
}

int tool_delay(const Machine& machine, const std::array<ShaperTaps, kMachineAxes>& taps,
               double sample_s) {
    double most = 0;  // samples
    for (std::size_t n = 0; n < taps.size(); ++n) {
        const Vibration& mode = machine.modes[n];
        if (mode.hertz == 0) continue;
        const double own = mode.damping / (M_PI * mode.hertz * sample_s);
        most = std::max(most, taps[n].delay * (1 - taps[n].near - taps[n].far) + own);
    }
    return static_cast<int>(std::lround(most));
}

}  // namespace curvecore::ref
