// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/wish_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tb/choose/candidate.hpp"
#include "tb/command/options.hpp"
#include "tb/command/quantity.hpp"
#include "tb/command/usage_error.hpp"

namespace curvecore::tb {
namespace {

constexpr double kLeastError = 1e-7;  // mm
constexpr double kMostLength = 1e5;   // mm

/// Within low .. high, in mm.
double length(const std::string& option, const std::string& text, double low, double high) {
    const double value = quantity(option, text, {{"nm", -6}, {"um", -3}, {"mm", 0}, {"m", 3}});
    if (!(value >= low && value <= high)) {
        throw UsageError(fmt::format("{} must be in [{:g}, {:g}] mm", option, low, high));
    }
    return value;
}

/// mm/s
double feed(const std::string& text) {
    const bool per_second = text.size() > 2 && text.substr(text.size() - 2) == "/s";
    const double value = per_second ? quantity("--feed", text, {{"m/s", 3}, {"mm/s", 0}}) * 60
                                    : quantity("--feed", text, {{"mm/min", 0}, {"m/min", 3}});
    if (!(value >= 1e-3 && value <= 1e9)) {
        throw UsageError("--feed must be in [0.001, 1e9] mm/min");
    }
    return value / 60;
}

double frequency(const std::string& option, const std::string& text, double low, double high) {
    const double value = quantity(option, text, {{"Hz", 0}, {"kHz", 3}, {"MHz", 6}, {"GHz", 9}});
    if (!(value >= low && value <= high)) {
        throw UsageError(fmt::format("{} must be in [{:g}, {:g}] Hz", option, low, high));
    }
    return value;
}

}  // namespace

void interpret(const RawWish& raw, ChooseOptions& options) {
    Wish& wish = options.wish;
    wish.error_mm = length("--error", raw.error, kLeastError, 10);
    wish.device = device_of(raw.device);
    wish.feed = feed(raw.feed);
    if (raw.radius.empty() && raw.length.empty()) {
        throw UsageError("--radius of arcs or --length of splines, or both, must be given");
    }
    if (!raw.radius.empty()) {
        wish.radius_mm = length("--radius", raw.radius, 1e-3, kMostLength);
        wish.least_radius_mm =
            raw.least_radius.empty()
                ? std::min(wish.radius_mm, wish.least_radius_mm)
                : length("--least-radius", raw.least_radius, 1e-4, wish.radius_mm);
    }
    if (!raw.length.empty()) wish.length_mm = length("--length", raw.length, 1e-3, kMostLength);
    wish.travel_mm = raw.travel.empty() ? std::max(wish.radius_mm, wish.length_mm)
                                        : length("--travel", raw.travel, 1e-3, kMostLength);
    if (!raw.unit.empty()) wish.unit_mm = unit_of(raw.unit);
    wish.sample_period_s = 1 / frequency("--sample-rate", raw.sample_rate, 1, 1e9);
    if (!raw.clock.empty()) wish.clock_hz = frequency("--clock", raw.clock, 1e3, 1e10);
    wish.host_words = quantity("--host-words", raw.host_words, {{"", 0}});
    if (!(wish.host_words >= 1 && wish.host_words <= 1e12)) {
        throw UsageError("--host-words must be in [1, 1e12] a second");
    }
    if (!raw.build.empty()) wish.build = build_of(raw.build);
    if (!options.machine.empty()) wish.machine = ref::read_machine(options.machine);
    if (!cost_is_known(wish)) {
        throw UsageError(fmt::format("--device {}: there are no measured runs{} for it yet",
                                     wish.device->name,
                                     raw.build.empty() ? "" : " of the " + raw.build + " build"));
    }
}

}  // namespace curvecore::tb
