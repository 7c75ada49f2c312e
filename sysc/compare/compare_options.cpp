// SPDX-License-Identifier: Apache-2.0
#include "sysc/compare/compare_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "ref/text/input_error.hpp"
#include "sysc/cli/choice.hpp"
#include "sysc/cli/number_list.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/compare/tick_comparison.hpp"
#include "sysc/curves/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

int single(const std::string& option, const std::string& text, int low, int high) {
    const std::vector<int> numbers = number_list(option, text, low, high);
    if (numbers.size() > 1) {
        throw UsageError(fmt::format("{} '{}': one number is expected", option, text));
    }
    return numbers.front();
}

std::vector<ParameterList> lists_of(const std::vector<std::string>& set, bool core_given) {
    std::vector<ParameterList> lists;
    for (const std::string& text : set) {
        const ParameterList list = read_parameter(text);
        for (const auto value : {&CoreParameters::splines, &CoreParameters::aux_axes}) {
            if (list.row->value == value) {
                throw UsageError(fmt::format("--set {}: follows the curves", list.row->name));
            }
        }
        lists.push_back(list);
    }
    if (core_given) return lists;
    for (const char* text : kComparedSets) {
        const ParameterList list = read_parameter(text);
        const bool given = std::any_of(lists.begin(), lists.end(), [&](const ParameterList& one) {
            return one.row->value == list.row->value;
        });
        if (!given) lists.push_back(list);
    }
    return lists;
}

std::vector<std::string> items_of(const std::string& option, const std::string& text) {
    std::vector<std::string> items;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');) {
        if (std::find(items.begin(), items.end(), item) != items.end()) {
            throw UsageError(fmt::format("{} '{}': {} is there twice", option, text, item));
        }
        items.push_back(item);
    }
    return items;
}

std::vector<Scheme> schemes_of(const std::string& text) {
    std::vector<Scheme> schemes;
    for (const std::string& name : items_of("--scheme", text)) {
        const auto found = std::find(kSchemeNames.begin(), kSchemeNames.end(), name);
        if (found == kSchemeNames.end()) {
            throw UsageError(
                fmt::format("--scheme '{}': must be of {}", name, fmt::join(kSchemeNames, ", ")));
        }
        schemes.push_back(static_cast<Scheme>(found - kSchemeNames.begin()));
    }
    return schemes;
}

double tick_of(const std::string& text) {
    const double tick = quantity("--tick", text, {{"us", -6}, {"ms", -3}, {"s", 0}});
    if (!(tick >= 1e-6 && tick <= 10)) throw UsageError("--tick must be in [1us, 10s]");
    return tick;
}

bool has(const std::vector<Scheme>& schemes, Scheme scheme) {
    return std::find(schemes.begin(), schemes.end(), scheme) != schemes.end();
}

/// Adds a scheme once for each combination of the values that it depends on.
void add_ticked(Scheme scheme, bool words, const CompareOptions& options, double tick, double feed,
                std::vector<TickedSetting>& ticked) {
    const std::size_t first = ticked.size();
    for (const CoreParameters& setting : options.settings) {
        const TickedSetting one{setting, {scheme, words, tick, feed}};
        const auto same = [&](const TickedSetting& other) {
            return (!one.ticks.has_order() || other.setting.order == setting.order) &&
                   (!words || other.setting.coef_bits == setting.coef_bits);
        };
        if (std::none_of(ticked.begin() + static_cast<std::ptrdiff_t>(first), ticked.end(), same)) {
            ticked.push_back(one);
        }
    }
}

void interpret_schemes(const RawCompareOptions& raw, CompareOptions& options) {
    const std::vector<Scheme> schemes = schemes_of(raw.scheme);
    const bool any = std::any_of(schemes.begin(), schemes.end(), is_ticked);
    if (!any && !(raw.tick.empty() && raw.feed.empty())) {
        throw UsageError("--tick and --feed are for --scheme paper, rk4 and scalar");
    }
    options.schemes = options.sweep.by_move = true;
    for (CoreParameters setting : options.settings) {
        for (const Scheme scheme : {Scheme::kAnchored, Scheme::kPropagated}) {
            if (!has(schemes, scheme)) continue;
            setting.anchor = scheme == Scheme::kAnchored ? 1 : 0;
            options.drawn.push_back(setting);
        }
    }
    const std::string ticks = raw.tick.empty() ? kStandardTick : raw.tick;
    const std::string feeds = raw.feed.empty() ? kStandardFeeds : raw.feed;
    for (const std::string& tick_text : items_of("--tick", ticks)) {
        const double tick = tick_of(tick_text);
        for (const std::string& feed_text : items_of("--feed", feeds)) {
            const double feed = speed("--feed", feed_text);
            for (const Scheme scheme : schemes) {
                if (!is_ticked(scheme)) continue;
                if (scheme == Scheme::kPaper) {
                    add_ticked(scheme, true, options, tick, feed, options.sweep.ticked);
                }
                add_ticked(scheme, false, options, tick, feed, options.sweep.ticked);
            }
        }
    }
}

CurveSet curve_set(const std::string& name) {
    return static_cast<CurveSet>(choice("--curves", name, kCurveSets));
}

}  // namespace

void interpret(const RawCompareOptions& raw, CompareOptions& options) {
    const Options& common = options.common;
    const bool schemes = !raw.scheme.empty();
    options.settings = all_combinations(common.core, lists_of(raw.set, raw.core_given || schemes));
    options.curves = curve_set(raw.curves);
    if (!options.common.file.empty() && raw.curves != RawCompareOptions().curves) {
        throw UsageError("--curves is for a comparison without FILE");
    }
    if (options.common.file.empty() && !options.common.machine.empty()) {
        throw UsageError("--machine is for a comparison with FILE");
    }
    if (schemes) {
        for (const std::string& text : raw.set) {
            if (read_parameter(text).row->value == &CoreParameters::anchor) {
                throw UsageError("--set Anchor: follows --scheme");
            }
        }
        interpret_schemes(raw, options);
    } else if (!raw.tick.empty()) {
        throw UsageError("--tick is for --scheme paper, rk4 and scalar");
    } else {
        options.drawn = options.settings;
    }
    options.sweep.unit_mm = options.common.unit_mm;
    options.sweep.limit = common.error_limit;
    options.sweep.times_segments = single("--segments", raw.segments, 1, 1000);
    options.sweep.samples = single("--samples", raw.samples, 100, 10000000);
    options.sweep.device = device_of(common.device.empty() ? kComparedDevice : common.device);
    options.sweep.quiet = options.common.quiet;
}

void complete_settings(const ref::Program& program, std::vector<CoreParameters>& settings) {
    const bool splines =
        std::any_of(program.moves.begin(), program.moves.end(),
                    [](const ref::Move& move) { return move.kind == ref::Move::Kind::kCubic; });
    for (CoreParameters& setting : settings) {
        setting.aux_axes = program.aux_axes;
        setting.splines = splines ? 1 : 0;
        const std::string reason = ref::why_not_built(setting);
        if (!reason.empty()) {
            throw UsageError(
                fmt::format("there are {}splines, and {}", splines ? "" : "no ", reason));
        }
    }
}

void check_ticked(const ref::Program& program, const CompareOptions& options) {
    if (options.sweep.ticked.empty()) return;
    const std::string name = scheme_name(options.sweep.ticked.front().ticks.scheme);
    for (const ref::Move& move : program.moves) {
        if (move.kind == ref::Move::Kind::kCubic) continue;
        if (options.common.file.empty()) {
            throw UsageError(
                fmt::format("--scheme {} draws splines only: --curves splines or papers", name));
        }
        throw ref::InputError(program.file, move.line,
                              fmt::format("no spline, and --scheme {} draws nothing else", name));
    }
    constexpr double kMost = 1e7;
    for (const TickedSetting& one : options.sweep.ticked) {
        const double ticks = ticks_of(program, one.ticks);
        if (ticks <= kMost) continue;
        throw UsageError(
            fmt::format("--tick {:g}ms at --feed {:g}m/min: {:.2g} ticks, {:g} are "
                        "the most",
                        one.ticks.tick * 1e3, one.ticks.feed * 60e-3, ticks, kMost));
    }
}

}  // namespace curvecore::sysc
