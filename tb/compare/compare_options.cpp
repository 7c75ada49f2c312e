// SPDX-License-Identifier: Apache-2.0
#include "tb/compare/compare_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ref/order_words.hpp"
#include "tb/command/usage_error.hpp"
#include "tb/compare/number_list.hpp"

namespace curvecore::tb {
namespace {

constexpr std::size_t kMostSettings = 5000;

double limit_of(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) {
        throw UsageError(fmt::format("--limit '{}': not a number of units", text));
    }
    if (!(value >= 0.001 && value <= 1e6)) {
        throw UsageError("--limit must be in [0.001, 1e6] units");
    }
    return value;
}

int single(const std::string& option, const std::string& text, int low, int high) {
    const std::vector<int> numbers = number_list(option, text, low, high);
    if (numbers.size() > 1) {
        throw UsageError(fmt::format("{} '{}': one number is expected", option, text));
    }
    return numbers.front();
}

Target target_of(const RawCompareOptions& raw) {
    Target target{device_of(raw.device), build_of(raw.build),
                  single("--interval", raw.interval, 1, 8)};
    if ((target.sample_interval & (target.sample_interval - 1)) != 0) {
        throw UsageError("--interval must be 1, 2, 4 or 8");
    }
    return target;
}

CurveSet curve_set(const std::string& name) {
    const auto found = std::find(kCurveSets.begin(), kCurveSets.end(), name);
    if (found == kCurveSets.end()) {
        throw UsageError(
            fmt::format("--curves '{}': must be one of {}", name, fmt::join(kCurveSets, ", ")));
    }
    return static_cast<CurveSet>(found - kCurveSets.begin());
}

}  // namespace

std::vector<Setting> all_settings(const std::vector<int>& orders, const std::vector<int>& coef_bits,
                                  const std::vector<int>& guard_bits, const std::vector<int>& modes,
                                  const std::vector<int>& turn_bits,
                                  const std::vector<int>& parameter_guards,
                                  const std::vector<int>& anchors) {
    const std::size_t count = orders.size() * coef_bits.size() * guard_bits.size() * modes.size() *
                              turn_bits.size() * parameter_guards.size() * anchors.size();
    if (count > kMostSettings) {
        throw UsageError(
            fmt::format("{} configurations are asked for, {} are the most", count, kMostSettings));
    }
    std::vector<Setting> settings;
    settings.reserve(count);
    for (const int order : orders) {
        for (const int mode : modes) {
            for (const int guard : guard_bits) {
                for (const int turn : turn_bits) {
                    for (const int parameter_guard : parameter_guards) {
                        for (const int width : coef_bits) {
                            for (const int anchor : anchors) {
                                settings.push_back(
                                    {{order, width, 32, guard, mode == 1, turn, parameter_guard},
                                     anchor == 1});
                            }
                        }
                    }
                }
            }
        }
    }
    return settings;
}

void interpret(const RawCompareOptions& raw, CompareOptions& options) {
    const std::vector<int> modes = number_list("--mode", raw.mode, 0, 1);
    const std::vector<int> turn_bits =
        number_list("--turn-bits", raw.turn_bits, 0, ref::kMostTurnBits);
    const auto above_0 = [](const std::vector<int>& list) {
        return std::any_of(list.begin(), list.end(), [](int value) { return value > 0; });
    };
    if (above_0(turn_bits) && above_0(modes)) {
        throw UsageError("--turn-bits above 0 works with --mode 0 only");
    }
    options.settings = all_settings(
        number_list("--order", raw.order, 2, 12), number_list("--coef-bits", raw.coef_bits, 18, 36),
        number_list("--guard-bits", raw.guard_bits, 2, 12), modes, turn_bits,
        number_list("--parameter-guard", raw.parameter_guard, 0, ref::kMostParameterGuard),
        number_list("--anchor", raw.anchor, 0, 1));
    options.curves = curve_set(raw.curves);
    if (!options.common.file.empty() && raw.curves != RawCompareOptions().curves) {
        throw UsageError("--curves is for a comparison without FILE");
    }
    if (options.common.file.empty() && !options.common.machine.empty()) {
        throw UsageError("--machine is for a comparison with FILE");
    }
    options.sweep.unit_mm = options.common.unit_mm;
    options.sweep.limit = limit_of(raw.limit);
    options.sweep.times_segments = single("--segments", raw.segments, 1, 1000);
    options.sweep.samples = single("--samples", raw.samples, 100, 10000000);
    options.sweep.target = target_of(raw);
    options.sweep.quiet = options.common.quiet;
}

}  // namespace curvecore::tb
