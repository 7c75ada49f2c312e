// SPDX-License-Identifier: Apache-2.0
#include "tb/command/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "ref/program/program_reader.hpp"
#include "tb/command/quantity.hpp"
#include "tb/command/usage_error.hpp"

namespace curvecore::tb {
namespace {

std::uint64_t whole(const std::string& option, const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) {
        throw UsageError(fmt::format("{} '{}': not a whole number", option, text));
    }
    return value;
}

/// Index of a name. @throws UsageError
template <std::size_t Count>
int choice(const std::string& option, const std::string& text,
           const std::array<std::string_view, Count>& known) {
    const auto found = std::find(known.begin(), known.end(), text);
    if (found == known.end()) {
        throw UsageError(
            fmt::format("{} '{}': must be one of {}", option, text, fmt::join(known, ", ")));
    }
    return static_cast<int>(found - known.begin());
}

ref::PointsOptions points_options(const RawOptions& raw, const std::string& file) {
    ref::PointsOptions points;
    points.fit = static_cast<ref::Fit>(choice("--fit", raw.fit, ref::kFitNames));
    points.parameter =
        static_cast<ref::Parameter>(choice("--parameter", raw.parameter, ref::kParameterNames));
    const double per_minute = quantity("--feed", raw.feed, {{"", 0}, {"mm/min", 0}});
    if (!(per_minute >= 1e-3 && per_minute <= 1e9)) {
        throw UsageError("--feed must be in [0.001, 1e9] mm/min");
    }
    points.feed = per_minute / 60;
    const RawOptions unset;
    const bool asked =
        raw.fit != unset.fit || raw.parameter != unset.parameter || raw.feed != unset.feed;
    if (asked && !ref::is_points_file(file)) {
        throw UsageError("--fit, --parameter and --feed are for points (.csv)");
    }
    return points;
}

}  // namespace

double unit_of(const std::string& text) {
    const std::vector<Suffix> units{{"1nm", -6}, {"10nm", -5}, {"0.1um", -4}, {"1um", -3}};
    for (const Suffix& unit : units) {
        if (text == unit.first) return 1 / std::pow(10.0, -unit.second);
    }
    throw UsageError(fmt::format("--unit '{}': must be {}", text, suffix_names(units)));
}

Build build_of(const std::string& text) {
    if (text != "parallel" && text != "serial") {
        throw UsageError(fmt::format("--build '{}': must be parallel or serial", text));
    }
    return text == "serial" ? Build::kSerial : Build::kParallel;
}

int Options::samples_per_tick_log2() const {
    int n = 0;
    while ((1 << n) < samples_per_tick) ++n;
    return n;
}

std::int32_t Options::override_word() const {
    return static_cast<std::int32_t>(std::lround(override_percent / 100 * 65536));
}

ref::PlanOptions Options::plan_options() const {
    ref::PlanOptions plan;
    plan.unit_mm = unit_mm;
    plan.sample_period_s = sample_period_s;
    plan.samples_per_tick = samples_per_tick;
    plan.format = core.format();
    plan.aux_axes = core.aux_axes;
    plan.error_limit = error_limit;
    plan.clock_hz = clock_hz;
    plan.network_latency_clocks = core.network_latency();
    plan.spline_latency_clocks = core.spline_latency();
    return plan;
}

void interpret(const RawOptions& raw, Options& options) {
    if (options.folder.empty()) throw UsageError("--output: a folder's name is expected");
    options.points = points_options(raw, options.file);
    options.unit_mm = unit_of(raw.unit);
    options.sample_period_s = quantity("--sample-period", raw.sample_period,
                                       {{"ns", -9}, {"us", -6}, {"ms", -3}, {"s", 0}});
    if (!(options.sample_period_s >= 1e-8 && options.sample_period_s <= 1)) {
        throw UsageError("--sample-period must be in [10ns, 1s]");
    }
    const std::uint64_t per_tick = whole("--samples-per-tick", raw.samples_per_tick);
    if (per_tick < 1 || per_tick > 32768 || (per_tick & (per_tick - 1)) != 0) {
        throw UsageError("--samples-per-tick must be a power of two in [1, 32768]");
    }
    options.samples_per_tick = static_cast<int>(per_tick);
    options.clock_hz =
        quantity("--clock", raw.clock, {{"Hz", 0}, {"kHz", 3}, {"MHz", 6}, {"GHz", 9}});
    if (!(options.clock_hz >= 1e3 && options.clock_hz <= 1e10)) {
        throw UsageError("--clock must be in [1kHz, 10GHz]");
    }
    options.error_limit = quantity("--limit", raw.limit, {{"", 0}});
    if (!(options.error_limit >= 0.001 && options.error_limit <= 1e6)) {
        throw UsageError("--limit must be in [0.001, 1e6] units");
    }
    options.core.build = build_of(raw.build);
    for (const std::string& assignment : raw.set) {
        set_parameter(options.core, assignment);
        options.splines_set |= assignment.rfind("Splines=", 0) == 0;
        options.aux_axes_set |= assignment.rfind("AuxAxes=", 0) == 0;
    }
    check_combination(options.core);
    options.override_percent = quantity("--override", raw.override_percent, {{"", 0}, {"%", 0}});
    if (!(options.override_percent >= 1 && options.override_percent <= 100)) {
        throw UsageError("--override must be in [1, 100] percent");
    }
    options.trace_clocks = whole("--trace-clocks", raw.trace_clocks);
    if (!raw.stall_seed.empty()) options.stall_seed = whole("--stall", raw.stall_seed);
}

}  // namespace curvecore::tb
